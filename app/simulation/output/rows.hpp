// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/output/reading.hpp"
#include "app/simulation/output/table_writer.hpp"

#include <optional>
#include <span>

namespace gyro {

/// The groups of results.h5 that get a row at the same times: /series, /ledger, /performance, /product and /holdup; and
/// /breakage, which gets the bonds that broke since the last row.
class RowWriter {
 public:
  RowWriter(const Case& input, const Assembly& assembly, const OutputForm& form);

  /// Adds its groups to what results.h5 must have.
  void declare(ResultsContent& content) const;
  /// Adds a window to the means of the next row.
  void add(const WindowResult& result, const Simulation& simulation);
  bool empty() const { return !(series_.length() > 0); }  ///< no window since the last row
  /// Writes a row. @param breakages  since the last one
  void write(ResultsFile& file, const Simulation& simulation, std::span<const Breakage> breakages, double wall_seconds);

  void save(SavedState& to) const;
  /// @throws BadInput for what an output with other columns has saved
  void restore(const SavedState& from);

 private:
  CurveReading reading_of(const ProductRow& curve) const;

  const Case& input_;
  Index gyrating_;
  TableWriter<SeriesReading, WindowReading> series_;
  TableWriter<LedgerReading, WindowReading> ledger_;
  TableWriter<PerformanceReading> performance_;
  std::optional<TableWriter<Breakage>> breakage_;
  std::optional<TableWriter<CurveReading>> product_, holdup_;
  double discharged_before_ = 0;  ///< at the last row [kg]
};

}  // namespace gyro
