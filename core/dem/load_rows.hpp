// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/base/shared_counter.hpp"
#include "core/kernels/stress_bound.hpp"
#include "core/scene/scene.hpp"
#include "core/state/bodies.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

// Rows of load tables for rocks and pieces that have no table in common with others: made on the host when a particle
// is first loaded while its rock is rigid.

namespace gyro {

/// Rows of one rock.
struct OwnRows {
  std::unique_ptr<LoadResponse> response;
  std::vector<std::unique_ptr<float[]>> made;
};

/// Makes the rows that loaded particles lack, rock by rock. A rock for which that fails becomes bonded, for good.
template <class Real>
struct MakeRows {
  ParticleView p;
  ConstBondView<Real> b;
  Block* blocks;
  const Arm* arms;
  Vec3d gravity;
  const std::function<std::unique_ptr<LoadResponse>(const NewRock&)>* response_of;
  OwnRows* own;       ///< of each block
  const float** row;  ///< of each particle
  std::int32_t* overloaded;

  void operator()(Index k) const {
    if (!blocks[k].lacks_rows) return;
    blocks[k].lacks_rows = 0;
    try {
      make(k);
    } catch (const BadInput&) {
      blocks[k].free_of_load = 0;
      blocks[k].overloaded = 1;
      raise_flag(overloaded);
    }
  }

 private:
  void make(Index k) const {
    const Block& block = blocks[k];
    if (!own[k].response) own[k].response = (*response_of)(shape_of(block));
    const auto length = static_cast<std::size_t>(load_row_width) * static_cast<std::size_t>(block.table_bonds);
    for (Index n = block.first_particle; n < block.end_particle; ++n) {
      if (row[n] != nullptr || !is_loaded(p, gravity, n)) continue;
      own[k].made.push_back(std::make_unique_for_overwrite<float[]>(length));
      float* numbers = own[k].made.back().get();
      own[k].response->fill(n - block.first_particle, {numbers, block.table_bonds});
      row[n] = numbers;
    }
  }

  /// Without loads, in the frame of its arms.
  NewRock shape_of(const Block& block) const {
    NewRock rock{};
    rock.id = block.rock;
    for (Index n = block.first_particle; n < block.end_particle; ++n) {
      const double radius = arms[n].radius,
                   density = p.motion[n].mass / (4.0 / 3 * 3.14159265358979323846 * radius * radius * radius);
      rock.particles.push_back({p.id[n], arms[n].arm, {0, 0, 0}, {0, 0, 0}, radius, density});
    }
    for (Index n = block.first_bond; n < block.first_bond + block.table_bonds; ++n)
      rock.bonds.push_back({b.i[n] - block.first_particle, b.j[n] - block.first_particle, b.length[n],
                            static_cast<double>(b.radius[n]), 1});
    return rock;
  }
};

}  // namespace gyro
