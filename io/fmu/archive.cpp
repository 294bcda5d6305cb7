// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fmu/archive.hpp"

#include "core/base/errors.hpp"

#include <sys/stat.h>
#include <zip.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_bytes = std::uint64_t{1} << 30;  ///< of all unpacked entries; no real FMU is larger
constexpr std::int64_t max_entries = 100'000;

/// Reason why an entry must not be unpacked; empty if it may be unpacked.
std::string danger_of(const std::string& name, bool link) {
  if (link) return "is a link";
  if (name.empty() || name.front() == '/') return "has an absolute path";
  if (name.size() > 1 && name[1] == ':') return "has an absolute path";
  if (name.find('\\') != std::string::npos) return "has a backslash in its path";
  for (const fs::path& part : fs::path(name))
    if (part == "..") return "leaves the archive's folder";
  return {};
}

bool is_link(zip_t* archive, zip_uint64_t entry) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(archive, entry, 0, &system, &attributes) != 0) return true;
  return system == ZIP_OPSYS_UNIX && S_ISLNK(attributes >> 16);
}

}  // namespace

struct Archive::Handle {
  fs::path file;
  zip_t* zip = nullptr;
  ~Handle() {
    if (zip != nullptr) zip_discard(zip);
  }
  [[noreturn]] void refuse(const std::string& problem) const {
    const bool complete = problem.find("; ") != std::string::npos;
    throw BadInput(file.string() + ": " + problem + (complete ? "" : "; give an intact FMU"));
  }
};

Archive::Archive(const fs::path& file) : handle_(std::make_unique<Handle>()) {
  handle_->file = file;
  int code = 0;
  handle_->zip = zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  if (handle_->zip == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    handle_->refuse("is not a readable zip archive (" + reason + "); give an FMU");
  }
  const zip_int64_t count = zip_get_num_entries(handle_->zip, 0);
  if (count > max_entries) handle_->refuse("has too many entries; at most 100000 are read");
  std::uint64_t bytes = 0;
  std::set<std::string> seen;
  for (zip_int64_t k = 0; k < count; ++k) {
    const auto entry = static_cast<zip_uint64_t>(k);
    zip_stat_t stat;
    if (zip_stat_index(handle_->zip, entry, 0, &stat) != 0) handle_->refuse("is damaged");
    const std::string name = stat.name;
    if (const std::string danger = danger_of(name, is_link(handle_->zip, entry)); !danger.empty())
      handle_->refuse("entry \"" + name + "\" " + danger + "; only plain files inside the FMU's folder are allowed");
    if (!seen.insert(fs::path(name).lexically_normal().string()).second)
      handle_->refuse("entry \"" + name + "\" occurs twice");
    if (stat.encryption_method != ZIP_EM_NONE) handle_->refuse("entry \"" + name + "\" is encrypted");
    bytes += stat.size;
    if (stat.size > max_bytes || bytes > max_bytes) handle_->refuse("is larger than 1 GiB when unpacked");
    if (name.back() != '/') names_.push_back(name);
  }
}

Archive::~Archive() = default;
Archive::Archive(Archive&&) noexcept = default;
Archive& Archive::operator=(Archive&&) noexcept = default;

bool Archive::contains(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::string Archive::read(const std::string& name) const {
  zip_stat_t stat;
  if (zip_stat(handle_->zip, name.c_str(), 0, &stat) != 0) handle_->refuse("has no " + name);
  zip_file_t* entry = zip_fopen(handle_->zip, name.c_str(), 0);
  if (entry == nullptr) handle_->refuse(name + " cannot be read: " + zip_strerror(handle_->zip));
  std::string content(stat.size, '\0');
  const zip_int64_t got = zip_fread(entry, content.data(), content.size());
  char beyond = 0;  // a byte beyond the declared size is an error; reading to the end also checks the checksum
  const bool whole = got == static_cast<zip_int64_t>(content.size()) && zip_fread(entry, &beyond, 1) == 0;
  if (zip_fclose(entry) != 0 || !whole) handle_->refuse(name + " is damaged");
  return content;
}

void Archive::unpack(const std::string& prefix, const fs::path& folder) const {
  for (const std::string& name : names_) {
    if (!name.starts_with(prefix)) continue;
    const fs::path target = folder / name;
    std::error_code failed;
    fs::create_directories(target.parent_path(), failed);
    const std::string content = read(name);
    std::ofstream stream(target, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) throw OutputError(target.string() + ": cannot be written (FMUs are unpacked below TMPDIR)");
  }
}

TemporaryFolder::TemporaryFolder() {
  const char* where = std::getenv("TMPDIR");
  std::string name = (fs::path(where != nullptr && *where != '\0' ? where : "/tmp") / "gyrosim-fmu-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw OutputError(name + ": this folder cannot be made");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void write_archive(const fs::path& file, const std::vector<std::pair<std::string, std::string>>& entries) {
  const auto fail = [&](const char* reason) { throw OutputError(file.string() + ": cannot be written: " + reason); };
  int code = 0;
  zip_t* zip = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (zip == nullptr) fail("the file cannot be opened");
  constexpr std::time_t first_of_january_1980 = 315532800;  // the earliest time of a zip; used for all entries
  for (const auto& [name, content] : entries) {
    zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
    const zip_int64_t entry = source == nullptr ? -1 : zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (entry < 0) {
      if (source != nullptr) zip_source_free(source);
      zip_discard(zip);
      fail("out of memory");
    }
    zip_file_set_mtime(zip, static_cast<zip_uint64_t>(entry), first_of_january_1980, 0);
  }
  if (zip_close(zip) == 0) return;
  const std::string reason = zip_strerror(zip);
  zip_discard(zip);
  fail(reason.c_str());
}

}  // namespace gyro
