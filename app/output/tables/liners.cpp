// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/tables.hpp"

namespace gyro {
namespace {

using hdf5::Number;
using Row = LinerReading;

constexpr Presence with_wear{"with output.liners.wear_coefficient", [](const OutputForm& f) { return f.wear; }};

}  // namespace

const Table<LinerReading>& liner_cells_table() {
  static const Table<LinerReading> table{
      .group = "/liners/<wall>",
      .rows =
          "maps of a wall in its own frame, unrolled into cells (rows x sectors, one row of sectors after the other); "
          "one row every output.liners.interval",
      .presence = with_liners,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Row& r) { return r.time; },
           .description = "simulated time at the end of the map's interval"},
          {.name = "pressure",
           .units = "Pa",
           .value = [](const Row& r) -> std::span<const double> { return r.pressure; },
           .description = "normal force of the rock on a cell / its area",
           .sampled = Sampling::mean,
           .number = Number::float32,
           .array = "cell"},
          {.name = "work",
           .units = "J",
           .value = [](const Row& r) -> std::span<const double> { return r.work; },
           .description = "work of sliding friction on a cell",
           .sampled = Sampling::sum,
           .number = Number::float32,
           .array = "cell"},
      }};
  return table;
}

const Table<LinerReading>& liner_triangles_table() {
  static const Table<LinerReading> table{
      .group = "/liners/<wall>/triangles",
      .rows = "maps of a wall by triangle over the whole run, one row at its end",
      .presence = with_liners,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Row& r) { return r.time; },
           .description = "simulated time at the end of the run"},
          {.name = "pressure",
           .units = "Pa",
           .value = [](const Row& r) -> std::span<const double> { return r.pressure; },
           .description = "normal force of the rock on a triangle / its area, over the whole run",
           .sampled = Sampling::mean,
           .number = Number::float32,
           .array = "triangle"},
          {.name = "work",
           .units = "J",
           .value = [](const Row& r) -> std::span<const double> { return r.work; },
           .description = "work of sliding friction on a triangle, over the whole run",
           .sampled = Sampling::sum,
           .number = Number::float32,
           .array = "triangle"},
          {.name = "wear",
           .units = "m",
           .value = [](const Row& r) -> std::span<const double> { return r.wear; },
           .description = "depth worn from a triangle over the whole run",
           .presence = with_wear,
           .sampled = Sampling::sum,
           .number = Number::float32,
           .array = "triangle"},
      }};
  return table;
}

const Table<LinerShape>& liner_shape_table() {
  static const Table<LinerShape> table{
      .group = "/liners/<wall>",
      .rows = "written once",
      .presence = with_liners,
      .columns = {
          {.name = "heights",
           .units = "m",
           .value = [](const LinerShape& l) -> std::span<const double> { return l.heights; },
           .description = "edges of the rows of cells along z, from the lowest; written once",
           .array = "edge"},
          {.name = "azimuths",
           .units = "rad",
           .value = [](const LinerShape& l) -> std::span<const double> { return l.azimuths; },
           .description = "edges of the sectors about z; written once",
           .array = "edge"},
          {.name = "area",
           .units = "m2",
           .value = [](const LinerShape& l) -> std::span<const double> { return l.area; },
           .description = "area of the surface in each cell; written once",
           .array = "cell"},
          {.name = "corners",
           .units = "m",
           .value = [](const LinerShape& l) -> std::span<const double> { return l.corners; },
           .description = "x, y, z of the three corners of each triangle; written once",
           .array = "coordinate"},
      }};
  return table;
}

}  // namespace gyro
