// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"
#include "io/case/parts.hpp"
#include "io/case/table_checker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

namespace fs = std::filesystem;

// No crusher is outside these limits.
constexpr double longest_liner = 100, smallest_liner = 1e-5;  // [m]
constexpr std::size_t max_liner_rows = 5'000;
constexpr double largest_torque = 1e9, largest_rpm = 1e5, largest_voltage_ratio = 2;

/// The file of a setting, if it is one; a missing file has already been reported.
std::optional<fs::path> table_file(const Setting* setting) {
  std::error_code error;
  if (setting == nullptr || !fs::is_regular_file(setting->texts.at(0), error)) return std::nullopt;
  return fs::path(setting->texts[0]);
}

std::vector<LinerRow> read_liners(const fs::path& file, CaseProblems& problems) {
  const CsvTable table = read_csv(file, {"z_m", "mantle_radius_m", "concave_radius_m"});
  TableChecker checker(file, table, problems);
  if (!table.problems.empty()) return {};
  checker.expect_rows(2);
  if (const std::size_t n = table.rows.size(); n > max_liner_rows)  // the setting compares each row with many
    checker.expect(false, max_liner_rows,
                   "the profile has " + std::to_string(n) + " rows, more than " + std::to_string(max_liner_rows) +
                       "; keep one row in " + std::to_string((n - 1) / (max_liner_rows - 1) + 1));
  checker.expect_rising(0);
  std::vector<LinerRow> liners;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const LinerRow row{table.rows[k][0], table.rows[k][1], table.rows[k][2]};
    checker.expect(std::max({std::abs(row.z), row.mantle_radius, row.concave_radius}) <= longest_liner, k,
                   "a length is more than 100 m; the profile is in metres: divide numbers in mm by 1000");
    checker.expect(row.mantle_radius > 0, k, "the mantle's radius is not positive; it must be > 0");
    checker.expect(row.mantle_radius <= 0 || row.mantle_radius >= smallest_liner, k,
                   "the mantle's radius is less than 0.01 mm; the profile is in metres");
    checker.expect(row.concave_radius > row.mantle_radius, k,
                   "there is no gap; the concave radius must be larger than the mantle radius");
    liners.push_back(row);
  }
  if (liners.size() >= 2 && (liners.front().z > 0 || liners.back().z <= 0))
    problems.add_in_file(file, table.lines[0], 1,
                         "the discharge plane z = 0 is not in the profile; begin at z <= 0 and end at z > 0");
  return liners;
}

std::vector<PassingPoint> read_sieves(const fs::path& file, CaseProblems& problems) {
  CsvTable table = read_csv(file, {"size_mm", "passing_percent"});
  if (table.problems.empty() && table.rows.size() > 1 && table.rows.front()[0] > table.rows.back()[0]) {
    std::ranges::reverse(table.rows);  // laboratories list the coarsest sieve first
    std::ranges::reverse(table.lines);
  }
  TableChecker checker(file, table, problems);
  if (!table.problems.empty()) return {};
  checker.expect_rows(2);
  checker.expect_rising(0);
  std::vector<PassingPoint> points;
  const std::size_t n = table.rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double size = table.rows[k][0], percent = table.rows[k][1];
    checker.expect(size <= 1e3 * longest_length, k, "the size is more than 1 km; give the sieves in mm");
    checker.expect(size > 0, k, "the size is not positive; it must be > 0");
    checker.expect(k == 0 || percent >= table.rows[k - 1][1], k, "passing falls; each row must be >= the one before");
    checker.expect(k > 0 || percent == 0, k,
                   "the finest sieve does not have 0 percent, so that the smallest size is unknown; add a row with the "
                   "smallest size to simulate and 0 percent");
    checker.expect(k + 1 < n || percent == 100, k,
                   "the coarsest sieve does not have 100 percent; add a row with the largest size and 100 percent");
    points.push_back({size * 1e-3, percent * 1e-2});
  }
  return points;
}

