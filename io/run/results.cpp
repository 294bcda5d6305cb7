// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/results.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <algorithm>
#include <stdexcept>

namespace gyro {
namespace {

constexpr std::chrono::seconds flush_interval{5};
constexpr std::size_t rows_kept = 1024;       ///< waiting rows at most: one chunk of a scalar channel
constexpr std::int64_t chunk_numbers = 8192;  ///< about as many numbers in a chunk of a wide channel

/// Chunks of 1024 rows, fewer for wide channels so that a chunk stays a small write.
hdf5::Layout layout_of(const Channel& channel) {
  const std::int64_t rows = std::clamp<std::int64_t>(chunk_numbers / channel.columns, 1, 1024);
  // Not compressed: partly filled chunks are written again and again (see hdf5::Layout).
  return {.number = channel.number, .columns = channel.columns, .chunk_rows = rows};
}

void write_record(hdf5::File& file, const CaseRecord& record) {
  if (!file.contains("/case")) file.create_group("/case");
  file.set_attribute("/case", "title", record.title);
  file.set_attribute("/case", "resolved_yaml", record.resolved_yaml);
  file.set_attribute("/case", "version", record.version);
  file.set_attribute("/case", "git_hash", record.git_hash);
  file.set_attribute("/case", "device", record.device);
  file.set_attribute("/case", "precision", record.precision);
  file.set_attribute("/case", "seed", record.seed);
}

std::vector<Channel> breakage_channels() {
  using hdf5::Number;
  return {{"time", "s"},
          {"mode", "1", 1, Number::uint8},
          {"position", "m", 3},
          {"rock", "1", 1, Number::int32},
          {"i", "1", 1, Number::uint32},
          {"j", "1", 1, Number::uint32},
          {"energy", "J"}};
}

std::vector<Channel> liner_channels(const LinerMap& liner) {
  using hdf5::Number;
  return {{"time", "s"}, {"pressure", "Pa", liner.cells, Number::float32}, {"work", "J", liner.cells, Number::float32}};
}

int triangles_of(const LinerMap& liner) {
  return static_cast<int>(liner.corners.size() / 9);
}

std::vector<Channel> triangle_channels(const LinerMap& liner) {
  using hdf5::Number;
  const int count = triangles_of(liner);
  std::vector<Channel> channels{
      {"time", "s"}, {"pressure", "Pa", count, Number::float32}, {"work", "J", count, Number::float32}};
  if (liner.wear) channels.push_back({"wear", "m", count, Number::float32});
  return channels;
}

/// Where the cells of a liner are; the corners lie beside the group of the triangles' tables.
void write_grid(hdf5::File& file, const std::string& group, const LinerMap& liner) {
  const auto write = [&](const char* name, const std::vector<double>& numbers, const char* units) {
    if (numbers.empty()) return;
    file.write_numbers(group + "/" + name, numbers);
    file.dataset(group + "/" + name).set_attribute("units", units);
  };
  write("heights", liner.heights, "m");
  write("azimuths", liner.azimuths, "rad");
  write("area", liner.area, "m2");
  write("corners", liner.corners, "m");
}

/// Groups and channels of the tables, in the order in which they are made.
std::vector<std::pair<std::string, std::vector<Channel>>> tables_of(const ResultsContent& content) {
  using hdf5::Number;
  std::vector<std::pair<std::string, std::vector<Channel>>> tables{
      {"/series", content.series}, {"/ledger", content.ledger}, {"/performance", content.performance}};
  if (content.breakage) tables.emplace_back("/breakage", breakage_channels());
  if (!content.product_sizes.empty()) {
    std::vector<Channel> curve{{"time", "s"}, {"passing", "1", static_cast<int>(content.product_sizes.size())}};
    curve.insert(curve.end(), content.curve_figures.begin(), content.curve_figures.end());
    for (const char* group : {"/product", "/holdup"}) tables.emplace_back(group, curve);
  }
  for (const LinerMap& liner : content.liners) {
    const std::string group = "/liners/" + liner.wall;
    tables.emplace_back(group, liner_channels(liner));
    if (!liner.corners.empty()) tables.emplace_back(group + "/triangles", triangle_channels(liner));
  }
  return tables;
}

/// @throws BadInput unless a file has the tables of a content, with the rows to keep
void require_rows(const std::filesystem::path& path, const ResultsContent& content, const ResultsRows& keep) {
  const auto refuse = [&](const std::string& why) {
    return BadInput(path.string() + ": " + why + "; restore the file that belongs to the checkpoint, or use " +
                    "--overwrite to start the run again");
  };
  if (!std::filesystem::exists(path)) throw refuse("is missing");
  const hdf5::File file = hdf5::File::open(path);
  for (const auto& [group, channels] : tables_of(content)) {
    for (const Channel& channel : channels) {
      const std::string name = group + "/" + channel.name;
      const auto rows = keep.find(group);
      if (rows == keep.end() || !file.contains(name)) throw refuse("has no " + name);
      const hdf5::Dataset dataset = file.dataset(name);
      if (dataset.columns() != channel.columns) throw refuse("has another form of " + name);
      if (dataset.rows() < rows->second)
        throw refuse("has " + std::to_string(dataset.rows()) + " rows of " + name + ", not " +
                     std::to_string(rows->second));
    }
  }
  for (const std::string& name : file.children("/series")) {
    const auto is_it = [&](const Channel& channel) { return channel.name == name; };
    if (std::none_of(content.series.begin(), content.series.end(), is_it))
      throw refuse("has /series/" + name + ", which would end here");
  }
}

/// Drops all rows behind those to keep, in a copy that then takes the file's place.
void shorten(const std::filesystem::path& path, const ResultsContent& content, const ResultsRows& keep) {
  const std::filesystem::path part = path.string() + ".tmp";
  try {
    std::error_code error;
    std::filesystem::copy_file(path, part, std::filesystem::copy_options::overwrite_existing, error);
    if (error) throw OutputError(path.string() + ": cannot copy: " + error.message());
    hdf5::File file = hdf5::File::modify(part);
    for (const auto& [group, channels] : tables_of(content))
      for (const Channel& channel : channels) {
        hdf5::Dataset dataset = file.dataset(group + "/" + channel.name);
        if (dataset.rows() > keep.at(group)) dataset.truncate(keep.at(group));
      }
    write_record(file, content.record);
    file.close();
    put_in_place(path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

}  // namespace

ResultsTable::ResultsTable(hdf5::File& file, const std::string& group, std::vector<Channel> channels)
    : group_(group), channels_(std::move(channels)), waiting_(channels_.size()) {
  for (const Channel& channel : channels_) {
    datasets_.push_back(file.create_dataset(group + "/" + channel.name, layout_of(channel)));
    datasets_.back().set_attribute("units", channel.units);
    row_length_ += static_cast<std::size_t>(channel.columns);
  }
}

void ResultsTable::append(std::span<const double> row) {
  if (row.size() != row_length_)
    throw std::logic_error(group_ + ": a row has " + std::to_string(row_length_) + " numbers, not " +
                           std::to_string(row.size()));
  std::size_t begin = 0;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const auto part = row.subspan(begin, static_cast<std::size_t>(channels_[c].columns));
    waiting_[c].insert(waiting_[c].end(), part.begin(), part.end());
    begin += part.size();
  }
  ++waiting_rows_;
  ++rows_;
}

void ResultsTable::flush() {
  if (waiting_rows_ == 0) return;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    datasets_[c].append(waiting_[c]);
    datasets_[c].flush();
    waiting_[c].clear();
  }
  waiting_rows_ = 0;
}

ResultsTable::ResultsTable(const hdf5::File& file, const std::string& group, std::vector<Channel> channels,
                           std::int64_t rows)
    : group_(group), channels_(std::move(channels)), waiting_(channels_.size()), rows_(rows) {
  for (const Channel& channel : channels_) {
    datasets_.push_back(file.dataset(group + "/" + channel.name));
    row_length_ += static_cast<std::size_t>(channel.columns);
  }
}

ResultsFile::ResultsFile(const std::filesystem::path& path, const ResultsContent& content)
    : path_(path), file_(hdf5::File::create(path)), last_flush_(std::chrono::steady_clock::now()) {
  write_record(*file_, content.record);
  for (const auto& [group, channels] : tables_of(content)) {
    file_->create_group(group);
    if (!channels.empty()) tables_.emplace(group, ResultsTable(*file_, group, channels));
  }
  if (!content.product_sizes.empty()) {
    for (const std::string group : {"/product", "/holdup"}) {
      file_->write_numbers(group + "/sizes", content.product_sizes);
      file_->dataset(group + "/sizes").set_attribute("units", "m");
    }
  }
  for (const LinerMap& liner : content.liners) write_grid(*file_, "/liners/" + liner.wall, liner);
  file_->start_appending();
}

ResultsFile::ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsRows& keep)
    : path_(path), last_flush_(std::chrono::steady_clock::now()) {
  require_rows(path, content, keep);
  shorten(path, content, keep);
  file_ = hdf5::File::modify(path);
  for (const auto& [group, channels] : tables_of(content))
    if (!channels.empty()) tables_.emplace(group, ResultsTable(*file_, group, channels, keep.at(group)));
  file_->start_appending();
}

ResultsFile::~ResultsFile() {
  try {
    close();
  } catch (const std::exception&) {
    // An error that matters is on its way already: this runs only when close() was not reached.
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

void ResultsFile::append_series(std::span<const double> row) {
  append("/series", row);
}

void ResultsFile::append_ledger(std::span<const double> row) {
  append("/ledger", row);
}

void ResultsFile::append_performance(std::span<const double> row) {
  append("/performance", row);
}

void ResultsFile::append_breakages(std::span<const Breakage> breakages) {
  for (const Breakage& b : breakages) {
    const double row[] = {b.time,
                          static_cast<double>(b.mode),
                          b.position.x,
                          b.position.y,
                          b.position.z,
                          static_cast<double>(b.rock),
                          static_cast<double>(b.i),
                          static_cast<double>(b.j),
                          b.energy};
    append("/breakage", row);
  }
}

void ResultsFile::append_curve(const std::string& group, std::initializer_list<std::span<const double>> parts) {
  std::vector<double> row;
  for (const auto& part : parts) row.insert(row.end(), part.begin(), part.end());
  append(group, row);
}

void ResultsFile::append_product(double time, std::span<const double> passing, std::span<const double> figures) {
  append_curve("/product", {{&time, 1}, passing, figures});
}

void ResultsFile::append_holdup(double time, std::span<const double> passing, std::span<const double> figures) {
  append_curve("/holdup", {{&time, 1}, passing, figures});
}

void ResultsFile::append_liner(const std::string& wall, double time, std::span<const double> pressure,
                               std::span<const double> work) {
  std::vector<double> row{time};
  row.insert(row.end(), pressure.begin(), pressure.end());
  row.insert(row.end(), work.begin(), work.end());
  append("/liners/" + wall, row);
}

void ResultsFile::append_triangles(const std::string& wall, double time, std::span<const double> pressure,
                                   std::span<const double> work, std::span<const double> wear) {
  std::vector<double> row{time};
  for (const auto& part : {pressure, work, wear}) row.insert(row.end(), part.begin(), part.end());
  append("/liners/" + wall + "/triangles", row);
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

ResultsRows ResultsFile::rows() const {
  ResultsRows rows;
  for (const auto& [group, table] : tables_) rows[group] = table.rows();
  return rows;
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
