// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fmu/export.hpp"

#include "core/base/errors.hpp"
#include "io/files/digest.hpp"
#include "io/files/read_file.hpp"
#include "io/fmu/archive.hpp"
#include "io/fmu/model_description.hpp"
#include "mbd/fmi/drive_slave.hpp"

#include <cstdint>
#include <cstdio>

namespace gyro {
namespace {

constexpr const char* identifier = "gyro_drivetrain";

/// A GUID that is computed from everything that determines the behaviour of the FMU.
std::string guid_of(const std::string& content) {
  std::string text = digest_of(content);
  for (const std::size_t dash : {20, 16, 12, 8}) text.insert(dash, "-");
  return "{" + text + "}";
}

std::string library_of(const std::filesystem::path& file) {
  try {
    return read_file(file);
  } catch (const UnreadableFile& unreadable) {
    throw OutputError(std::string(unreadable.what()) + " (it is built with the program and is a part of every FMU)");
  }
}

}  // namespace

void export_drive(const DriveExport& what, const std::filesystem::path& file) {
  const DriveSlave slave(what.drive);
  const std::string parameters = drive_text(what.drive), library = library_of(what.library);
  ModelIdentity identity{what.title, identifier, {}, what.tool, what.stop_time, what.step};
  identity.guid = guid_of(write_model_description(identity, slave.variables()) + parameters + library);
  write_archive(file, {{"modelDescription.xml", write_model_description(identity, slave.variables())},
                       {"resources/drivetrain.txt", "guid " + identity.guid + "\n" + parameters},
                       {std::string("binaries/linux64/") + identifier + ".so", library}});
}

}  // namespace gyro
