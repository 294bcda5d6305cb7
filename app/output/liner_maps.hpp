// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/tables/table_writer.hpp"
#include "app/output/tables/tables.hpp"
#include "core/walls/surface_map.hpp"
#include "io/run/snapshots.hpp"

#include <vector>

namespace gyro {

/// The maps of `output.liners`: pressure, sliding work and wear of the walls.
class LinerMaps {
 public:
  /// Maps every wall except planes, on the mesh of its picture. No maps if the case does not ask for them.
  LinerMaps(const Case& input, const Assembly& assembly);

  /// Adds the groups of the maps to what results.h5 must have.
  void declare(ResultsContent& content) const;
  /// Adds the impulses of a window on the walls; writes the maps that are due.
  void take(const std::vector<WallImpulse>& impulses, double time, ResultsFile& results);
  /// Writes the last maps, and the maps by triangle.
  void close(ResultsFile& results);

  /// Loads of the rock on a wall since the start; none if the wall has no map.
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
