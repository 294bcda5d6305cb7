// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <cstddef>
#include <vector>

namespace gyro {

/// Colours bonds one after the other, so that two bonds of one colour share no particle: each gets the first colour
/// that is free at both ends. At most 2 z - 1 colours for z bonds a particle.
class BondColours {
 public:
  explicit BondColours(std::size_t particles) : taken_(particles) {}

  /// The colour of the next bond, between particles i and j.
  std::size_t next(Index i, Index j) {
    auto &at_i = taken_[static_cast<std::size_t>(i)], &at_j = taken_[static_cast<std::size_t>(j)];
    std::size_t colour = 0;
    while (is_taken(at_i, colour) || is_taken(at_j, colour)) ++colour;
    take(at_i, colour);
    take(at_j, colour);
    return colour;
  }
  /// Forgets the bonds of a particle: all colours are free there again.
  void forget(Index particle) { taken_[static_cast<std::size_t>(particle)].clear(); }

 private:
  using Taken = std::vector<bool>;  ///< colours in use at a particle
  static bool is_taken(const Taken& taken, std::size_t colour) { return colour < taken.size() && taken[colour]; }
  static void take(Taken& taken, std::size_t colour) {
    if (taken.size() <= colour) taken.resize(colour + 1);
    taken[colour] = true;
  }

  std::vector<Taken> taken_;
};

}  // namespace gyro
