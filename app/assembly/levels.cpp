// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/levels.hpp"

#include "core/base/thread_team.hpp"
#include "core/rocks/load_table.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace gyro {
namespace {

/// A rock of one piece, neither too small nor too large.
bool has_table(const RockTemplate& rock) {
  return rock.centres.size() > 1 && static_cast<Index>(rock.centres.size()) <= max_rigid_particles &&
         largest_piece(rock.bonds, static_cast<Index>(rock.centres.size())).size() == rock.centres.size();
}

/// What the tables come to. @param rocks  of the library and the start
std::string note_on(const std::vector<LoadTable>& tables, std::size_t rocks) {
  double bytes = 0;
  for (const LoadTable& t : tables) bytes += sizeof(float) * static_cast<double>(t.numbers.size());
  char text[200];
  std::snprintf(
      text, sizeof text,
      "numerics.levels.rigid: %zu of %zu kinds of rocks may move as rigid bodies (at most %d particles in one "
      "piece); their load tables take %.3g MB",
      tables.size(), rocks, max_rigid_particles, 1e-6 * bytes);
  return text;
}

}  // namespace

std::string set_levels(Setup& setup, const Case& input, int threads) {
  if (!input.numerics.rigid) return {};
  RigidLevel level;
  level.bonded_above = input.numerics.rigid->bonded_above;
  level.rigid_below = input.numerics.rigid->rigid_below;
  level.calm_time = input.numerics.rigid->calm_time;
  if (input.numerics.rigid->pieces)
    level.response_of = [bonds = *setup.scene.bonds](const NewRock& rock) {
      return load_response(shape_of(rock), bonds);
    };
  std::vector<RockTemplate> rocks;
  const auto take = [&](const RockTemplate& rock, Index& place) {
    if (!has_table(rock)) return;
    place = static_cast<Index>(rocks.size());
    rocks.push_back(rock);
  };
  for (RockTemplate& rock : setup.library.rocks) take(rock, rock.load_table);
  for (NewRock& rock : setup.start) take(shape_of(rock), rock.load_table);
  std::vector<LoadTable> tables(rocks.size());
  ThreadTeam team(std::max(1, std::min(static_cast<int>(rocks.size()), threads > 0 ? threads : all_cores())));
  for_each_job(team, static_cast<int>(rocks.size()), [&](int k) {
    const auto n = static_cast<std::size_t>(k);
    tables[n] = load_table(rocks[n], *setup.scene.bonds);
  });
  const std::string note = note_on(tables, setup.library.rocks.size() + setup.start.size());
  level.tables = std::make_shared<const std::vector<LoadTable>>(std::move(tables));
  setup.scene.rigid = std::move(level);
  return note;
}

}  // namespace gyro
