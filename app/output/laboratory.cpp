// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/laboratory.hpp"

#include "core/math/regression.hpp"
#include "io/hdf5/hdf5.hpp"
#include "io/run/replace_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gyro {
namespace {

using Test = CaseLaboratory::Test;

constexpr double fallen = 0.7;                      // of the largest force; below it a cylinder has failed
constexpr double split = 2.0 / 3;                   // of the mass; a rock whose largest fragment is smaller has split
constexpr double contact_share = 0.005;             // of the failure force; above it there is contact
constexpr double slope_from = 0.2, slope_to = 0.6;  // of the failure force

constexpr std::size_t first_breaks = 20;  // number of breaks that show where a disc begins to fail

std::string name_of(Test test) {
  return test == Test::platen ? "platen" : test == Test::brazilian ? "brazilian" : "uniaxial";
}

struct Peak {
  std::size_t row = 0;  ///< of the failure force
  bool failed = false;
};

/// Number of breaks before the test begins.
std::size_t breaks_before(const Compression& c) {
  const auto first =
      std::find_if(c.breaks.begin(), c.breaks.end(), [&](const Compression::Break& b) { return b.time >= c.begin; });
  return static_cast<std::size_t>(first - c.breaks.begin());
}

bool cracked(const Compression& c, std::size_t row) {
  return !c.breaks.empty() && c.breaks.front().time <= c.time[row];
}

/// The largest force before the rock has split.
Peak peak_of_lump(const Compression& c) {
  Peak peak;
  for (std::size_t k = 0; k < c.force.size() && !peak.failed; ++k) {
    if (c.force[k] > c.force[peak.row]) peak.row = k;
    peak.failed = cracked(c, k) && c.largest_fragment[k] < split * c.largest_fragment[0];
  }
  return peak;
}

/// The largest force, if the force has fallen after it.
Peak peak_of_cylinder(const Compression& c) {
  Peak peak{static_cast<std::size_t>(std::max_element(c.force.begin(), c.force.end()) - c.force.begin()), false};
  for (std::size_t k = peak.row; k < c.force.size() && !peak.failed; ++k)
    peak.failed = cracked(c, k) && c.force[k] < fallen * c.force[peak.row];
  return peak;
}

/// The row in which the first bond breaks.
std::optional<std::size_t> first_break(const Compression& c) {
  if (c.breaks.empty()) return std::nullopt;
  const auto row = std::lower_bound(c.time.begin(), c.time.end(), c.breaks.front().time) - c.time.begin();
  return std::min(static_cast<std::size_t>(row), c.time.size() - 1);
}

/// First row after which the platen stays in contact until a bond breaks.
std::size_t first_contact(const Compression& c, std::size_t peak) {
  std::size_t row = std::min(peak, first_break(c).value_or(peak));
  while (row > 0 && c.force[row - 1] > contact_share * c.force[peak]) --row;
  return row;
}

/// Displacement at which the curve first reaches a force, linear between points.
double displacement_at(const std::vector<CurvePoint>& curve, double force) {
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const CurvePoint &a = curve[k - 1], &b = curve[k];
    if (b.force < force) continue;
    return b.force > a.force
               ? a.displacement + (force - a.force) / (b.force - a.force) * (b.displacement - a.displacement)
               : b.displacement;
  }
  return curve.back().displacement;
}

/// Share of the first breaks in the middle third between the platens; 1/3 if they are uniformly distributed.
double middle_share(const std::vector<Compression::Break>& breaks) {
  const auto end = breaks.begin() + static_cast<std::ptrdiff_t>(std::min(first_breaks, breaks.size()));
  const auto middle =
      std::count_if(breaks.begin(), end, [](const Compression::Break& b) { return std::abs(b.place) < 1.0 / 6; });
  return static_cast<double>(middle) / static_cast<double>(end - breaks.begin());
}

double strength_of(const Compression& c, double force, double size) {
  if (c.test == Test::uniaxial) return 4 * force / (std::numbers::pi * c.diameter * c.diameter);
  if (c.test == Test::brazilian) return 2 * force / (std::numbers::pi * c.diameter * c.length);
  return 0.9 * force / (size * size);
}

/// Slope of the regression line of force on displacement, from where the curve first reaches one force to where it
/// first reaches the other: waves that run through the rock since the platens met it level out.
std::optional<double> slope_between(const std::vector<CurvePoint>& curve, double low, double high) {
  const double from = displacement_at(curve, low), to = displacement_at(curve, high);
  std::vector<double> displacement{from}, force{low};
  for (const CurvePoint& p : curve) {
    if (p.displacement <= from || p.displacement >= to) continue;
    displacement.push_back(p.displacement);
    force.push_back(p.force);
  }
  displacement.push_back(to);
  force.push_back(high);
  return regression_slope(displacement, force);
}

/// Figures for a specimen that fails at this force.
void add_failure(LaboratoryFigures& f, const Compression& c, const std::vector<CurvePoint>& curve, double force) {
  f.failure_force = force;
  f.failure_displacement = displacement_at(curve, force);
  f.strength = strength_of(c, force, f.size);
  f.stiffness = slope_between(curve, slope_from * force, slope_to * force);
  if (!f.stiffness) return;
  if (c.test == Test::uniaxial) f.modulus = *f.stiffness * c.length * 4 / (std::numbers::pi * c.diameter * c.diameter);
}

