// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/fill.hpp"

#include "core/base/errors.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/math/quat.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>

namespace gyro {
namespace {

constexpr int cuts = 16, max_cuts = 64;  // if none of the first is in one piece, up to max_cuts
constexpr int cuts_of_many = 4;          // with many particles all cuts are similar
constexpr double many = 3000;            // particles
/// A cut whose largest piece has a smaller share of its spheres is discarded.
constexpr double min_kept = 0.8;
/// Earlier draws of the stream belong to the packing.
constexpr std::uint32_t first_draw = 16;

double cube(double x) {
  return x * x * x;
}

/// Position and orientation of the shape in the packing.
struct Cut {
  Vec3d offset;       ///< of the shape's centre, in the packing
  Quatd orientation;  ///< from the shape's frame to the packing's
};

Cut draw_cut(const Packing& packing, std::uint64_t seed, std::uint64_t rock, int attempt) {
  std::uint32_t next = first_draw + 8 * static_cast<std::uint32_t>(attempt);
  const auto draw = [&] { return uniform(seed, Stream::fill, rock, next++); };
  Cut cut;
  cut.offset.x = packing.side * draw();
  cut.offset.y = packing.side * draw();
  cut.offset.z = packing.side * draw();
  // Uniform over all rotations: Shoemake, Graphics Gems III (1992) 124.
  const double u = draw(), a = 2 * std::numbers::pi * draw(), b = 2 * std::numbers::pi * draw();
  const double s = std::sqrt(1 - u), c = std::sqrt(u);
  cut.orientation = {c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b)};
  return cut;
}

/// Spheres whose centres lie inside the shape, in its frame.
/// @param unit  the packing's unit of length, in that of the shape
Filling cut_out(const Mould& mould, const Packing& packing, const Cut& cut, double unit) {
  double reach2 = 0;
  for (const Vec3d& v : mould.shape.surface.vertices) reach2 = std::max(reach2, norm2(v));
  const double reach = std::sqrt(reach2) / unit, side = packing.side;
  Filling found;
  for (std::size_t k = 0; k < packing.centres.size(); ++k) {
    const Vec3d d = packing.centres[k] - cut.offset;
    const auto first = [&](double x) { return x + side * std::ceil((-reach - x) / side); };
    for (double x = first(d.x); x <= reach; x += side) {
      for (double y = first(d.y); y <= reach; y += side) {
        for (double z = first(d.z); z <= reach; z += side) {
          if (x * x + y * y + z * z > reach * reach) continue;
          const Vec3d p = unit * rotate_back(cut.orientation, Vec3d{x, y, z});
          if (!mould.inside.contains(p)) continue;
          found.centres.push_back(p);
          found.radii.push_back(unit * packing.radii[k]);
        }
      }
    }
  }
  return found;
}

/// Interleaves ten bits of each coordinate.
std::uint32_t morton_code(const Vec3d& p, double half_side) {
  const auto bits = [&](double x) {
    const double scaled = std::clamp((x / half_side + 1) * 512, 0.0, 1023.0);
    std::uint32_t k = static_cast<std::uint32_t>(scaled);
    k = (k | (k << 16)) & 0x030000FFu;
    k = (k | (k << 8)) & 0x0300F00Fu;
    k = (k | (k << 4)) & 0x030C30C3u;
    return (k | (k << 2)) & 0x09249249u;
  };
  return (bits(p.x) << 2) | (bits(p.y) << 1) | bits(p.z);
}

/// Some spheres of a filling, in the order of the list.
Filling selected(const Filling& filling, const std::vector<Index>& list) {
  Filling some;
  for (const Index k : list) {
    some.centres.push_back(filling.centres[k]);
    some.radii.push_back(filling.radii[k]);
  }
  return some;
}

/// Sorts so that neighbours in space are neighbours in memory.
Filling sorted_for_locality(const Filling& filling) {
  double half = 0;
  for (const Vec3d& p : filling.centres) half = std::max({half, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (half == 0) return filling;
  std::vector<std::uint32_t> code;
  for (const Vec3d& p : filling.centres) code.push_back(morton_code(p, half));
  std::vector<Index> order(filling.centres.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return code[a] < code[b]; });
  return selected(filling, order);
}

/// The largest of: twice the relative error of the mass, and the relative errors of the principal moments. The shape
/// filled evenly is the reference.
double misfit(const Mould& mould, const Filling& filling, double fraction) {
  if (filling.centres.empty()) return std::numeric_limits<double>::infinity();
  const double mass = sphere_volume(filling.radii);
  const Vec3d got = principal_axes(sphere_inertia(filling.centres, filling.radii, 1 / mass)).moments;
  const Vec3d want = mould.shape.inertia;
  return std::max({2 * std::abs(mass / fraction - 1), std::abs(got.x / want.x - 1), std::abs(got.y / want.y - 1),
                   std::abs(got.z / want.z - 1)});
}

/// The best of many cuts; an empty filling if none is in one piece.
/// @param unit  the packing's unit of length, in that of the shape
Filling best_cut(const Mould& mould, const Packing& packing, double unit, const BondRule& bonds, const FillJob& job) {
  const double expected = static_cast<double>(packing.centres.size()) / cube(packing.side * unit);
  const int enough = expected < many ? cuts : cuts_of_many;
  Filling best;
  double best_misfit = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < enough || (best.centres.empty() && attempt < max_cuts); ++attempt) {
    const Cut cut = draw_cut(packing, job.seed, job.rock, attempt);
    const Filling whole = sorted_for_locality(cut_out(mould, packing, cut, unit));
    const auto found = static_cast<Index>(whole.centres.size());
    const std::vector<Index> piece = largest_piece(make_bonds(whole.centres, whole.radii, bonds), found);
    if (piece.empty() || static_cast<double>(piece.size()) < min_kept * found) continue;
    Filling filling = selected(whole, piece);
    const double m = misfit(mould, filling, packing.fraction);
    if (m < best_misfit) best = std::move(filling), best_misfit = m;
  }
  return best;
}

/// The faces of a convex shape; the triangles of one face give one.
Vessel vessel_of(const Mould& mould) {
  if (!mould.inside.convex())
    throw BadInput("rocks.fill.surface: smooth needs a convex shape of at most 500 triangles; use cut");
  Vessel vessel;
  vessel.volume = 1;
  for (const InsideTest::Plane& plane : mould.inside.planes()) {
    const bool known = std::any_of(vessel.faces.begin(), vessel.faces.end(), [&](const Vessel::Face& face) {
      return norm2(face.normal - plane.normal) < 1e-12 && std::abs(face.offset - plane.offset) < 1e-6;
    });
    if (!known) vessel.faces.push_back({plane.normal, plane.offset});
  }
  for (const Vec3d& v : mould.shape.surface.vertices) vessel.reach = std::max(vessel.reach, norm(v));
  return vessel;
}

/// Equal spheres jammed in a vessel of unit volume, with about the requested ratio. The number of spheres is found in a
/// few trials, because spheres pack less densely at faces, depending on shape and ratio.
Packing jam_to_ratio(const Vessel& vessel, double ratio, const FillJob& job) {
  constexpr double close = 0.003, guess = 0.58;
  constexpr int max_tries = 5;
  Packing best;
  double fraction = guess, best_error = std::numeric_limits<double>::infinity();
  for (int k = 0; k < max_tries && best_error > close; ++k) {
    const int count = std::max(1, static_cast<int>(std::lround(fraction * cube(ratio))));
    Packing packing = jam_in(vessel, count, job.seed, job.rock << 32);
    fraction = packing.fraction;
    const double error = std::abs(std::cbrt(count / fraction) / ratio - 1);
    if (error < best_error) best = std::move(packing), best_error = error;
  }
  return best;
}

/// Diameter of the rock / particle diameter.
double ratio_of(const MonoFill& mono, const FillJob& job) {
  return mono.floor > 0 ? job.diameter / particle_diameter(mono, job.diameter) : mono.ratio;
}

/// Spheres jammed in the shape itself.
Filling jammed(const MonoFill& mono, const Mould& mould, const BondRule& bonds, const FillJob& job) {
  const Packing packing = jam_to_ratio(vessel_of(mould), ratio_of(mono, job), job);
  Filling filling;
  for (const Vec3d& x : packing.centres) filling.centres.push_back((1 / packing.side) * x);
  filling.radii.assign(packing.radii.size(), 1 / packing.side);
  const Filling whole = sorted_for_locality(filling);
  const auto found = static_cast<Index>(whole.centres.size());
  const std::vector<Index> piece = largest_piece(make_bonds(whole.centres, whole.radii, bonds), found);
  return static_cast<double>(piece.size()) < min_kept * found ? Filling{} : selected(whole, piece);
}

std::string in_mm(double length) {
  std::ostringstream text;
  text << 1e3 * length << " mm";
  return text.str();
}

void check(const MonoFill& mono) {
  if (!(mono.ratio >= min_fill_ratio && mono.ratio <= max_fill_ratio))
    throw BadInput("rocks.fill ratio is " + std::to_string(mono.ratio) + "; it must be between 2 and 50");
  if (!(std::isfinite(mono.floor) && mono.floor >= 0))
    throw BadInput("rocks.fill.floor is " + in_mm(mono.floor) + "; it must be a finite length above 0");
}

void check(const RangeFill& range) {
  if (!(range.smallest > 0 && range.largest > range.smallest && range.largest <= max_size_ratio * range.smallest)) {
    throw BadInput("rocks.fill.sizes are " + in_mm(range.smallest) + " to " + in_mm(range.largest) +
                   "; the largest must be above the smallest and at most 8 times as large");
  }
  if (!(range.exponent > 0 && range.exponent <= 5))
    throw BadInput("rocks.fill.exponent is " + std::to_string(range.exponent) + "; it must be > 0 and <= 5");
}

Filling cut_for(const MonoFill& mono, const Mould& mould, const BondRule& bonds, const FillJob& job) {
  if (mono.surface == MonoFill::Surface::smooth) return jammed(mono, mould, bonds, job);
  return best_cut(mould, rock_packing(), std::cbrt(6 / std::numbers::pi) / (2 * ratio_of(mono, job)), bonds, job);
}

Filling cut_for(const RangeFill& range, const Mould& mould, const BondRule& bonds, const FillJob& job) {
  const Packing& packing = rock_packing(grading_of(range, job.diameter));
  const double side_of_cube = std::cbrt(std::numbers::pi / 6) * job.diameter;  // of the rock's volume [m]
  return best_cut(mould, packing, range.smallest / 2 / side_of_cube, bonds, job);
}

}  // namespace

