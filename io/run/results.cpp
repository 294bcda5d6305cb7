// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/results.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <stdexcept>

namespace gyro {
namespace {

constexpr std::chrono::seconds flush_interval{5};
constexpr std::size_t rows_kept = 1024;  ///< largest number of waiting rows: one chunk of a scalar channel

}  // namespace

ResultsFile::ResultsFile(const std::filesystem::path& path, const ResultsContent& content)
    : path_(path), file_(hdf5::File::create(path)), last_flush_(std::chrono::steady_clock::now()) {
  write_record(*file_, content.record);
  for (const ResultsGroup& group : content.groups) {
    file_->create_group(group.name);
    describe_group(*file_, group);
    tables_.emplace(group.name, ResultsTable(*file_, group));
  }
  for (const FixedNumbers& fixed : content.fixed) {
    file_->write_numbers(fixed.name, fixed.numbers);
    hdf5::Dataset dataset = file_->dataset(fixed.name);
    describe_dataset(dataset, fixed.channel);
  }
  file_->start_appending();
}

ResultsFile::~ResultsFile() {
  try {
    close();
  } catch (const std::exception&) {
    // close() was not called because of an earlier error, and that error is the one to report.
  }
}

void ResultsFile::append(const std::string& group, std::span<const double> row) {
  if (!file_) throw OutputError("results.h5 is closed");
  const auto table = tables_.find(group);
  if (table == tables_.end()) throw std::logic_error("results.h5 was made without " + group);
  table->second.append(row);
  const bool due = std::chrono::steady_clock::now() - last_flush_ >= flush_interval;
  if (due || table->second.waiting_rows() >= rows_kept) flush();
}

void ResultsFile::flush() {
  try {
    for (auto& [group, table] : tables_) table.flush();
  } catch (...) {
    abandon();  // a second try would add the same rows again
    throw;
  }
  last_flush_ = std::chrono::steady_clock::now();
}

void ResultsFile::sync() {
  flush();
  sync_file(path_);
}

ResultsMarks ResultsFile::marks() const {
  ResultsMarks marks;
  for (const auto& [group, table] : tables_) marks[group] = table.mark();
  return marks;
}

void ResultsFile::close() {
  if (!file_) return;
  flush();
  tables_.clear();
  hdf5::File file = std::move(*file_);
  file_.reset();
  file.close();
}

void ResultsFile::abandon() {
  tables_.clear();
  file_.reset();
}

}  // namespace gyro
