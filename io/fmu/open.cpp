// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/fmu/archive.hpp"
#include "io/fmu/drive_fmu.hpp"

#include <set>

namespace gyro {
namespace {

constexpr const char* platform = "binaries/linux64/";

std::string library_in_archive(const std::string& identifier) {
  return platform + identifier + ".so";
}

/// file: URI (RFC 8089) of an absolute path.
std::string uri_of(const std::filesystem::path& path) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || std::string_view("/-_.~").find(c) != std::string_view::npos)
      uri += c;
    else
      uri += std::string{'%', digits[byte >> 4], digits[byte & 15]};
  }
  return uri;
}

}  // namespace

ModelDescription read_fmu(const std::filesystem::path& file) {
  const Archive archive(file);
  try {
    ModelDescription model = read_model_description(archive.read("modelDescription.xml"));
    if (archive.contains(library_in_archive(model.identifier))) return model;
    std::set<std::string> platforms;
    for (const std::string& name : archive.names())
      if (name.starts_with("binaries/")) platforms.insert(name.substr(9, name.find('/', 9) - 9));
    std::string list;
    for (const std::string& name : platforms) list += (list.empty() ? "" : ", ") + name;
    throw BadInput("has no " + library_in_archive(model.identifier) + " but binaries for " +
                   (list.empty() ? "no platform" : list) + "; an FMU with binaries for linux64 is needed");
  } catch (const BadInput& problem) {
    const std::string text = problem.what(), begin = file.string() + ": ";
    throw BadInput(text.starts_with(begin) ? text : begin + text);
  }
}

std::unique_ptr<Drive> open_drive(const DriveFmu& fmu, std::chrono::milliseconds patience) {
  const auto folder = std::make_shared<TemporaryFolder>();
  const Archive archive(fmu.file);
  archive.unpack(platform, folder->path());
  archive.unpack("resources/", folder->path());
  try {
    return std::make_unique<FmuProcess>(FmuSetup{.library = folder->path() / library_in_archive(fmu.identifier),
                                                 .name = fmu.file.filename().string(),
                                                 .guid = fmu.guid,
                                                 .resources = uri_of(folder->path() / "resources"),
                                                 .state = fmu.state,
                                                 .serialisation = fmu.serialisation,
                                                 .links = fmu.links,
                                                 .history = fmu.history,
                                                 .starts = fmu.starts,
                                                 .files = folder},
                                        patience);
  } catch (const BadInput& problem) {
    throw BadInput(fmu.file.string() + ": " + problem.what() + "; give an FMI 2.0 co-simulation FMU that starts");
  }
}

}  // namespace gyro
