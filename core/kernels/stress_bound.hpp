// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/math/select.hpp"
#include "core/scene/load_table.hpp"
#include "core/state/bodies.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

#include <cmath>

namespace gyro {

/// Whether something other than weight acts on a particle: without contacts the load is the weight, to the last bit.
GYRO_HD inline bool is_loaded(const ParticleView& p, const Vec3d& gravity, Index n) {
  return norm2(p.load[n].force - p.motion[n].mass * gravity) != 0 || norm2(p.load[n].torque) != 0;
}

/// Finds rigid rocks of which a bond is loaded beyond a share of its strength: first by the bound of LoadTable, then by
/// its responses, for the loads that act on the particles now.
template <class Real>
struct StressBound {
  static constexpr int at_once = 16;  ///< bonds

  const float* const* rows;  ///< LoadRow of each particle in a rigid rock; null: not made yet
  Block* blocks;
  const Body* bodies;
  const Real* strength;      ///< factor of each bond
  double allowed;            ///< largest ratio of stress and strength [-]
  std::int32_t* overloaded;  ///< set to 1 by any rock beyond it

  /// @param p  with the loads of all particles; the loaded ones have their rows
  GYRO_HD void look(const ParticleView& p, const Vec3d& gravity, Index k) const {
    if (blocks[k].overloaded) return;  // it has no rows
    Loaded loaded[max_rigid_particles];
    const int count = find_loaded(p, gravity, k, loaded);
    if (is_bounded(blocks[k], loaded, count) || bears(blocks[k], loaded, count)) return;
    blocks[k].overloaded = 1;
    if (!is_raised(overloaded)) raise_flag(overloaded);
  }

 private:
  struct Loaded {
    LoadRow<const float> row;
    float load[point_loads];  ///< frame of the table
    float force, moment;      ///< their sizes
  };

  /// @return number of loaded particles
  GYRO_HD int find_loaded(const ParticleView& p, const Vec3d& gravity, Index k, Loaded* loaded) const {
    const Block& block = blocks[k];
    const Quatd orientation = bodies[k].orientation * bodies[k].frame;  // of the table
    int count = 0;
    for (Index n = block.first_particle; n < block.end_particle; ++n) {
      if (!is_loaded(p, gravity, n)) continue;
      const Vec3d force = p.load[n].force - p.motion[n].mass * gravity, moment = p.load[n].torque;
      const Vec3<float> f = cast<float>(rotate_back(orientation, force)),
                        m = cast<float>(rotate_back(orientation, moment));
      loaded[count++] = {{rows[n], block.table_bonds}, {f.x, f.y, f.z, m.x, m.y, m.z}, norm(f), norm(m)};
    }
    return count;
  }

  GYRO_HD bool is_bounded(const Block& block, const Loaded* loaded, int count) const {
    const Index bonds = block.table_bonds;
    for (Index b = 0; b < bonds; b += at_once) {
      const Index some = bonds - b < at_once ? bonds - b : at_once;
      float ratio[at_once] = {};
      for (int l = 0; l < count; ++l) {
        const float *force = loaded[l].row.force() + b, *moment = loaded[l].row.moment() + b;
        for (Index n = 0; n < some; ++n) ratio[n] += loaded[l].force * force[n] + loaded[l].moment * moment[n];
      }
      if (!all_below(ratio, block.first_bond + b, some)) return false;
    }
    return true;
  }

  GYRO_HD bool bears(const Block& block, const Loaded* loaded, int count) const {
    const Index bonds = block.table_bonds;
    for (Index b = 0; b < bonds; b += at_once) {
      const Index some = bonds - b < at_once ? bonds - b : at_once;
      float s[bond_stresses][at_once] = {};
      for (int l = 0; l < count; ++l) {
        const float* row = loaded[l].row.response(0, 0) + b;
        for (int load = 0; load < point_loads; ++load)
          for (int stress = 0; stress < bond_stresses; ++stress, row += bonds)
            for (Index n = 0; n < some; ++n) s[stress][n] += loaded[l].load[load] * row[n];
      }
      float ratio[at_once];
      for (Index n = 0; n < some; ++n) {
        const float tension = s[0][n] + ::sqrtf(s[3][n] * s[3][n] + s[4][n] * s[4][n]);
        const float shear = ::sqrtf(s[1][n] * s[1][n] + s[2][n] * s[2][n]) + magnitude(s[5][n]);
        ratio[n] = larger(tension, shear);
      }
      if (!all_below(ratio, block.first_bond + b, some)) return false;
    }
    return true;
  }

  /// Whether these bonds, from `first` on, are below the allowed share of their strengths.
  GYRO_HD bool all_below(const float* ratio, Index first, Index some) const {
    for (Index n = 0; n < some; ++n)
      if (static_cast<double>(ratio[n]) > allowed * static_cast<double>(strength[first + n])) return false;
    return true;
  }
};

}  // namespace gyro
