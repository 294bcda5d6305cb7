// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid rotation neither loads nor unloads a bond.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/laws/bond/bond_load.hpp"
#include "core/rocks/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

/// Loads of a bond for the given positions of its ends, computed as in the kernel with load precision T.
template <class T>
BondLoad<double> load_of(const BondEnds<double>& ends) {
  const BondStrain<double> s = bond_strain(BondShape<double>{{1, 0, 0}, grain, 0.5}, ends);
  const BondStrain<T> strain{cast<T>(s.normal),       static_cast<T>(s.length), static_cast<T>(s.stretch),
                             static_cast<T>(s.along), cast<T>(s.shear),         static_cast<T>(s.twist),
                             cast<T>(s.bend)};
  const BondConstants<T> law = cast<T>(BondConstants<double>{paper_bonds(), 0, 1e-6});
  const BondSection<T> section{T(grain_bond), T(1), T(1), T(1), T(0.5), T(grain)};
  const BondLoad<T> load = BondLaw<ConstantStrength>::load(law, section, strain, {});
  return {cast<double>(load.force), cast<double>(load.torque_i), cast<double>(load.torque_j), 0, 0, 0, 0};
}

/// A bond under a shear force of 1 kN and a torque of 3 N m makes one revolution about an axis in a thousand steps.
/// @return the largest relative change of its loads in the rotating frame
template <class T>
double change_in_a_revolution(const Vec3d& axis) {
  const BondStiffness k(paper_bonds());
  const Vec3d span{grain, -1000 / k.shear, 0};
  const Quatd orientation_i = rotation_by({-1.5 / k.torsion, 0, 0}),
              orientation_j = rotation_by({1.5 / k.torsion, 0, 0});
  const BondLoad<double> first = load_of<T>({span, orientation_i, orientation_j});
  double largest = 0;
  for (int step = 1; step <= 1000; ++step) {
    const Quatd rotation = rotation_by((2 * pi * step / 1000 / norm(axis)) * axis);
    const BondLoad<double> now =
        load_of<T>({rotate(rotation, span), rotation * orientation_i, rotation * orientation_j});
    largest = std::max({largest, norm(rotate_back(rotation, now.force) - first.force) / 1000,
                        norm(rotate_back(rotation, now.torque_j) - first.torque_j) / norm(first.torque_j)});
  }
  return largest;
}

void one_revolution(Recorder& out) {
  const auto change =
      out.precision() == Precision::mixed ? change_in_a_revolution<float> : change_in_a_revolution<double>;
  const std::string theory = "objectivity (an incremental law with the normal at the end of a step: 1.22 in 1e4 steps)";
  out.absolute("about-a-diagonal", change({1, 1, 1}), 0, {1e-9, 1e-6}, theory);
  out.absolute("about-its-own-axis", change({1, 0, 0}), 0, {1e-9, 1e-6}, theory);
  out.absolute("across", change({0, 0, 1}), 0, {1e-9, 1e-6}, theory);
}

/// A cube of eight spheres. The rest lengths of its bonds do not fit together, so that all bonds are stretched, sheared
/// and bent. They are symmetric under half a revolution about z; therefore z remains a principal axis, about which the
/// cube rotates steadily.
NewRock stressed_cube() {
  NewRock rock = lattice(0, 2);
  for (NewBond& b : rock.bonds) {
    const int i = b.i ^ 3, j = b.j ^ 3;  // the spheres that take the places of the ends after half a revolution
    const int key = std::min(8 * b.i + b.j, 8 * std::min(i, j) + std::max(i, j));
    b.length *= 1 + 1e-3 * random_number(static_cast<std::uint64_t>(key), 0);
  }
  return rock;
}

