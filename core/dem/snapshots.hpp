// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/particle_store.hpp"
#include "core/dem/scene_laws.hpp"
#include "core/kernels/accounts.hpp"
#include "core/scene/snapshot.hpp"
#include "core/state/fragment_labels.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace gyro {

/// Rows of the particles in order of id: the columns are in another one.
inline std::vector<Index> rows_by_id(const std::vector<ParticleId>& id) {
  std::vector<Index> rows(id.size());
  std::iota(rows.begin(), rows.end(), 0);
  std::sort(rows.begin(), rows.end(),
            [&](Index a, Index b) { return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)]; });
  return rows;
}

/// The intact bonds of a scene, in their order.
struct IntactBonds {
  std::vector<std::size_t> bond;  ///< row in the store
  std::vector<Index> i, j;        ///< rows of its ends in a snapshot
};

template <class Exec, class Real>
IntactBonds intact_bonds(const ParticleStore<Exec, Real>& rock) {
  const auto& i = Exec::host(rock.bonds().i);
  const auto& j = Exec::host(rock.bonds().j);
  const auto& state = Exec::host(rock.bonds().state);
  const std::vector<Index> rows = rows_by_id(Exec::host(rock.particles().id));
  std::vector<Index> snapshot_row(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) snapshot_row[static_cast<std::size_t>(rows[k])] = static_cast<Index>(k);
  IntactBonds intact;
  const auto count = static_cast<std::size_t>(std::ranges::count(state, bond_intact));
  intact.bond.reserve(count);
  intact.i.reserve(count);
  intact.j.reserve(count);
  for (std::size_t b = 0; b < i.size(); ++b) {
    if (state[b] != bond_intact) continue;
    intact.bond.push_back(b);
    intact.i.push_back(snapshot_row[static_cast<std::size_t>(i[b])]);
    intact.j.push_back(snapshot_row[static_cast<std::size_t>(j[b])]);
  }
  return intact;
}

template <class Exec, class Real>
std::vector<Index> labels_of_fragments(const Exec& exec, const ParticleStore<Exec, Real>& rock) {
  const IntactBonds intact = intact_bonds(rock);
  return fragment_labels(rock.count(), intact.i, intact.j, exec.host_team());
}

/// @param gravity  [m/s2]
template <class Exec, class Real>
ParticleSnapshot particle_snapshot(const Exec& exec, const ParticleStore<Exec, Real>& rock, const Vec3d& gravity) {
  const auto& position = Exec::host(rock.particles().position);
  const auto& motion = Exec::host(rock.particles().motion);
  const auto& angular = Exec::host(rock.particles().angular_motion);
  const auto& load = Exec::host(rock.particles().load);
  const auto& id = Exec::host(rock.particles().id);
  const auto& block = Exec::host(rock.particles().block);
  const auto& blocks = Exec::host(rock.blocks());
  ParticleSnapshot s;
  s.fragment = labels_of_fragments(exec, rock);
  s.reserve(id.size());
  for (const Index row : rows_by_id(id)) {
    const auto k = static_cast<std::size_t>(row);
    s.id.push_back(id[k]);
    s.rock.push_back(block[k] == none ? none : blocks[static_cast<std::size_t>(block[k])].rock);
    s.position.push_back(position[k].x);
    s.velocity.push_back(motion[k].v);
    s.angular_velocity.push_back(angular[k].w);
    s.force.push_back(load[k].force - motion[k].mass * gravity);
    s.radius.push_back(position[k].radius);
    s.mass.push_back(motion[k].mass);
  }
  return s;
}

template <class Exec, class Real>
BondSnapshot bond_snapshot(Exec& exec, const ParticleStore<Exec, Real>& rock, const SceneLaws<Exec, Real>& laws) {
  BondSnapshot s;
  if (!rock.has_bonds()) return s;
  typename Exec::template Buffer<BondReading> readings;
  readings.resize(static_cast<std::size_t>(rock.bond_count()));
  exec.for_each("read bonds", rock.bond_count(),
                ReadBonds<Real>{rock.read(), rock.read_bonds(), laws.bond(), laws.bond_model(), readings.data()});
  const auto& now = Exec::host(readings);
  const auto& radius = Exec::host(rock.bonds().radius);
  IntactBonds intact = intact_bonds(rock);
  s.i = std::move(intact.i);
  s.j = std::move(intact.j);
  for (const std::size_t b : intact.bond) {
    s.normal_force.push_back(now[b].normal_force);
    s.stress_ratio.push_back(now[b].stress_ratio);
    s.radius.push_back(static_cast<double>(radius[b]));
  }
  return s;
}

}  // namespace gyro