double sphere_volume(const std::vector<double>& radii) {
  double sum = 0;
  for (const double r : radii) sum += cube(r);
  return 4 * std::numbers::pi / 3 * sum;
}

Vec3d centre_of_mass(const std::vector<Vec3d>& centres, const std::vector<double>& radii) {
  Vec3d sum{0, 0, 0};
  double weight = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) sum += cube(radii[k]) * centres[k], weight += cube(radii[k]);
  return (1 / weight) * sum;
}

std::array<double, 6> sphere_inertia(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     double density) {
  const Vec3d middle = centre_of_mass(centres, radii);
  std::array<double, 6> t{};
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const Vec3d d = centres[k] - middle;
    const double m = density * 4 * std::numbers::pi / 3 * cube(radii[k]), own = 0.4 * radii[k] * radii[k];
    t[0] += m * (d.y * d.y + d.z * d.z + own);
    t[1] += m * (d.z * d.z + d.x * d.x + own);
    t[2] += m * (d.x * d.x + d.y * d.y + own);
    t[3] -= m * d.x * d.y;
    t[4] -= m * d.y * d.z;
    t[5] -= m * d.z * d.x;
  }
  return t;
}

double particle_diameter(const MonoFill& mono, double diameter) {
  return std::max(diameter / mono.ratio, std::min(mono.floor, diameter / min_graded_ratio));
}