/// The cube rotates at 600 rad/s about the diagonal of the coordinate frame. After its oscillations have decayed, the
/// load of every bond is the same before and after a revolution.
void stressed_rock(Recorder& out) {
  constexpr double dt = 1e-6, angular_velocity = 600;  // 6e-4 rad a step
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.5;
  bonds.tensile_strength = bonds.shear_strength = 1e9;
  NewRock rock = stressed_cube();
  add_rigid_motion(rock, {0, 0, 0}, {0, 0, angular_velocity});
  const Quatd to_diagonal = rotation_by((std::acos(1 / std::sqrt(3.0)) / std::sqrt(2.0)) * Vec3d{-1, 1, 0});
  Stage stage(bonded_scene(dt, bonds), out.precision());
  stage.insert({placed(rock, 0, 0, {0, 0, 0}, to_diagonal)});
  const int revolution = static_cast<int>(std::llround(2 * pi / (angular_velocity * dt)));  // steps
  stage.advance(2 * revolution);
  const BondSnapshot before = stage.dem().bonds();
  stage.advance(revolution);
  const BondSnapshot after = stage.dem().bonds();
  double largest = 0, force = 0, stress = 0;
  for (std::size_t b = 0; b < before.size(); ++b) {
    force = std::max(force, std::abs(before.normal_force[b]));
    stress = std::max(stress, before.stress_ratio[b]);
  }
  for (std::size_t b = 0; b < before.size(); ++b)
    largest = std::max({largest, std::abs(after.normal_force[b] - before.normal_force[b]) / force,
                        std::abs(after.stress_ratio[b] - before.stress_ratio[b]) / stress});
  out.within("largest-force", force, 100, 3000, "the cube is under stress [N]");
  out.absolute("change-in-a-revolution", largest, 0, {1e-6, 1e-4}, "objectivity, at 6e-4 rad a step");
}

/// Stability limit of the time step for a cube of n^3 spheres [s].
double limit(int n, const BondParameters& bonds) {
  const NewRock rock = lattice(0, n, {.bond_radius = grain / 4});
  RockTemplate form;
  form.particle_density = rock_density;
  for (const NewParticle& p : rock.particles) {
    form.centres.push_back(p.position);
    form.radii.push_back(p.radius);
  }
  for (const NewBond& b : rock.bonds) form.bonds.push_back({b.i, b.j, b.length, b.radius});
  return critical_step(form, bonds, {});
}

/// A rock rotates at 100 rad/s for ten revolutions, with a step of 0.8 of the limit. The spheres at x = +-d/2, +-3d/2
/// pull outwards with m w^2 |x|, so that the bonds in the middle carry the largest force, 2 m w^2 d. If damping
/// combined the velocities at mid-step with the positions at the end of the step, it would add a spurious 2.4 % of this
/// force.
void no_spurious_stress(Recorder& out) {
  constexpr double angular_velocity = 100;
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.2;
  Stage stage(bonded_scene(0.8 * limit(4, bonds), bonds), out.precision());
  NewRock rock = lattice(0, 4, {.bond_radius = grain / 4});
  add_rigid_motion(rock, {0, 0, 0}, {0, 0, angular_velocity});
  stage.insert({rock});
  const double pull = sphere_mass(grain / 2, rock_density) * angular_velocity * angular_velocity * 2 * grain;
  const double ratio = pull / (pi * grain * grain / 16) / bonds.tensile_strength;
  const int revolution = static_cast<int>(std::llround(2 * pi / (angular_velocity * stage.dt())));  // steps
  stage.advance(revolution);  // the initial oscillation decays
  double largest = 0;
  for (int k = 0; k < 90; ++k) {
    stage.advance(revolution / 10);
    for (const double r : stage.dem().bonds().stress_ratio) largest = std::max(largest, r);
  }
  out.relative("largest-stress", largest, ratio, {1e-3, 1e-3}, "2 m w^2 d/(pi Rb^2)");
  out.absolute("broken-bonds", 144 - static_cast<double>(stage.dem().counts().bonds_intact), 0, {0, 0},
               "below the strength");
}

}  // namespace

std::vector<Verification> objectivity_cases() {
  return {
      {"objectivity/bond", one_revolution},
      {"objectivity/stressed-rock", stressed_rock},
      {"objectivity/ten-revolutions", no_spurious_stress},
  };
}

}  // namespace gyro::verify
