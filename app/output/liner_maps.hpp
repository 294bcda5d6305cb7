// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/tables/table_writer.hpp"
#include "app/output/tables/tables.hpp"
#include "core/walls/surface_map.hpp"
#include "io/run/snapshots.hpp"

#include <vector>

namespace gyro {

/// The maps of `output.liners`: where rock presses on the walls and slides along them.
class LinerMaps {
 public:
  /// Of every wall but planes, on its picture. None when the case does not ask for maps.
  LinerMaps(const Case& input, const Assembly& assembly);

  /// Adds the groups of the maps to what results.h5 must have.
  void declare(ResultsContent& content) const;
  /// Takes in what the rock did to the walls in a window; writes the maps that are due.
  void take(const std::vector<WallImpulse>& impulses, double time, ResultsFile& results);
  /// Writes what is left, and the maps by triangle.
  void close(ResultsFile& results);

  /// What the rock has done to a wall so far; nothing without a map of it.
  std::optional<WallLoads> loads(Index wall) const;

  void save(SavedState& to) const;
  /// @throws BadInput for maps of another size
  void restore(const SavedState& from);

 private:
  struct Mapped {
    Index wall;
    std::string name;
    double friction;  ///< of rock on it [-]
    SurfaceMap map;
    TableWriter<LinerReading> cells, triangles;
  };
  struct Times {
    double now = 0, written = 0;  ///< of the last window, of the last map [s]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("now", s.now...);
      f("written", s.written...);
    }
  };
  void write(ResultsFile& results);
  WallLoads loads_of(const Mapped& mapped) const;

  std::optional<CaseLinerMaps> asked_;
  OutputForm form_;
  std::vector<Mapped> maps_;
  Times times_;
};

}  // namespace gyro
