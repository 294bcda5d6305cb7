// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/library_file.hpp"

#include "io/hdf5/hdf5.hpp"
#include "io/run/snapshots.hpp"

#include <numbers>

namespace gyro {
namespace {

void write_rock(hdf5::File& file, const RockTemplate& rock) {
  const std::string group = "/rocks/" + rock.name;
  std::vector<double> centres, pairs, lengths, radii;
  for (const Vec3d& c : rock.centres) centres.insert(centres.end(), {c.x, c.y, c.z});
  for (const TemplateBond& b : rock.bonds) {
    pairs.insert(pairs.end(), {static_cast<double>(b.i), static_cast<double>(b.j)});
    lengths.push_back(b.length);
    radii.push_back(b.radius);
  }
  file.create_dataset(group + "/centres", {.columns = 3}).append(centres);
  file.write_numbers(group + "/radii", rock.radii);
  file.create_dataset(group + "/bonds", {.number = hdf5::Number::int32, .columns = 2}).append(pairs);
  file.create_dataset(group + "/bond_length", {}).append(lengths);
  file.create_dataset(group + "/bond_radius", {}).append(radii);
  for (const auto& [name, value] : {std::pair{"diameter", rock.diameter},
                                    {"solid_volume", rock.solid_volume},
                                    {"particle_density", rock.particle_density},
                                    {"packing_fraction", rock.packing_fraction},
                                    {"mass_error", rock.mass_error},
                                    {"inertia_error", rock.inertia_error},
                                    {"centre_error", rock.centre_error},
                                    {"coordination", rock.coordination},
                                    {"critical_step", rock.critical_step}})
    file.set_attribute(group, name, value);
}

/// A rock of the picture, moved along x.
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

void write_library(const RockLibrary& library, const std::filesystem::path& directory) {
  hdf5::File file = hdf5::File::create(directory / "library.h5");
  for (const RockTemplate& rock : library.rocks) write_rock(file, rock);
  file.close();
}

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
