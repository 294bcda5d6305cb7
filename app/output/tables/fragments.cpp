// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/tables.hpp"

namespace gyro {

const Table<FragmentRecord>& fragments_table() {
  using hdf5::Number;
  using Row = FragmentRecord;
  static const Table<FragmentRecord> table{
      .group = "/fragments",
      .rows =
          "one row for each fragment: when an inspection finds that it has left the chamber, or at the end of the run. "
          "A single particle is a fragment too. In a run that ended with finite numbers at the end of a window, the "
          "masses add up to all rock",
      .presence = always,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Row& r) { return r.time; },
           .description = "simulated time at which the fragment had left, or the end of the run"},
          {.name = "place",
           .units = "1",
           .value = [](const Row& r) { return static_cast<std::int64_t>(r.place); },
           .description = "where it is: 0 in the chamber or scene, 1 discharged, 2 escaped over the rim",
           .number = Number::uint8},
          {.name = "id",
           .units = "1",
           .value = [](const Row& r) { return static_cast<std::int64_t>(r.id); },
           .description = "number of the fragment: the lowest id of its particles",
           .number = Number::uint32},
          {.name = "rock",
           .units = "1",
           .value = [](const Row& r) { return static_cast<std::int64_t>(r.rock); },
           .description = "number of the rock that the fragment belonged to",
           .number = Number::int32},
          {.name = "particles",
           .units = "1",
           .value = [](const Row& r) { return static_cast<std::int64_t>(r.particles); },
           .description = "number of its particles",
           .number = Number::int32},
          {.name = "mass", .units = "kg", .value = [](const Row& r) { return r.mass; }, .description = "mass"},
          {.name = "size",
           .units = "m",
           .value = [](const Row& r) { return r.size; },
           .description =
               "sieve size: the smallest square opening that it passes; of a single particle, that of the sphere of "
               "solid rock of its mass"},
          {.name = "position",
           .units = "m",
           .value = [](const Row& r) { return r.position; },
           .description = "centre of mass"},
          {.name = "velocity",
           .units = "m/s",
           .value = [](const Row& r) { return r.velocity; },
           .description = "velocity of the centre of mass"},
          {.name = "fed",
           .units = "s",
           .value = [](const Row& r) { return r.fed; },
           .description = "time at which its rock came into the scene; time - fed is its residence time"},
      }};
  return table;
}

}  // namespace gyro
