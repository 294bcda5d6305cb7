// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/reading.hpp"
#include "app/output/tables/table_writer.hpp"

#include <optional>

namespace gyro {

/// The groups of results.h5 that get a row at the same times: /series, /ledger, /performance, /product and /holdup; and
/// /breakage and /fragments, which get a row for each bond and each fragment.
class RowWriter {
 public:
  /// @param resolution  of the rock; none without rock that can break
  RowWriter(const Case& input, const OutputForm& form, const std::optional<Resolution>& resolution);

  /// Adds its groups to what results.h5 must have.
  void declare(ResultsContent& content) const;
  /// Adds a window to the means of the next row, and writes the bonds that broke in it.
  void add(ResultsFile& file, const WindowResult& result, const Simulation& simulation);
  /// Writes fragments: those that have left, or at the end all others.
  void write(ResultsFile& file, const std::vector<FragmentRecord>& fragments);
  bool empty() const { return !(series_.length() > 0); }  ///< no window since the last row
  void write(ResultsFile& file, const Simulation& simulation, double wall_seconds);

  void save(SavedState& to) const;
  /// @throws BadInput for the state of an output with other columns
  void restore(const SavedState& from);

 private:
  /// @param fines  of the same rock, if the case asks for them
  CurveReading reading_of(const ProductRow& curve, const std::optional<FinesRow>& fines) const;

  const Case& input_;
  std::optional<Resolution> resolution_;
  TableWriter<SeriesReading, WindowReading> series_;
  TableWriter<LedgerReading, WindowReading> ledger_;
  TableWriter<PerformanceReading> performance_;
  TableWriter<FragmentRecord> fragments_;
  std::optional<TableWriter<Breakage>> breakage_;
  std::optional<TableWriter<CurveReading>> product_, holdup_;
  double discharged_before_ = 0;  ///< at the last row [kg]
};

}  // namespace gyro
