// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drive.hpp"

#include <string>
#include <vector>

namespace gyro {

/// Properties of a run that determine which outputs it has.
struct OutputForm {
  bool drive = false, mantle = false, feed = false, product = false, bonds = false;
  DriveKnowledge drive_knows = {};
  std::vector<std::string> walls = {};   ///< names of all walls but the first gyrating one
  std::vector<std::string> probes = {};  ///< ids of the particles that the series follow
  bool liners = false, wear = false;     ///< whether the case asks for liner maps, and for wear in them
  bool levels = false;                   ///< whether rocks may move as rigid bodies
  bool fines = false, t10 = false;       ///< whether the case asks for fines, and for their t10
};

/// Condition for a table or a column.
struct Presence {
  const char* text;                  ///< completes "present ...", for example "with bonds"
  bool (*holds)(const OutputForm&);  ///< whether it is present in a run
};

inline constexpr Presence always{"always", [](const OutputForm&) { return true; }};
inline constexpr Presence with_drive{"with a drivetrain", [](const OutputForm& f) { return f.drive; }};
inline constexpr Presence with_mantle{"with a gyrating wall", [](const OutputForm& f) { return f.mantle; }};
inline constexpr Presence with_feed{"with a feed", [](const OutputForm& f) { return f.feed; }};
inline constexpr Presence with_product{"with a crusher", [](const OutputForm& f) { return f.product; }};
inline constexpr Presence with_bonds{"with bonds", [](const OutputForm& f) { return f.bonds; }};
inline constexpr Presence with_levels{"with numerics.levels.rigid", [](const OutputForm& f) { return f.levels; }};
inline constexpr Presence with_liners{"with output.liners", [](const OutputForm& f) { return f.liners; }};
inline constexpr Presence with_fines{"with output.fines", [](const OutputForm& f) { return f.fines; }};
inline constexpr Presence with_t10{"with output.fines.breakage", [](const OutputForm& f) { return f.t10; }};

}  // namespace gyro
