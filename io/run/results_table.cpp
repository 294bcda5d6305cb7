// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/results_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace gyro {
namespace {

constexpr std::int64_t chunk_numbers = 8192;  ///< approximate number of numbers in a chunk of a wide channel

/// Layout with chunks of 1024 rows, or of fewer rows for wide channels, so that a chunk is a small write.
hdf5::Layout layout_of(const Channel& channel) {
  const std::int64_t rows = std::clamp<std::int64_t>(chunk_numbers / channel.columns, 1, 1024);
  // Not compressed, because partly filled chunks are rewritten many times (see hdf5::Layout).
  return {.number = channel.number, .columns = channel.columns, .chunk_rows = rows};
}

std::string path_of(const ResultsGroup& group, const Channel& channel) {
  return group.name + "/" + channel.name;
}

std::size_t row_length(const ResultsGroup& group) {
  std::size_t length = 0;
  for (const Channel& channel : group.channels) length += static_cast<std::size_t>(channel.columns);
  return length;
}

}  // namespace

const char* to_string(Sampling sampling) {
  switch (sampling) {
    case Sampling::instant:
      return "instant";
    case Sampling::mean:
      return "mean";
    case Sampling::sum:
      return "sum";
  }
  throw std::logic_error("unknown sampling");
}

void describe_group(hdf5::File& file, const ResultsGroup& group) {
  for (const GroupNumber& number : group.attributes) file.set_attribute(group.name, number.name, number.value);
}

void describe_dataset(hdf5::Dataset& dataset, const Channel& channel) {
  dataset.set_attribute("units", channel.units);
  dataset.set_attribute("sampling", to_string(channel.sampling));
  dataset.set_attribute("description", channel.description);
}

ResultsTable::ResultsTable(hdf5::File& file, const ResultsGroup& group)
    : group_(group), waiting_(group.channels.size()), row_length_(row_length(group)) {
  for (const Channel& channel : group_.channels) {
    datasets_.push_back(file.create_dataset(path_of(group_, channel), layout_of(channel)));
    describe_dataset(datasets_.back(), channel);
    digests_.emplace_back(channel.number);
  }
}

ResultsTable::ResultsTable(const hdf5::File& file, const ResultsGroup& group, std::int64_t rows,
                           std::vector<RowsDigest> digests)
    : group_(group),
      digests_(std::move(digests)),
      waiting_(group.channels.size()),
      row_length_(row_length(group)),
      rows_(rows) {
  for (const Channel& channel : group_.channels) datasets_.push_back(file.dataset(path_of(group_, channel)));
}

void ResultsTable::append(std::span<const double> row) {
  if (row.size() != row_length_)
    throw std::logic_error(group_.name + ": a row has " + std::to_string(row_length_) + " numbers, not " +
                           std::to_string(row.size()));
  std::size_t begin = 0;
  for (std::size_t c = 0; c < group_.channels.size(); ++c) {
    const auto part = row.subspan(begin, static_cast<std::size_t>(group_.channels[c].columns));
    waiting_[c].insert(waiting_[c].end(), part.begin(), part.end());
    digests_[c].add(part);
    begin += part.size();
  }
  ++waiting_rows_;
  ++rows_;
}

void ResultsTable::flush() {
  if (waiting_rows_ == 0) return;
  for (std::size_t c = 0; c < datasets_.size(); ++c) {
    datasets_[c].append(waiting_[c]);
    datasets_[c].flush();
    waiting_[c].clear();
  }
  waiting_rows_ = 0;
}

GroupMark ResultsTable::mark() const {
  GroupMark mark{.rows = rows_, .digests = {}};
  for (std::size_t c = 0; c < digests_.size(); ++c) mark.digests[group_.channels[c].name] = digests_[c].hex();
  return mark;
}

}  // namespace gyro
