// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/fill.hpp"

#include "core/base/errors.hpp"
#include "core/math/quat.hpp"
#include "core/math/random.hpp"
#include "core/rocks/packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace gyro {
namespace {

constexpr int cuts = 16, most_cuts = 64;  // more where few particles seldom hold together
/// A cut that loses more than this share of its spheres is no rock.
constexpr double least_kept = 0.8;
/// Draws up to here made the packing itself.
constexpr std::uint32_t first_draw = 16;

double cube(double x) {
  return x * x * x;
}

/// Where and how the shape lies in the packing.
struct Cut {
  Vec3d offset;  ///< of the shape's centre, in the packing
  Quatd turn;    ///< from the shape's frame to the packing's
};

Cut draw_cut(const Packing& packing, std::uint64_t seed, std::uint64_t rock, int attempt) {
  std::uint32_t next = first_draw + 8 * static_cast<std::uint32_t>(attempt);
  const auto draw = [&] { return uniform(seed, Stream::fill, rock, next++); };
  Cut cut;
  cut.offset.x = packing.side * draw();
  cut.offset.y = packing.side * draw();
  cut.offset.z = packing.side * draw();
  // Uniform over all turns: Shoemake, Graphics Gems III (1992) 124.
  const double u = draw(), a = 2 * std::numbers::pi * draw(), b = 2 * std::numbers::pi * draw();
  const double s = std::sqrt(1 - u), c = std::sqrt(u);
  cut.turn = {c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b)};
  return cut;
}

/// Centres inside the shape, in its frame. @param radius of the spheres, in the shape's unit
std::vector<Vec3d> cut_out(const Mould& mould, const Packing& packing, const Cut& cut, double radius) {
  double reach2 = 0;
  for (const Vec3d& v : mould.shape.surface.vertices) reach2 = std::max(reach2, norm2(v));
  const double reach = std::sqrt(reach2) / radius, side = packing.side;
  std::vector<Vec3d> found;
  for (const Vec3d& c : packing.centres) {
    const Vec3d d = c - cut.offset;
    const auto first = [&](double x) { return x + side * std::ceil((-reach - x) / side); };
    for (double x = first(d.x); x <= reach; x += side) {
      for (double y = first(d.y); y <= reach; y += side) {
        for (double z = first(d.z); z <= reach; z += side) {
          if (x * x + y * y + z * z > reach * reach) continue;
          const Vec3d p = radius * rotate_back(cut.turn, Vec3d{x, y, z});
          if (mould.inside.contains(p)) found.push_back(p);
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

/// Neighbours in space become neighbours in memory.
void sort_for_locality(std::vector<Vec3d>& centres) {
  double half = 0;
  for (const Vec3d& p : centres) half = std::max({half, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (half == 0) return;
  std::stable_sort(centres.begin(), centres.end(),
                   [&](const Vec3d& a, const Vec3d& b) { return morton_code(a, half) < morton_code(b, half); });
}

/// Largest relative error of mass (counted twice: it is the coarsest measure) and principal moments against
/// the shape filled evenly.
double misfit(const Mould& mould, const Filling& filling, double fraction) {
  if (filling.centres.empty()) return std::numeric_limits<double>::infinity();
  const double mass = sphere_volume(filling.radii);
  const Vec3d got = principal_axes(sphere_inertia(filling.centres, filling.radii, 1 / mass)).moments;
  const Vec3d want = mould.shape.inertia;
  return std::max({2 * std::abs(mass / fraction - 1), std::abs(got.x / want.x - 1), std::abs(got.y / want.y - 1),
                   std::abs(got.z / want.z - 1)});
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

Filling fill_mono(const Mould& mould, double ratio, const BondRule& rule, std::uint64_t seed, std::uint64_t rock) {
  if (!(ratio >= least_fill_ratio && ratio <= greatest_fill_ratio)) {
    throw BadInput("rocks.fill ratio is " + std::to_string(ratio) + "; accepted is 2 to 50");
  }
  const Packing& packing = rock_packing();
  const double radius = std::cbrt(6 / std::numbers::pi) / (2 * ratio);
  Filling best;
  double best_misfit = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < cuts || (best.centres.empty() && attempt < most_cuts); ++attempt) {
    std::vector<Vec3d> centres = cut_out(mould, packing, draw_cut(packing, seed, rock, attempt), radius);
    sort_for_locality(centres);
    const std::vector<double> radii(centres.size(), radius);
    const std::vector<Index> piece =
        largest_piece(make_bonds(centres, radii, rule), static_cast<Index>(centres.size()));
    if (piece.empty() || static_cast<double>(piece.size()) < least_kept * static_cast<double>(centres.size())) continue;
    Filling filling;
    for (const Index p : piece) filling.centres.push_back(centres[p]);
    filling.radii.assign(piece.size(), radius);
    const double m = misfit(mould, filling, packing.fraction);
    if (m < best_misfit) best = std::move(filling), best_misfit = m;
  }
  if (best.centres.empty()) {
    throw BadInput("the particles of a rock do not hold together at fill ratio " + std::to_string(ratio) +
                   " and bonds.gap " + std::to_string(rule.gap) +
                   ": its shape is too thin or the gap too small; accepted are larger ratios and gaps, 0.05 is usual");
  }
  return best;
}

}  // namespace gyro
