// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/base/expect.hpp"
#include "core/dem/bond_parts.hpp"
#include "core/dem/rigid_arrivals.hpp"
#include "core/scene/new_rock.hpp"
#include "core/scene/scene.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace gyro {

template <class T>
using HostColumn = std::vector<T>;

/// Throws when two bonds of a colour share a particle: a thread block adds the forces of a colour at once.
inline void check_colours(const NewRock& rock) {
  const auto wrong = [&](const char* what) {
    return BadInput("rock " + std::to_string(rock.id) + ": " + what +
                    "; bonds must be grouped by colour: colour_begin runs from 0 to the number of bonds, and no two "
                    "bonds of a colour share a particle");
  };
  const std::vector<Index>& begin = rock.colour_begin;
  if (rock.bonds.empty()) return;
  if (begin.empty() || begin.front() != 0 || begin.back() != static_cast<Index>(rock.bonds.size()))
    throw wrong("its colours do not cover its bonds");
  std::vector<Index> last_colour(rock.particles.size(), none);
  for (std::size_t c = 0; c + 1 < begin.size(); ++c)
    for (Index n = begin[c]; n < begin[c + 1]; ++n)
      for (const Index end : {rock.bonds[static_cast<std::size_t>(n)].i, rock.bonds[static_cast<std::size_t>(n)].j}) {
        Index& last = last_colour[static_cast<std::size_t>(end)];
        if (last == static_cast<Index>(c)) throw wrong("two bonds of one colour share a particle");
        last = static_cast<Index>(c);
      }
}

/// Rock on its way into a scene: rows for the end of each column, put together on the host.
template <class Real>
class Arrivals {
 public:
  /// How much is in the scene already.
  struct Present {
    Index particles = 0, bonds = 0, blocks = 0, colours = 0;
    bool with_bonds = false;
    bool with_rigid = false;   ///< rocks may move as rigid bodies
    bool with_pieces = false;  ///< so may rocks without a load table, and pieces
  };

  /// @param exchanged  EnergyTerms::exchanged before they arrive [J]
  Arrivals(const Present& present, const Scene& scene, double exchanged)
      : present_(present), gravity_(scene.gravity), dt_(scene.dt), substeps_(scene.substeps), exchanged_(exchanged) {}

  /// Takes the memory of these rocks at once, so that columns take what they need and no more.
  void reserve(std::span<const NewRock> rocks) {
    std::size_t particles = 0, bonds = 0;
    for (const NewRock& rock : rocks) {
      particles += rock.particles.size();
      bonds += (rock.bonds.size() + bond_alignment - 1) / bond_alignment * bond_alignment;
    }
    const auto reserve_rows = [](std::size_t rows) {
      return [rows](const char*, auto& column) { column.reserve(rows); };
    };
    Particles<HostColumn>::for_each_common_column(reserve_rows(particles), particles_);
    if (!present_.with_bonds) return;
    Particles<HostColumn>::for_each_bonded_column(reserve_rows(particles), particles_);
    Bonds<HostColumn, Real>::for_each_column(reserve_rows(bonds), bonds_);
  }

  /// @throws BadInput for bonds that are not grouped by colour, or whose first particle has the higher id
  void add(const NewRock& rock) {
    const Index first = present_.particles + size_of(particles_.position);
    const bool is_rock = rock.id != none;
    const Index block = is_rock ? present_.blocks + size_of(blocks_) : none;
    const bool bonded = present_.with_bonds && !rock.bonds.empty();
    const int substeps = !bonded ? 1 : rock.substeps > 0 ? rock.substeps : substeps_;
    const bool free_of_load = bonded && is_rock && is_free_of_load(rock);
    const bool rigid = free_of_load && static_cast<Index>(rock.particles.size()) <= max_rigid_particles &&
                       arrives_without_rotation(rock);
    for (const NewParticle& p : rock.particles) add_particle(p, block, rigid ? 1 : substeps);
    if (!is_rock) return;
    const Index end = first + size_of(rock.particles);
    Block b{first,   end, bond_count(), 0, colour_count(), 0, rock.id, rock.bonds.empty() ? block_broken : block_intact,
            substeps};
    if (present_.with_bonds) add_bonds(rock, first, substeps);
    b.end_bond = bond_count();
    b.end_colour = colour_count();
    b.table = free_of_load ? rock.load_table : none;
    b.table_bonds = bonded ? static_cast<Index>(rock.bonds.size()) : 0;
    b.free_of_load = free_of_load ? 1 : 0;
    b.rigid = rigid ? 1 : 0;
    blocks_.push_back(b);
  }

