// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/bond_colours.hpp"
#include "core/scene/new_rock.hpp"
#include "core/state/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace gyro {

/// An order of a large rock's bonds in which threads can share them: cells of space are parts, whose particles fit
/// into a core's cache; parts of one round share no particle, and are worked on at the same time. Within a part, bonds
/// are grouped by colour.
struct BondParts {
  std::vector<Index> bond;           ///< bond of the rock at each place
  std::vector<Index> colour_begin;   ///< place of the first bond of each colour; the last entry is the number of bonds
  std::vector<std::int32_t> starts;  ///< ColourStart of each entry of colour_begin; nothing starts with the last
};

namespace bond_parts_detail {

/// Mean number of bond lengths along the edge of a cell: some 70 particles.
inline constexpr double lengths_along_edge = 4;

/// Where the middle of a bond lies. Ordered by round, then by cell, then by the rock's order of bonds.
struct Place {
  int round;
  std::array<std::int64_t, 3> cell;
  Index bond;
  auto key() const { return std::tie(round, cell, bond); }
};

/// Cells of a round are two apart along some axis. Their edge is longer than any bond, so that bonds of two of them
/// share no particle.
inline std::vector<Place> places(const NewRock& rock) {
  const auto end = [&](Index k) { return rock.particles[static_cast<std::size_t>(k)].position; };
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3d low{infinity, infinity, infinity};
  double longest = 0, sum = 0;
  for (const NewBond& b : rock.bonds) {
    const Vec3d middle = 0.5 * (end(b.i) + end(b.j));
    low = {std::min(low.x, middle.x), std::min(low.y, middle.y), std::min(low.z, middle.z)};
    const double length = norm(end(b.j) - end(b.i));
    longest = std::max(longest, length);
    sum += length;
  }
  const double edge = std::max(1.001 * longest, lengths_along_edge * sum / static_cast<double>(rock.bonds.size()));
  std::vector<Place> out;
  for (const NewBond& b : rock.bonds) {
    const Vec3d from_low = (1 / edge) * (0.5 * (end(b.i) + end(b.j)) - low);
    const auto number = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    const std::array<std::int64_t, 3> cell{number(from_low.x), number(from_low.y), number(from_low.z)};
    const auto odd = [&](int axis) { return static_cast<int>(cell[static_cast<std::size_t>(axis)] & 1); };
    out.push_back({odd(0) + 2 * odd(1) + 4 * odd(2), cell, static_cast<Index>(out.size())});
  }
  std::sort(out.begin(), out.end(), [](const Place& a, const Place& b) { return a.key() < b.key(); });
  return out;
}

}  // namespace bond_parts_detail

/// @param rock  with bonds
inline BondParts bond_parts(const NewRock& rock) {
  const std::vector<bond_parts_detail::Place> places = bond_parts_detail::places(rock);
  BondColours colours(rock.particles.size());
  BondParts parts;
  for (std::size_t first = 0, end; first < places.size(); first = end) {
    const bool new_round = first == 0 || places[first].round != places[first - 1].round;
    std::vector<std::vector<Index>> groups;
    for (end = first; end < places.size() && places[end].cell == places[first].cell; ++end) {
      const NewBond& b = rock.bonds[static_cast<std::size_t>(places[end].bond)];
      const std::size_t colour = colours.next(b.i, b.j);
      if (groups.size() <= colour) groups.resize(colour + 1);
      groups[colour].push_back(places[end].bond);
    }
    for (std::size_t c = 0; c < groups.size(); ++c) {
      parts.colour_begin.push_back(static_cast<Index>(parts.bond.size()));
      parts.starts.push_back(c > 0 ? starts_colour : new_round ? starts_round : starts_part);
      parts.bond.insert(parts.bond.end(), groups[c].begin(), groups[c].end());
      for (const Index n : groups[c]) {
        const NewBond& b = rock.bonds[static_cast<std::size_t>(n)];
        colours.forget(b.i), colours.forget(b.j);
      }
    }
  }
  parts.colour_begin.push_back(static_cast<Index>(parts.bond.size()));
  parts.starts.push_back(starts_colour);
  return parts;
}

}  // namespace gyro
