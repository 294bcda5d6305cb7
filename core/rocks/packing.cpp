// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/packing.hpp"

#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

namespace gyro {
namespace {

/// Packing fraction of equal soft spheres. Random equal spheres jam at about 0.639 (O'Hern et al., Phys.
/// Rev. E 68 (2003) 011306). At this fraction, 1 % below, the energy relaxes to zero in half the steps,
/// overlaps end at 0.4 % of the radius instead of 2 %, and there are as many neighbours within 0.05 radius (7.2).
constexpr double soft_fraction = 0.632;
constexpr double largest_overlap = 0.009;  // [smaller radius]
constexpr double sphere_volume = 4 * std::numbers::pi / 3;

double total_volume(const std::vector<double>& radii) {
  double sum = 0;
  for (const double r : radii) sum += r * r * r;
  return sphere_volume * sum;
}

/// Random points in a cube in which spheres of these radii have the fraction.
SoftSpheres random_spheres(std::vector<double> radii, double fraction, double list_skin, std::uint64_t seed) {
  const double side = std::cbrt(total_volume(radii) / fraction);
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const auto draw = [&](std::uint32_t k) { return side * uniform(seed, Stream::fill, i, k); };
    points.push_back({draw(0), draw(1), draw(2)});
  }
  return {std::move(points), std::move(radii), side, list_skin};
}

/// Random points in a vessel. If a point is still outside after a thousand draws, it stays; the faces push it in later.
std::vector<Vec3d> points_in(const Vessel& vessel, int count, std::uint64_t seed, std::uint64_t first) {
  constexpr std::uint32_t draws = 3000;
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) {
    const auto draw = [&](std::uint32_t k) {
      return vessel.reach * (2 * uniform(seed, Stream::fill, first + static_cast<std::uint64_t>(i), k) - 1);
    };
    Vec3d p{0, 0, 0};
    bool inside = false;
    for (std::uint32_t k = 0; !inside && k < draws; k += 3) {
      p = {draw(k), draw(k + 1), draw(k + 2)};
      inside = std::all_of(vessel.faces.begin(), vessel.faces.end(),
                           [&](const Vessel::Face& face) { return dot(face.normal, p) <= face.offset - 1; });
    }
    points.push_back(p);
  }
  return points;
}

/// Grows the cube until the overlaps are negligible, and wraps the centres into it.
Packing hardened(SoftSpheres soft) {
  soft.scale(soft.growth_to(largest_overlap));
  Packing packing;
  packing.side = soft.side();
  packing.fraction = soft.fraction();
  packing.overlap = soft.largest_overlap();
  packing.radii = soft.radii();
  for (const Vec3d& x : soft.centres()) {
    const auto wrap = [&](double c) { return c - packing.side * std::floor(c / packing.side); };
    packing.centres.push_back({wrap(x.x), wrap(x.y), wrap(x.z)});
  }
  return packing;
}

/// Shrinks the cube, in smaller and smaller steps of the fraction, while the overlaps still relax.
void compress(SoftSpheres& spheres) {
  constexpr double first_gain = 0.03, min_gain = 0.001;
  constexpr int steps = 600;
  for (double gain = first_gain; gain > min_gain;) {
    SoftSpheres denser = spheres;
    denser.scale(std::cbrt(spheres.fraction() / (spheres.fraction() + gain)));
    if (denser.settle(0, steps, largest_overlap))
      spheres = std::move(denser);
    else
      gain /= 2;
  }
}

/// Moves loose spheres to their neighbours by a short-ranged attraction.
void gather_loose(SoftSpheres& spheres) {
  constexpr double cohesion = 0.002, reach = 0.15;
  spheres.set_cohesion(cohesion, reach);
  spheres.settle(0, 200);
  spheres.set_cohesion(0, 0);
  spheres.settle(0, 2000, largest_overlap);
}

}  // namespace

Packing jam_spheres(int spheres, std::uint64_t seed) {
  constexpr double list_skin = 0.3;
  SoftSpheres soft = random_spheres(std::vector<double>(spheres, 1.0), soft_fraction, list_skin, seed);
  soft.settle(1e-4, 5000);
  return hardened(std::move(soft));
}

const Packing& rock_packing() {
  static const Packing packing = jam_spheres(2500, 1);
  return packing;
}

// The density of volume over size is proportional to x^(m - 1), so that of the number to x^(m - 4).
double radius_at(const Grading& grading, double u) {
  const double e = grading.exponent - 3;
  if (std::abs(e) < 1e-6) return std::pow(grading.ratio, u);
  return std::pow(1 - u * (1 - std::pow(grading.ratio, e)), 1 / e);
}

double mean_cubed_radius(const Grading& grading) {
  if (grading.ratio < 1 + 1e-9) return 1;
  const double m = grading.exponent, e = m - 3;
  const double volume = (std::pow(grading.ratio, m) - 1) / m;
  const double number = std::abs(e) < 1e-6 ? std::log(grading.ratio) : (std::pow(grading.ratio, e) - 1) / e;
  return volume / number;
}

Packing jam_graded(const Grading& grading, std::uint64_t seed) {
  constexpr double list_skin = 0.8, loose_fraction = 0.58, guess = 0.66, largest_diameters = 5;
  constexpr int min_spheres = 400;
  const double cube = std::pow(2 * largest_diameters * grading.ratio, 3);
  const int count = std::max(min_spheres, static_cast<int>(guess * cube / sphere_volume / mean_cubed_radius(grading)));
  std::vector<double> radii;
  for (int k = 0; k < count; ++k) radii.push_back(radius_at(grading, (k + 0.5) / count));
  SoftSpheres soft = random_spheres(std::move(radii), loose_fraction, list_skin, seed);
  soft.settle(0, 3000, largest_overlap);
  compress(soft);
  gather_loose(soft);
  return hardened(std::move(soft));
}

Packing jam_in(Vessel vessel, int spheres, std::uint64_t seed, std::uint64_t first) {
  constexpr double list_skin = 0.5, loose_fraction = 0.45;
  scale(vessel, std::cbrt(spheres * sphere_volume / loose_fraction / vessel.volume));
  std::vector<Vec3d> points = points_in(vessel, spheres, seed, first);
  SoftSpheres soft(std::move(points), std::vector<double>(spheres, 1.0), std::move(vessel), list_skin);
  soft.settle(0, 3000, largest_overlap);
  compress(soft);
  gather_loose(soft);
  soft.scale(soft.growth_to(largest_overlap));
  return {soft.side(), soft.centres(), soft.radii(), soft.fraction(), soft.largest_overlap()};
}

const Packing& rock_packing(const Grading& grading) {
  struct Entry {
    std::once_flag made;
    Packing packing;
  };
  static std::mutex guard;
  static std::map<Grading, std::unique_ptr<Entry>> entries;
  Entry* entry;
  {
    const std::lock_guard<std::mutex> lock(guard);
    std::unique_ptr<Entry>& found = entries[grading];
    if (!found) found = std::make_unique<Entry>();
    entry = found.get();
  }
  std::call_once(entry->made, [&] { entry->packing = jam_graded(grading, 1); });
  return entry->packing;
}

}  // namespace gyro
