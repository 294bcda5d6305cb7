// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "core/walls/surface_map.hpp"
#include "io/run/results.hpp"

#include <vector>

namespace gyro {

/// The maps of `output.liners`: where rock presses on the walls and slides along them.
class LinerMaps {
 public:
  /// Of every wall but planes, on its picture. None when the case does not ask for maps.
  LinerMaps(const Case& input, const Assembly& assembly);

  /// What results.h5 is to hold.
  std::vector<LinerMap> content() const;
  /// Takes what the rock did to the walls in a window, and writes the maps that are due.
  void take(const std::vector<WallImpulse>& impulses, double time, ResultsFile& results);
  /// Writes what is left, and the maps by triangle.
  void close(ResultsFile& results);

  void save(SavedState& to) const;
  void restore(const SavedState& from);

 private:
  struct Mapped {
    Index wall;
    std::string name;
    double friction;  ///< of rock on it
    SurfaceMap map;
  };
  void write(ResultsFile& results);

  std::optional<CaseLinerMaps> asked_;
  std::vector<Mapped> maps_;
  double time_ = 0, written_ = 0;  ///< [s]
};

}  // namespace gyro
