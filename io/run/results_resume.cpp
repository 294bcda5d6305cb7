// SPDX-License-Identifier: GPL-3.0-or-later
// Checks results.h5 of a run that is resumed, cuts it to the rows of the checkpoint, and opens it for new rows.
#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/results.hpp"

#include <algorithm>

namespace gyro {
namespace {

BadInput refused(const std::filesystem::path& path, const std::string& why) {
  return BadInput(path.string() + ": " + why +
                  "; restore the file that belongs to the checkpoint, or use --overwrite to start the run again");
}

/// Whether a child of a group is one of the groups or datasets of the content.
bool is_in(const ResultsContent& content, const ResultsGroup& group, const std::string& child) {
  const std::string path = group.name + "/" + child;
  return std::ranges::any_of(group.channels, [&](const Channel& channel) { return channel.name == child; }) ||
         std::ranges::any_of(content.fixed, [&](const FixedNumbers& fixed) { return fixed.name == path; }) ||
         std::ranges::any_of(content.groups, [&](const ResultsGroup& other) { return other.name == path; });
}

/// Whether numbers that were read are those of a dataset, in the precision of the file.
bool same_numbers(const std::vector<double>& read, const FixedNumbers& fixed) {
  const auto stored = [&](double number) {
    return fixed.channel.number == hdf5::Number::float32 ? static_cast<double>(static_cast<float>(number)) : number;
  };
  return std::ranges::equal(read, fixed.numbers, {}, {}, stored);
}

void require_channels(const std::filesystem::path& path, const hdf5::File& file, const ResultsGroup& group,
                      const ResultsRows& keep) {
  for (const Channel& channel : group.channels) {
    const std::string name = group.name + "/" + channel.name;
    const auto rows = keep.find(group.name);
    if (rows == keep.end() || !file.contains(name)) throw refused(path, "has no " + name);
    const hdf5::Dataset dataset = file.dataset(name);
    if (dataset.columns() != channel.columns) throw refused(path, "has a different number of columns in " + name);
    if (dataset.rows() < rows->second)
      throw refused(
          path, "has " + std::to_string(dataset.rows()) + " rows of " + name + ", not " + std::to_string(rows->second));
    // All numbers are read now: after rows are appended, the library would wait for ever for a damaged block.
    if (dataset.string_attribute("units") != channel.units) throw refused(path, "has another unit of " + name);
    dataset.read();
  }
}

/// @throws BadInput unless a file has the groups of the content, with the rows to keep and without other datasets
void require_rows(const std::filesystem::path& path, const hdf5::File& file, const ResultsContent& content,
                  const ResultsRows& keep) {
  for (const ResultsGroup& group : content.groups) {
    require_channels(path, file, group, keep);
    for (const std::string& child : file.children(group.name))
      if (!is_in(content, group, child))
        throw refused(path, "has " + group.name + "/" + child + ", which this run does not write");
  }
}

/// @throws BadInput unless a file has the same numbers in the datasets that are written once
void require_fixed(const std::filesystem::path& path, const hdf5::File& file, const ResultsContent& content) {
  for (const FixedNumbers& fixed : content.fixed)
    if (!file.contains(fixed.name) || !same_numbers(file.dataset(fixed.name).read(), fixed))
      throw refused(path, "has different numbers in " + fixed.name);
}

/// Removes all rows after those to keep.
void shorten(hdf5::File& file, const ResultsContent& content, const ResultsRows& keep) {
  for (const ResultsGroup& group : content.groups)
    for (const Channel& channel : group.channels) {
      hdf5::Dataset dataset = file.dataset(group.name + "/" + channel.name);
      if (dataset.rows() > keep.at(group.name)) dataset.truncate(keep.at(group.name));
    }
}

void copy_results(const std::filesystem::path& path, const std::filesystem::path& copy) {
  if (!std::filesystem::exists(path)) throw refused(path, "is missing");
  std::error_code error;
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw OutputError(path.string() + ": cannot copy: " + error.message());
}

/// Opens the copy of a results file for changes. @throws BadInput for a damaged file, or one without the rows to keep
hdf5::File open_copy(const std::filesystem::path& path, const std::filesystem::path& copy,
                     const ResultsContent& content, const ResultsRows& keep) {
  try {
    hdf5::File file = hdf5::File::modify(copy, path);
    require_rows(path, file, content, keep);
    require_fixed(path, file, content);
    return file;
  } catch (const OutputError& problem) {
    throw refused(path, std::string("is damaged (") + problem.what() + ")");
  }
}

}  // namespace

// All changes are made to a copy, which replaces the file when it is ready for new rows. If the process is killed at
// any time, either the old or the new file remains.
ResultsFile::ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsRows& keep)
    : path_(path), last_flush_(std::chrono::steady_clock::now()) {
  const std::filesystem::path copy = path.string() + ".tmp";
  try {
    copy_results(path, copy);
    file_ = open_copy(path, copy, content, keep);
    shorten(*file_, content, keep);
    write_record(*file_, content.record);
    for (const ResultsGroup& group : content.groups)
      tables_.emplace(group.name, ResultsTable(*file_, group, keep.at(group.name)));
    file_->start_appending();
    put_in_place(path);
  } catch (...) {
    abandon();
    std::error_code ignored;
    std::filesystem::remove(copy, ignored);
    throw;
  }
}

}  // namespace gyro
