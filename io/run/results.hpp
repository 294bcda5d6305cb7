// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "io/hdf5/hdf5.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// One quantity of a table of results.h5: a dataset of its own with attribute `units`.
struct Channel {
  std::string name;
  std::string units;  ///< as in "rad/s"; "1" for a pure number
  int columns = 1;
  hdf5::Number number = hdf5::Number::float64;
};

/// Datasets of one group that grow together, a row at a time. Rows wait in memory until written.
class ResultsTable {
 public:
  /// Makes the datasets.
  ResultsTable(hdf5::File& file, const std::string& group, std::vector<Channel> channels);
  /// Goes on with datasets that have `rows` rows.
  ResultsTable(const hdf5::File& file, const std::string& group, std::vector<Channel> channels, std::int64_t rows);
  /// @param row the channels' values one after the other, as many as all their columns
  void append(std::span<const double> row);
  /// Hands waiting rows to the operating system.
  void flush();
  std::size_t waiting_rows() const { return waiting_rows_; }
  std::int64_t rows() const { return rows_; }  ///< written and waiting

 private:
  std::string group_;
  std::vector<Channel> channels_;
  std::vector<hdf5::Dataset> datasets_;
  std::vector<std::vector<double>> waiting_;  ///< one buffer a channel
  std::size_t row_length_ = 0, waiting_rows_ = 0;
  std::int64_t rows_ = 0;
};

/// Attributes of /case: what made the run.
struct CaseRecord {
  std::string title;
  std::string resolved_yaml;  ///< the case with defaults and --set applied
  std::string version, git_hash;
  std::string device;     ///< "cpu" or the name of the GPU
  std::string precision;  ///< "mixed" or "double"
  std::uint64_t seed = 0;
};

/// Pressure and work maps of one liner: unrolled cells (rows x sectors, a row of sectors after the other),
/// and triangles.
struct LinerMap {
  std::string wall;
  int cells;
  std::vector<double> heights = {}, azimuths = {};  ///< edges of the cells, in the wall's frame [m], [rad]
  std::vector<double> area = {};                    ///< of the cells [m2]
  std::vector<double> corners = {};                 ///< of the triangles, nine numbers each [m]; empty: no triangles
  bool wear = false;                                ///< triangles have a depth worn
};

/// What results.h5 holds; a list that is empty is not written at all.
struct ResultsContent {
  CaseRecord record;
  std::vector<Channel> series, ledger, performance;  ///< put `time` first
  bool breakage = false;                             ///< the scene has bonds
  std::vector<double> product_sizes;                 ///< sieve openings, ascending [m]; empty: no product
  std::vector<Channel> curve_figures;                ///< of each curve of /product and /holdup, beside time and passing
  std::vector<LinerMap> liners;
};

/// How far the tables of results.h5 have come: rows by group, as {"/series", 120}.
using ResultsRows = std::map<std::string, std::int64_t>;

/// results.h5 of a run: /case, /series, /ledger, /performance, /breakage, /product, /holdup, /liners. Rows are
/// written about every 5 s of wall clock and when the file closes. Readable while it grows and after
/// the process was killed; then the datasets of a group may differ by the last few rows.
/// @throws OutputError on any failure to write
class ResultsFile {
 public:
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content);
  /// Goes on with the file of a run that had come to `keep`; later rows are dropped. A kill in between leaves
  /// the file as it was. @throws BadInput for a file with less or other content
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsRows& keep);
  /// Closes without reporting failures; call close() on the normal way out.
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  void append_series(std::span<const double> row);
  void append_ledger(std::span<const double> row);
  void append_performance(std::span<const double> row);
  /// Datasets time, mode (1 tension, 2 shear), position (n x 3), rock, i, j (particle ids), energy.
  void append_breakages(std::span<const Breakage> breakages);
  /// Cumulative passing at `time`, one fraction of the product's mass a sieve: datasets time, passing (n x sieves),
  /// and the figures that the content names.
  void append_product(double time, std::span<const double> passing, std::span<const double> figures = {});
  /// The same of what the chamber holds.
  void append_holdup(double time, std::span<const double> passing, std::span<const double> figures = {});
  /// Maps of one liner at `time`, one value a cell: datasets time, pressure [Pa], work [J].
  void append_liner(const std::string& wall, double time, std::span<const double> pressure,
                    std::span<const double> work);
  /// The same by triangle, from the start to `time`, written once: group triangles of the liner.
  /// @param wear  depth worn [m]; empty unless LinerMap::wear
  void append_triangles(const std::string& wall, double time, std::span<const double> pressure,
                        std::span<const double> work, std::span<const double> wear);
  /// Hands every waiting row to the operating system.
  void flush();
  /// Waits until the disk has every row.
  void sync();
  ResultsRows rows() const;
  /// Writes what waits and closes; nothing can be appended afterwards.
  void close();

 private:
  void append(const std::string& group, std::span<const double> row);
  void append_curve(const std::string& group, std::initializer_list<std::span<const double>> parts);
  void abandon();

  std::filesystem::path path_;
  std::optional<hdf5::File> file_;
  std::map<std::string, ResultsTable> tables_;  ///< by group
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace gyro
