// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"
#include "io/case/parts.hpp"
#include "io/case/table_checker.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr double largest_id = 2147483647.0;    // half of the 32-bit range: the feed uses ids above the largest one
constexpr double largest_rock = 2147483647.0;  // of RockId, a signed 32-bit number
constexpr double smallest_radius = 1e-8;       // of a particle [m]
constexpr double fastest = 1e5;                // [m/s]
constexpr double farthest = 1e7;               // from the origin, which may be that of a mine [m]

bool is_whole(double x, double largest) {
  return x == std::floor(x) && x >= 0 && x <= largest;
}

/// A particle and the line that it was read from.
struct ReadParticle {
  StartParticle particle;
  int line;
};

std::vector<ReadParticle> rows_of(const fs::path& file, const CsvTable& table, CaseProblems& problems) {
  const int rock = table.column("rock");
  const auto three_from = [&](std::string_view column, const std::vector<double>& row) {
    const int begin = table.column(column);
    if (begin < 0) return Vec3d{0, 0, 0};
    const auto k = static_cast<std::size_t>(begin);
    return Vec3d{row[k], row[k + 1], row[k + 2]};
  };
  TableChecker checker(file, table, problems);
  bool good = true;
  std::vector<ReadParticle> read;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::vector<double>& row = table.rows[k];
    const int line = table.lines[k];
    good &= checker.expect(is_whole(row[0], largest_id), k,
                           "the id is out of range; it must be a whole number between 0 and 2147483647");
    good &= checker.expect(row[4] > 0, k, "the radius is not positive; it must be > 0");
    good &= checker.expect(row[4] <= 0 || (row[4] >= smallest_radius && row[4] <= longest_length), k,
                           "the radius is not between 1e-8 and 1000 m; lengths are in metres");
    good &= checker.expect(std::max({std::abs(row[1]), std::abs(row[2]), std::abs(row[3])}) <= farthest, k,
                           "the position is more than 10,000 km away; lengths are in metres");
    good &=
        checker.expect(norm(three_from("vx", row)) <= fastest, k, "the speed is more than 100 km/s; speeds are in m/s");
    good &= checker.expect(rock < 0 || is_whole(row[static_cast<std::size_t>(rock)], largest_rock), k,
                           "the rock is out of range; it must be a whole number between 0 and 2147483647");
    StartParticle particle{0, {row[1], row[2], row[3]}, three_from("vx", row), three_from("wx", row), row[4], none};
    if (good) {
      particle.id = static_cast<std::uint32_t>(row[0]);
      if (rock >= 0) particle.rock = static_cast<RockId>(row[static_cast<std::size_t>(rock)]);
    }
    read.push_back({particle, line});
  }
  return read;
}

/// Index of the particle with an id; `none` if there is no such particle.
Index row_of(const std::vector<StartParticle>& particles, double id) {
  const auto found = std::lower_bound(particles.begin(), particles.end(), id,
                                      [](const StartParticle& p, double x) { return p.id < x; });
  const bool there = found != particles.end() && found->id == id;
  return there ? static_cast<Index>(found - particles.begin()) : none;
}

void read_bonds(const fs::path& file, bool rocks_given, CaseTables& tables, CaseProblems& problems) {
  const CsvTable table = read_csv(file, {"i", "j"}, {{"length0"}});
  TableChecker checker(file, table, problems);
  if (!table.problems.empty()) return;
  const auto at = [&](Index row) -> const StartParticle& { return tables.particles[static_cast<std::size_t>(row)]; };
  std::vector<std::pair<StartBond, int>> read;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::vector<double>& row = table.rows[k];
    const auto bad = [&](std::string_view message) { checker.expect(false, k, message); };
    const Index i = row_of(tables.particles, row[0]), j = row_of(tables.particles, row[1]);
    if (i == none || j == none) {
      checker.bad(
          table.lines[k], "no particle",
          "there is no particle " + number_text(i == none ? row[0] : row[1]) + "; give an id of particles.file");
      continue;
    }
    const double length = row.size() > 2 ? row[2] : norm(at(i).position - at(j).position);
    if (i == j) bad("a particle cannot be bonded to itself; give two different ids");
    if (i != j && !(length > 0)) bad("the length of the bond is not positive; it must be > 0");
    if (rocks_given && at(i).rock != at(j).rock) bad("a bond cannot join two rocks; give ids of one rock");
    read.push_back({{std::min(i, j), std::max(i, j), length}, table.lines[k]});
  }
  const auto ends = [](const auto& bond) { return std::pair(bond.first.i, bond.first.j); };
  std::stable_sort(read.begin(), read.end(), [&](const auto& a, const auto& b) { return ends(a) < ends(b); });
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (k > 0 && ends(read[k]) == ends(read[k - 1]))
      checker.bad(read[k].second, "twice", "the bond is given twice; give each pair once");
    tables.bonds.push_back(read[k].first);
  }
}

/// Gives each set of particles that bonds hold together a rock number, in the order of their first particles.
void number_rocks(CaseTables& tables) {
  std::vector<Index> root(tables.particles.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](Index i) {
    while (root[static_cast<std::size_t>(i)] != i) {
      Index& up = root[static_cast<std::size_t>(i)];
      up = root[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  for (const StartBond& bond : tables.bonds) {
    const Index a = find(bond.i), b = find(bond.j);
    root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  RockId next = 0;
  for (std::size_t i = 0; i < root.size(); ++i) {
    const auto first = static_cast<std::size_t>(find(static_cast<Index>(i)));
    tables.particles[i].rock = first == i ? next++ : tables.particles[first].rock;
  }
}

}  // namespace

void read_start_state(const Setting& particles, CaseTables& tables, CaseProblems& problems) {
  const fs::path file = particles.text("file");
  const CsvTable table = read_csv(file, {"id", "x", "y", "z", "r"}, {{"vx", "vy", "vz"}, {"wx", "wy", "wz"}, {"rock"}});
  for (const CsvProblem& problem : table.problems)
    problems.add_in_file(file, problem.line, problem.column, problem.message);
  if (!table.problems.empty()) return;

  CaseProblems own(file.string());
  std::vector<ReadParticle> read = rows_of(file, table, own);
  const bool numbers_good = own.empty();
  for (const CaseProblem& p : own.sorted()) problems.add_in_file(file, p.line, p.column, p.message);
  if (!numbers_good) return;  // the ids may be invalid

  const auto by_id = [](const ReadParticle& a, const ReadParticle& b) { return a.particle.id < b.particle.id; };
  std::stable_sort(read.begin(), read.end(), by_id);
  TableChecker checker(file, table, problems);
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (k > 0 && read[k].particle.id == read[k - 1].particle.id)
      checker.bad(read[k].line, "twice",
                  "id " + std::to_string(read[k].particle.id) + " is given twice; give each id once");
    tables.particles.push_back(read[k].particle);
  }
  const bool rocks_given = table.column("rock") >= 0;
  const Setting* bonds = particles.find("bonds");
  std::error_code error;
  if (bonds != nullptr && fs::is_regular_file(bonds->texts.at(0), error))
    read_bonds(bonds->texts[0], rocks_given, tables, problems);
  if (!rocks_given) number_rocks(tables);
}

}  // namespace gyro
