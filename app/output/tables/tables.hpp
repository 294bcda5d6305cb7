// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/resolution.hpp"
#include "app/output/tables/column.hpp"
#include "core/fragments/fines.hpp"
#include "core/fragments/fragment_record.hpp"
#include "core/fragments/sieve_curve.hpp"
#include "core/scene/accounts.hpp"
#include "mbd/drivetrain.hpp"

#include <vector>

/// The tables of results.h5, and what their columns read. A column is added in its table, which writes the dataset, its
/// attributes and its lines in cases/OUTPUTS.md; what it needs beyond the reading is a member of the reading, filled in
/// reading.cpp or liner_maps.cpp.
namespace gyro {

/// Quantities of a coupling window, for the means of a row.
struct WindowReading {
  double length = 0;                    ///< [s]
  double crushing_power = 0;            ///< [W]
  Vec3d mantle_force{0, 0, 0};          ///< [N]
  std::vector<Vec3d> wall_forces = {};  ///< by OutputForm::walls [N]
  DrivetrainMeans drive = {};           ///< zeros without a drivetrain
};

/// The run at the end of a row of /series.
struct SeriesReading {
  double time = 0, interval = 0;                                                      ///< end and length of the row [s]
  double motor_speed = 0, eccentric_speed = 0, eccentric_angle = 0, mantle_spin = 0;  ///< [rad/s], [rad]
  double feed_mass = 0, discharged_mass = 0, escaped_mass = 0, holdup_mass = 0;       ///< [kg]
  double discharged_before = 0;                                                       ///< before the row [kg]
  Counts counts = {};
  std::int64_t fragments = 0;
  double largest_fragment = 0;                                                       ///< [kg]
  double max_overlap_ratio = 0;                                                      ///< [-]
  std::vector<Vec3d> probe_positions = {}, probe_velocities = {}, probe_spins = {};  ///< by OutputForm::probes
  double wall_seconds = 0;                                                           ///< [s]
};
const Table<SeriesReading, WindowReading>& series_table();

/// The balances at the end of a row of /ledger.
struct LedgerReading {
  double time = 0;
  EnergyTerms energy = {};
  double momentum_residual = 0;    ///< [N s]
  std::int64_t mass_residual = 0;  ///< particles
};
const Table<LedgerReading, WindowReading>& ledger_table();

/// Cost of the run until the end of a row of /performance.
struct PerformanceReading {
  double time = 0, wall_seconds = 0;  ///< [s]
  Counts counts = {};
};
const Table<PerformanceReading>& performance_table();

/// A broken bond is a row of /breakage.
const Table<Breakage>& breakage_table();

/// A fragment that has left, or that is there at the end, is a row of /fragments.
const Table<FragmentRecord>& fragments_table();

/// A sieve curve with the settings at which it is read.
struct CurveReading {
  ProductRow curve;
  double closed_side_setting, open_side_setting;  ///< [m]
  std::optional<FinesRow> fines = {};             ///< none unless the case asks for them
};
const Table<CurveReading>& product_table();
const Table<CurveReading>& holdup_table();
/// An attribute of the groups of both.
struct CurveAttribute {
  const char* name;
  const char* units;
  double Resolution::*value;
  const char* description;
};
const std::vector<CurveAttribute>& curve_attributes();
inline constexpr Presence with_resolution{"with a crusher and bonds",
                                          [](const OutputForm& f) { return f.product && f.bonds; }};
/// The sieves of both, written once.
struct Sieves {
  std::vector<double> sizes;  ///< openings [m]
};
const Table<Sieves>& product_sieves();
const Table<Sieves>& holdup_sieves();

/// Loads of the rock on the cells of a liner since the last map, or on its triangles since the start.
struct LinerReading {
  double time = 0;
  std::vector<double> pressure = {}, work = {}, wear = {};  ///< [Pa], [J], [m]
};
const Table<LinerReading>& liner_cells_table();
const Table<LinerReading>& liner_triangles_table();
/// Positions of the cells and triangles of a liner, written once.
struct LinerShape {
  std::vector<double> heights, azimuths, area, corners;  ///< [m], [rad], [m2], [m]
};
const Table<LinerShape>& liner_shape_table();

}  // namespace gyro
