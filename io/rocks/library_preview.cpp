// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/library_file.hpp"
#include "io/run/snapshots.hpp"

#include <numbers>

namespace gyro {
namespace {

/// Adds a rock to the picture, moved along x.
void show(const RockTemplate& rock, RockId number, double x, ParticleSnapshot& particles, BondSnapshot& bonds) {
  const auto first = static_cast<Index>(particles.size());
  for (std::size_t k = 0; k < rock.centres.size(); ++k) {
    const double r = rock.radii[k];
    particles.id.push_back(static_cast<ParticleId>(particles.size()));
    particles.rock.push_back(number);
    particles.fragment.push_back(first);
    particles.position.push_back(rock.centres[k] + Vec3d{x, 0, 0});
    particles.radius.push_back(r);
    particles.mass.push_back(rock.particle_density * 4.0 / 3 * std::numbers::pi * r * r * r);
  }
  particles.velocity.resize(particles.size(), {0, 0, 0});
  particles.angular_velocity.resize(particles.size(), {0, 0, 0});
  particles.force.resize(particles.size(), {0, 0, 0});
  for (const TemplateBond& b : rock.bonds) {
    bonds.i.push_back(first + b.i);
    bonds.j.push_back(first + b.j);
    bonds.radius.push_back(b.radius);
  }
  bonds.normal_force.resize(bonds.size(), 0);
  bonds.stress_ratio.resize(bonds.size(), 0);
}

}  // namespace

void write_library_preview(const RockLibrary& library, const std::filesystem::path& directory) {
  ParticleSnapshot particles;
  BondSnapshot bonds;
  double x = 0;
  for (std::size_t k = 0; k < library.rocks.size(); ++k) {
    const RockTemplate& rock = library.rocks[k];
    x += rock.bounding_radius;
    show(rock, static_cast<RockId>(k), x, particles, bonds);
    x += 1.2 * rock.bounding_radius;
  }
  SnapshotWriter(directory).write({0, &particles, bonds.size() > 0 ? &bonds : nullptr, {}});
}

}  // namespace gyro
