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

/// Digest of the first rows of a dataset. All rows are read: once rows are appended, the library waits for ever for a
/// damaged block to become sound.
RowsDigest digest_of_rows(const hdf5::Dataset& dataset, const Channel& channel, std::int64_t keep) {
  constexpr std::int64_t numbers_at_once = 1 << 20;
  const std::int64_t rows_at_once = std::max<std::int64_t>(1, numbers_at_once / channel.columns);
  RowsDigest digest(channel.number);
  for (std::int64_t row = 0, end = 0; row < dataset.rows(); row = end) {
    end = std::min(row + rows_at_once, row < keep ? keep : dataset.rows());
    const std::vector<double> numbers = dataset.read_rows(row, end - row);
    if (row < keep) digest.add(numbers);
  }
  return digest;
}

/// @returns the digest of the rows to keep
RowsDigest require_channel(const std::filesystem::path& path, const hdf5::File& file, const std::string& name,
                           const Channel& channel, const GroupMark& keep) {
  if (!file.contains(name)) throw refused(path, "has no " + name);
  const auto digest = keep.digests.find(channel.name);
  if (digest == keep.digests.end()) throw refused(path, "has " + name + ", of which the checkpoint has no digest");
  const hdf5::Dataset dataset = file.dataset(name);
  if (dataset.columns() != channel.columns || dataset.number() != channel.number)
    throw refused(path, "has a different form of " + name);
  if (dataset.rows() < keep.rows)
    throw refused(path,
                  "has " + std::to_string(dataset.rows()) + " rows of " + name + ", not " + std::to_string(keep.rows));
  if (dataset.string_attribute("units") != channel.units) throw refused(path, "has another unit of " + name);
  RowsDigest found = digest_of_rows(dataset, channel, keep.rows);
  if (found.hex() != digest->second)
    throw refused(path, "is damaged: the numbers of " + name + " are not those that the run wrote");
  return found;
}

using Digests = std::map<std::string, std::vector<RowsDigest>>;  ///< by group, one a channel

/// @throws BadInput unless a file has the groups of a content, with the rows to keep, and no other datasets in them
Digests require_rows(const std::filesystem::path& path, const hdf5::File& file, const ResultsContent& content,
                     const ResultsMarks& keep) {
  Digests digests;
  for (const ResultsGroup& group : content.groups) {
    const auto mark = keep.find(group.name);
    for (const Channel& channel : group.channels)
      digests[group.name].push_back(require_channel(path, file, group.name + "/" + channel.name, channel,
                                                    mark == keep.end() ? GroupMark{} : mark->second));
    for (const std::string& child : file.children(group.name))
      if (!is_in(content, group, child))
        throw refused(path, "has " + group.name + "/" + child + ", which this run does not write");
  }
  return digests;
}

/// @throws BadInput unless a file has the same numbers in the datasets that are written once
void require_fixed(const std::filesystem::path& path, const hdf5::File& file, const ResultsContent& content) {
  for (const FixedNumbers& fixed : content.fixed)
    if (!file.contains(fixed.name) || !same_numbers(file.dataset(fixed.name).read(), fixed))
      throw refused(path, "has different numbers in " + fixed.name);
}

/// Drops all rows behind those to keep.
void shorten(hdf5::File& file, const ResultsContent& content, const ResultsMarks& keep) {
  for (const ResultsGroup& group : content.groups)
    for (const Channel& channel : group.channels) {
      hdf5::Dataset dataset = file.dataset(group.name + "/" + channel.name);
      if (dataset.rows() > keep.at(group.name).rows) dataset.truncate(keep.at(group.name).rows);
    }
}

void copy_results(const std::filesystem::path& path, const std::filesystem::path& copy) {
  if (!std::filesystem::exists(path)) throw refused(path, "is missing");
  std::error_code error;
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw OutputError(path.string() + ": cannot copy: " + error.message());
}

struct OpenCopy {
  hdf5::File file;
  Digests digests;
};

/// Opens the copy of a results file to change it. @throws BadInput for a damaged file, or one without the rows to keep
OpenCopy open_copy(const std::filesystem::path& path, const std::filesystem::path& copy, const ResultsContent& content,
                   const ResultsMarks& keep) {
  try {
    OpenCopy open{hdf5::File::modify(copy, path), {}};
    open.digests = require_rows(path, open.file, content, keep);
    require_fixed(path, open.file, content);
    return open;
  } catch (const OutputError& problem) {
    throw refused(path, std::string("is damaged (") + problem.what() + ")");
  }
}

}  // namespace

// All changes are made to a copy, which takes the file's place when it is ready for new rows: a kill at any moment
// leaves one file or the other.
ResultsFile::ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsMarks& keep)
    : path_(path), last_flush_(std::chrono::steady_clock::now()) {
  const std::filesystem::path copy = path.string() + ".tmp";
  try {
    copy_results(path, copy);
    OpenCopy open = open_copy(path, copy, content, keep);
    file_ = std::move(open.file);
    shorten(*file_, content, keep);
    write_record(*file_, content.record);
    for (const ResultsGroup& group : content.groups) {
      describe_group(*file_, group);
      tables_.emplace(group.name,
                      ResultsTable(*file_, group, keep.at(group.name).rows, std::move(open.digests.at(group.name))));
    }
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