void check_rule(const FillRule& rule) {
  std::visit([](const auto& r) { check(r); }, rule);
}

Grading grading_of(const RangeFill& range, double diameter) {
  constexpr double largest_share = 1.0 / 3;  // of the rock's diameter
  constexpr double classes = 4;              // for each factor 2
  const double largest = std::min(range.largest, largest_share * diameter);
  if (largest < range.smallest) {
    throw BadInput("a rock of " + in_mm(diameter) + " is too small for particles from " + in_mm(range.smallest) +
                   " on; it must be at least three times as large as the smallest of rocks.fill.sizes");
  }
  const double below = std::ceil(classes * std::log2(range.largest / largest) - 1e-9);
  const double ratio = range.largest / range.smallest * std::exp2(-std::max(0.0, below) / classes);
  const Grading grading{std::max(1.0, ratio), range.exponent};
  const double count = 0.7 * cube(diameter / range.smallest) / mean_cubed_radius(grading);
  if (count > max_particles) {
    throw BadInput("a rock of " + in_mm(diameter) + " would hold about " + std::to_string(std::lround(count)) +
                   " particles, but the limit is 100000; use larger rocks.fill.sizes or smaller rocks");
  }
  return grading;
}

Filling fill(const Mould& mould, const FillRule& rule, const BondRule& bonds, const FillJob& job) {
  check_rule(rule);
  Filling best = std::visit([&](const auto& r) { return cut_for(r, mould, bonds, job); }, rule);
  if (best.centres.empty()) {
    const auto* mono = std::get_if<MonoFill>(&rule);
    throw BadInput("the particles of a rock do not hold together" +
                   (mono ? " at fill ratio " + std::to_string(ratio_of(*mono, job)) : std::string()) +
                   " and bonds.gap " + std::to_string(bonds.gap) +
                   ": the shape is too thin or the gap is too small; use " +
                   (mono ? "a larger ratio" : "smaller particles") + " or a larger gap, 0.05 is usual");
  }
  return best;
}

}  // namespace gyro