/// Checks that the motor drives up to its synchronous speed and, if the table continues, is a generator above it.
void check_torques(const std::vector<double>& torques, TableChecker& checker) {
  const std::size_t n = torques.size();
  checker.expect(torques[n - 1] <= 0, n - 1, "the motor still drives at its last speed; the last torque must be <= 0");
  std::size_t driving = n;  // rows up to the last one that drives
  while (driving > 0 && !(torques[driving - 1] > 0)) --driving;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (torques[k] > 0) continue;
    if (k < driving || k == 0) {
      checker.expect(false, k,
                     "the motor does not drive here; the torque must be > 0 in every row up to the synchronous speed");
      return;
    }
    checker.expect(torques[k + 1] < 0, k + 1,
                   "the torque above the synchronous speed is not negative; give the generator's torque, or end the "
                   "table at the synchronous speed");
    if (torques[k + 1] >= 0) return;
  }
  checker.expect(torques[n - 1] <= torques[n - 2], n - 1,
                 "the torque rises at the last speed, so that the motor would drive far above it; end the table "
                 "where the generator's torque still falls");
}

CurveMotor read_motor(const fs::path& file, CaseProblems& problems) {
  const CsvTable table = read_csv(file, {"speed_rpm", "torque_Nm"});
  TableChecker checker(file, table, problems);
  if (!table.problems.empty()) return {};
  checker.expect_rows(2);
  checker.expect_rising(0);
  CurveMotor motor;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const double speed = table.rows[k][0], torque = table.rows[k][1];
    checker.expect(speed <= largest_rpm, k, "the speed is more than 100,000 rpm; speeds are in rpm");
    checker.expect(std::abs(torque) <= largest_torque, k, "the torque is more than 1e9 N m; torques are in N m");
    motor.speeds.push_back(speed * std::numbers::pi / 30);
    motor.torques.push_back(torque);
  }
  if (const std::size_t n = table.rows.size(); n >= 2) {
    checker.expect(motor.speeds[0] >= 0, 0,
                   "the first speed is negative; begin at 0 rpm, whose torque also holds when the motor is turned "
                   "backwards");
    checker.expect(motor.speeds[0] <= 0, 0, "the curve does not begin at standstill; the first speed must be 0 rpm");
    check_torques(motor.torques, checker);
  }
  return motor;
}

VoltageInput read_voltage(const fs::path& file, CaseProblems& problems) {
  const CsvTable table = read_csv(file, {"time_s", "voltage_ratio"});
  TableChecker checker(file, table, problems);
  if (!table.problems.empty()) return {};
  checker.expect_rows(1);
  checker.expect_rising(0);
  VoltageInput voltage;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    checker.expect(k > 0 || table.rows[k][0] == 0, k, "the table does not begin at t = 0; the first time must be 0 s");
    checker.expect(table.rows[k][1] >= 0, k, "the voltage is negative; the ratio must be >= 0");
    checker.expect(table.rows[k][1] <= largest_voltage_ratio, k,
                   "the voltage is more than twice the rated one; 1 is the rated voltage: divide percent by 100, and "
                   "volts by the rated voltage");
    voltage.times.push_back(table.rows[k][0]);
    voltage.ratios.push_back(table.rows[k][1]);
  }
  return voltage;
}

/// Checks the ids of probes of a case without a feed: its table contains every particle of the run.
void check_probes(const Setting& root, const CaseTables& tables, CaseProblems& problems) {
  const Setting* probes = root.find("output.probes");
  if (probes == nullptr || root.find("feed") != nullptr || tables.particles.empty()) return;
  for (std::size_t k = 0; k < probes->numbers.size(); ++k) {
    const auto is_it = [id = probes->numbers[k]](const StartParticle& p) { return p.id == id; };
    if (std::none_of(tables.particles.begin(), tables.particles.end(), is_it))
      problems.add(probes->item_marks[k],
                   "there is no particle " + number_text(probes->numbers[k]) + "; give an id of particles.file");
  }
}

}  // namespace

CaseTables read_tables(const Setting& root, CaseProblems& problems) {
  CaseTables tables;
  if (const auto file = table_file(root.find("crusher.profile"))) tables.liners = read_liners(*file, problems);
  if (const auto file = table_file(root.find("rocks.sizes.sieves"))) tables.sieves = read_sieves(*file, problems);
  if (const auto file = table_file(root.find("drivetrain.motor.file"))) tables.motor = read_motor(*file, problems);
  if (const auto file = table_file(root.find("drivetrain.motor.voltage_file")))
    tables.voltage = read_voltage(*file, problems);
  if (table_file(root.find("drivetrain.fmu"))) read_drive_fmu(root, tables, problems);
  if (table_file(root.find("particles.file"))) read_start_state(*root.find("particles"), tables, problems);
  check_probes(root, tables, problems);
  return tables;
}

}  // namespace gyro
