// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// A zip archive, opened for reading. Its entries are checked when it is opened: absolute paths, `..`, backslashes,
/// links, duplicates, encrypted entries and more than 1 GiB in total are refused.
class Archive {
 public:
  /// @throws BadInput for a file that is not such an archive
  explicit Archive(const std::filesystem::path& file);
  ~Archive();
  Archive(Archive&&) noexcept;
  Archive& operator=(Archive&&) noexcept;

  const std::vector<std::string>& names() const { return names_; }  ///< names of the files
  bool contains(const std::string& name) const;
  /// Content of a file. @throws BadInput if it does not exist or is damaged
  std::string read(const std::string& name) const;
  /// Writes the files whose names begin with a prefix into a folder, with their paths. @throws BadInput, OutputError
  void unpack(const std::string& prefix, const std::filesystem::path& folder) const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
  std::vector<std::string> names_;
};

/// A new folder that exists as long as this object.
class TemporaryFolder {
 public:
  /// Below TMPDIR, or /tmp. @throws OutputError
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes a zip archive of entries (name, content). The same entries give the same bytes. @throws OutputError
void write_archive(const std::filesystem::path& file, const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace gyro