  /// Their rows, which the scene may take away.
  Particles<HostColumn>& particles() { return particles_; }
  Bonds<HostColumn, Real>& bonds() { return bonds_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  const std::vector<Index>& colour_begin() const { return colour_begin_; }
  const std::vector<std::int32_t>& colour_starts() const { return colour_starts_; }
  std::int64_t bonds_intact() const { return bonds_intact_; }
  std::int64_t bonds_in_step() const { return bonds_in_step_; }  ///< as Monitor::bonds_in_step()
  double exchanged() const { return exchanged_; }                ///< EnergyTerms::exchanged with the new rock [J]

 private:
  template <class T>
  static Index size_of(const std::vector<T>& rows) {
    return static_cast<Index>(rows.size());
  }
  /// Always false where rocks of its kind are never rigid.
  bool is_free_of_load(const NewRock& rock) const {
    if (!present_.with_rigid || (rock.load_table == none && !present_.with_pieces)) return false;
    return !is_large_rock(static_cast<Index>(rock.bonds.size())) && arrives_free_of_load(rock) &&
           (rock.load_table != none || arrives_in_one_piece(rock));
  }
  Index bond_count() const { return present_.bonds + size_of(bonds_.i); }
  Index colour_count() const { return present_.colours + size_of(colour_begin_); }

  void add_particle(const NewParticle& p, Index block, int substeps) {
    Particles<HostColumn>& to = particles_;
    const double mass = mass_of(p);
    to.position.push_back({p.position, p.radius});
    to.motion.push_back({p.velocity, mass});
    to.angular_motion.push_back({p.angular_velocity, 0.4 * mass * p.radius * p.radius});
    Load load;
    load.force = mass * gravity_;
    to.load.push_back(load);
    if (present_.with_bonds) {
      to.orientation.push_back({1, 0, 0, 0});
      to.bond_load.push_back({});
    }
    to.step.push_back(dt_ / substeps);
    to.losses.push_back({});
    to.damping_rate.push_back(0);
    to.id.push_back(p.id);
    to.block.push_back(block);
    exchanged_ += 0.5 * mass * norm2(p.velocity) + 0.2 * mass * p.radius * p.radius * norm2(p.angular_velocity) -
                  mass * dot(gravity_, p.position);
  }

  void add_bonds(const NewRock& rock, Index first_particle, int substeps) {
    check_colours(rock);
    if (!is_large_rock(static_cast<Index>(rock.bonds.size()))) {
      add_colours(rock.colour_begin);
      colour_starts_.resize(colour_begin_.size(), starts_colour);
      for (const NewBond& bond : rock.bonds) add_bond(rock, bond, first_particle);
    } else {
      const BondParts parts = bond_parts(rock);
      add_colours(parts.colour_begin);
      colour_starts_.insert(colour_starts_.end(), parts.starts.begin(), parts.starts.end());
      for (const Index n : parts.bond) add_bond(rock, rock.bonds[static_cast<std::size_t>(n)], first_particle);
    }
    bonds_intact_ += static_cast<std::int64_t>(rock.bonds.size());
    bonds_in_step_ += static_cast<std::int64_t>(rock.bonds.size()) * substeps;
    while (bonds_.i.size() % bond_alignment != 0) {
      Bonds<HostColumn, Real>::for_each_column([](const char*, auto& column) { column.push_back({}); }, bonds_);
      bonds_.i.back() = bonds_.j.back() = first_particle;
      bonds_.state.back() = bond_broken;
    }
  }

  void add_colours(const std::vector<Index>& begin) {
    const Index first_bond = bond_count();
    for (const Index bond : begin) colour_begin_.push_back(first_bond + bond);
  }

  void add_bond(const NewRock& rock, const NewBond& bond, Index first_particle) {
    const auto k = static_cast<std::size_t>(bond.i), l = static_cast<std::size_t>(bond.j);
    GYRO_EXPECT(k < rock.particles.size() && l < rock.particles.size());
    const NewParticle &p = rock.particles[k], &q = rock.particles[l];
    if (p.id >= q.id)
      throw BadInput("a bond of rock " + std::to_string(rock.id) + " joins particles " + std::to_string(p.id) +
                     " and " + std::to_string(q.id) + " in the wrong order; the lower id must come first");
    const Vec3d span = q.position - p.position;
    const Vec3d axis = (1 / norm(span)) * span;
    const auto offset = static_cast<std::size_t>(first_particle - present_.particles);
    const double mi = particles_.motion[offset + k].mass, mj = particles_.motion[offset + l].mass;
    const double si = particles_.angular_motion[offset + k].inertia, sj = particles_.angular_motion[offset + l].inertia;
    Bonds<HostColumn, Real>& to = bonds_;
    to.i.push_back(first_particle + bond.i);
    to.j.push_back(first_particle + bond.j);
    to.axis_x.push_back(static_cast<Real>(axis.x));
    to.axis_y.push_back(static_cast<Real>(axis.y));
    to.axis_z.push_back(static_cast<Real>(axis.z));
    to.length.push_back(bond.length);
    to.radius.push_back(static_cast<Real>(bond.radius));
    to.arm.push_back(static_cast<Real>((bond.length + p.radius - q.radius) / (2 * bond.length)));
    to.strength.push_back(static_cast<Real>(bond.strength));
    to.sqrt_mass.push_back(static_cast<Real>(std::sqrt(mi * mj / (mi + mj))));
    to.sqrt_inertia.push_back(static_cast<Real>(std::sqrt(si * sj / (si + sj))));
    to.state.push_back(bond_intact);
  }

  Present present_;
  Vec3d gravity_;
  double dt_;     ///< of the scene [s]
  int substeps_;  ///< of a rock that does not say
  double exchanged_;
  std::int64_t bonds_intact_ = 0, bonds_in_step_ = 0;
  Particles<HostColumn> particles_;
  Bonds<HostColumn, Real> bonds_;
  std::vector<Block> blocks_;
  std::vector<Index> colour_begin_;
  std::vector<std::int32_t> colour_starts_;
};

}  // namespace gyro