const PlaneShape& plane_of(const Assembly& assembly, Index wall) {
  return std::get<PlaneShape>(assembly.setup.scene.walls[static_cast<std::size_t>(wall)].shape);
}

Vec3d velocity_of(const Assembly& assembly, Index wall) {
  const auto* linear = std::get_if<LinearMotion>(&assembly.setup.scene.walls[static_cast<std::size_t>(wall)].motion);
  return linear ? linear->velocity : Vec3d{0, 0, 0};
}

/// Compressive force of a platen, by row of the series.
std::vector<double> pressing_force(const hdf5::File& file, const Case& input, Index wall, const Vec3d& normal) {
  const std::vector<double> forces =
      file.dataset("/series/wall_force_" + input.walls[static_cast<std::size_t>(wall)].name).read();
  std::vector<double> pressing;
  for (std::size_t k = 0; k + 2 < forces.size(); k += 3)
    pressing.push_back(0.0 - dot(Vec3d{forces[k], forces[k + 1], forces[k + 2]}, normal));  // 0.0 - x avoids -0
  return pressing;
}

}  // namespace

LaboratoryReport evaluate(Compression c) {
  LaboratoryReport report;
  LaboratoryFigures& f = report.figures;
  f.test = name_of(c.test);
  f.size = c.gap;
  if (c.force.empty()) return report;
  const std::size_t before = breaks_before(c);
  f.broken_before = static_cast<int>(before);
  c.breaks.erase(c.breaks.begin(), c.breaks.begin() + static_cast<std::ptrdiff_t>(before));
  const Peak peak = c.test == Test::uniaxial ? peak_of_cylinder(c) : peak_of_lump(c);
  const double largest = c.force[peak.row];
  if (!(largest > 0)) return report;  // the platen never touched the rock
  const std::size_t contact = first_contact(c, peak.row);
  f.size = c.gap - c.closing_speed * c.time[contact];
  for (std::size_t k = contact; k < c.force.size(); ++k)
    report.curve.push_back({c.closing_speed * (c.time[k] - c.time[contact]), c.force[k]});
  if (const auto row = first_break(c)) f.first_break_force = c.force[*row];
  if (c.test == Test::brazilian && !c.breaks.empty()) f.middle_breaks = middle_share(c.breaks);
  if (peak.failed) add_failure(f, c, report.curve, largest);
  return report;
}

Compression measured_compression(const Case& input, const Assembly& assembly, const std::filesystem::path& results) {
  const CaseLaboratory& laboratory = *input.laboratory;
  const PlaneShape &fixed = plane_of(assembly, laboratory.fixed), &moving = plane_of(assembly, laboratory.moving);
  Compression c;
  c.test = laboratory.test;
  c.gap = dot(fixed.point - moving.point, moving.normal);
  c.closing_speed =
      dot(velocity_of(assembly, laboratory.moving) - velocity_of(assembly, laboratory.fixed), moving.normal);
  if (const auto* cylinder = input.rocks ? std::get_if<CylinderSpecimen>(&input.rocks->shapes) : nullptr) {
    c.diameter = cylinder_diameter(*cylinder, assembly.setup.library.rocks.front().diameter);
    c.length = cylinder->slenderness * c.diameter;
  }
  const hdf5::File file = hdf5::File::open(results);
  c.time = file.dataset("/series/time").read();
  c.largest_fragment = file.dataset("/series/largest_fragment").read();
  const std::vector<double> moving_force = pressing_force(file, input, laboratory.moving, moving.normal);
  const std::vector<double> fixed_force = pressing_force(file, input, laboratory.fixed, fixed.normal);
  for (std::size_t k = 0; k < c.time.size(); ++k) c.force.push_back((moving_force[k] + fixed_force[k]) / 2);
  const auto pressed = std::find_if(moving_force.begin(), moving_force.end(), [](double f) { return f > 0; });
  if (pressed > moving_force.begin()) c.begin = c.time[static_cast<std::size_t>(pressed - moving_force.begin()) - 1];
  const std::vector<double> times = file.dataset("/breakage/time").read(),
                            places = file.dataset("/breakage/position").read();
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Vec3d place{places[3 * k], places[3 * k + 1], places[3 * k + 2]};
    const Vec3d platen = moving.point + times[k] * velocity_of(assembly, laboratory.moving);
    const double gap = c.gap - c.closing_speed * times[k];
    c.breaks.push_back({times[k], 0.5 - dot(place - platen, moving.normal) / gap});
  }
  return c;
}

LaboratoryFigures write_laboratory(const Case& input, const Assembly& assembly,
                                   const std::filesystem::path& directory) {
  const LaboratoryReport report = evaluate(measured_compression(input, assembly, directory / "results.h5"));
  std::string csv = "displacement_m,force_N\n";
  char row[64];
  for (const CurvePoint& p : report.curve) {
    std::snprintf(row, sizeof row, "%.6e,%.6e\n", p.displacement, p.force);
    csv += row;
  }
  replace_file(directory / "force_displacement.csv", csv);
  return report.figures;
}

}  // namespace gyro
