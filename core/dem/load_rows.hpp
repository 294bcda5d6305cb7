// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/kernels/stress_bound.hpp"
#include "core/scene/scene.hpp"
#include "core/state/bodies.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

#include <memory>
#include <utility>
#include <vector>

// Rows of load tables for rocks and pieces that have no table in common with others: made on the host when a particle
// is loaded while its rock is rigid.

namespace gyro {

/// Rows of one rock, for particles that are loaded or were so when others were made.
struct OwnRows {
  std::unique_ptr<LoadResponse> response;
  std::vector<std::pair<Index, std::unique_ptr<float[]>>> made;  ///< particle, and its row

  bool empty() const { return !response; }
};

/// Makes the rows that loaded particles of a rock lack, and forgets those of particles that are loaded no more.
template <class Real>
struct MakeRows {
  ParticleView p;
  ConstBondView<Real> b;
  Block* blocks;
  const Arm* arms;
  Vec3d gravity;
  const RigidLevel& level;
  OwnRows* own;       ///< of each block
  const float** row;  ///< of each particle

  /// A rock for which no rows can be made becomes bonded, for good. @return whether rows were made
  bool operator()(Index k) const {
    blocks[k].lacks_rows = 0;
    try {
      forget(own[k]);
      make(own[k], blocks[k]);
    } catch (const BadInput&) {
      blocks[k].free_of_load = 0;
      blocks[k].overloaded = 1;
      return false;
    }
    return true;
  }

 private:
  void forget(OwnRows& rows) const {
    std::erase_if(rows.made, [&](const auto& made) {
      if (is_loaded(p, gravity, made.first)) return false;
      row[made.first] = nullptr;
      return true;
    });
  }

  void make(OwnRows& rows, const Block& block) const {
    if (!rows.response) rows.response = level.response_of(shape_of(block));
    const auto length = static_cast<std::size_t>(load_row_width) * static_cast<std::size_t>(block.table_bonds);
    for (Index n = block.first_particle; n < block.end_particle; ++n) {
      if (row[n] != nullptr || !is_loaded(p, gravity, n)) continue;
      rows.made.emplace_back(n, std::make_unique_for_overwrite<float[]>(length));
      float* numbers = rows.made.back().second.get();
      rows.response->fill(n - block.first_particle, {numbers, block.table_bonds});
      row[n] = numbers;
    }
  }

  /// Without loads, in the frame of its arms.
  NewRock shape_of(const Block& block) const {
    NewRock rock{};
    rock.id = block.rock;
    for (Index n = block.first_particle; n < block.end_particle; ++n) {
      const double radius = arms[n].radius, volume = 4.0 / 3 * 3.14159265358979323846 * radius * radius * radius;
      rock.particles.push_back({p.id[n], arms[n].arm, {0, 0, 0}, {0, 0, 0}, radius, p.motion[n].mass / volume});
    }
    for (Index n = block.first_bond; n < block.first_bond + block.table_bonds; ++n)
      rock.bonds.push_back({b.i[n] - block.first_particle, b.j[n] - block.first_particle, b.length[n],
                            static_cast<double>(b.radius[n]), 1});
    return rock;
  }
};

}  // namespace gyro
