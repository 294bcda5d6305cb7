// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/tables.hpp"

namespace gyro {

const Table<Breakage>& breakage_table() {
  using hdf5::Number;
  static const Table<Breakage> table{
      .group = "/breakage",
      .rows = "one row a broken bond, in the order of time",
      .presence = with_bonds,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Breakage& b) { return b.time; },
           .description = "simulated time at which the bond broke"},
          {.name = "mode",
           .units = "1",
           .value = [](const Breakage& b) { return static_cast<std::int64_t>(b.mode); },
           .description = "1: in tension, 2: in shear",
           .number = Number::uint8},
          {.name = "position",
           .units = "m",
           .value = [](const Breakage& b) { return b.position; },
           .description = "middle of the bond at the end of the coupling window in which it broke"},
          {.name = "rock",
           .units = "1",
           .value = [](const Breakage& b) { return static_cast<std::int64_t>(b.rock); },
           .description = "number of the rock that the bond belonged to",
           .number = Number::int32},
          {.name = "i",
           .units = "1",
           .value = [](const Breakage& b) { return static_cast<std::int64_t>(b.i); },
           .description = "id of one particle of the bond",
           .number = Number::uint32},
          {.name = "j",
           .units = "1",
           .value = [](const Breakage& b) { return static_cast<std::int64_t>(b.j); },
           .description = "id of the other particle",
           .number = Number::uint32},
          {.name = "energy",
           .units = "J",
           .value = [](const Breakage& b) { return b.energy; },
           .description = "elastic energy that the bond released"},
      }};
  return table;
}

}  // namespace gyro
