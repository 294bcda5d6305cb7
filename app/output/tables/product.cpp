// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/tables.hpp"

namespace gyro {
namespace {

using Row = CurveReading;

/// Share of the mass that passes a size, read between two sieves; none without mass and outside the sieves.
std::optional<double> below(const CurveReading& r, double size) {
  return r.curve.mass > 0 ? passing_at(r.curve.sieves, r.curve.passing, size) : std::nullopt;
}

std::vector<Column<CurveReading>> curve_columns() {
  return {
      {.name = "time",
       .units = "s",
       .value = [](const Row& r) { return r.curve.time; },
       .description = "simulated time"},
      {.name = "passing",
       .units = "1",
       .value = [](const Row& r) -> std::span<const double> { return r.curve.passing; },
       .description = "share of the mass that passes each sieve of `sizes`; zeros without mass",
       .array = "sieve"},
      {.name = "mass", .units = "kg", .value = [](const Row& r) { return r.curve.mass; }, .description = "mass"},
      {.name = "fragments",
       .units = "1",
       .value = [](const Row& r) { return r.curve.fragments; },
       .description = "number of fragments; a particle without intact bonds is one"},
      {.name = "singles_share",
       .units = "1",
       .value = [](const Row& r) { return r.curve.singles_share; },
       .description = "share of the mass in single particles; 0 without mass"},
      {.name = "p80",
       .units = "m",
       .value = [](const Row& r) { return r.curve.p80; },
       .description = "size that 80 % of the mass pass; NaN without mass"},
      {.name = "p50",
       .units = "m",
       .value = [](const Row& r) { return r.curve.p50; },
       .description = "size that 50 % of the mass pass; NaN without mass"},
      {.name = "below_css",
       .units = "1",
       .value = [](const Row& r) { return below(r, r.closed_side_setting); },
       .description = "share of the mass that passes the closed side setting; NaN without mass or with a setting "
                      "outside the sieves"},
      {.name = "below_oss",
       .units = "1",
       .value = [](const Row& r) { return below(r, r.open_side_setting); },
       .description = "share of the mass that passes the open side setting; NaN without mass or with a setting outside "
                      "the sieves"},
  };
}

std::vector<Column<Sieves>> sieve_columns() {
  return {{.name = "sizes",
           .units = "m",
           .value = [](const Sieves& s) -> std::span<const double> { return s.sizes; },
           .description = "openings of the sieves of `passing`; written once",
           .array = "sieve"}};
}

}  // namespace

const Table<CurveReading>& product_table() {
  static const Table<CurveReading> table{
      .group = "/product",
      .rows = "sieve analysis of all that was discharged until `time`, one row with each row of /series",
      .presence = with_product,
      .columns = curve_columns()};
  return table;
}

const Table<CurveReading>& holdup_table() {
  static const Table<CurveReading> table{.group = "/holdup",
                                         .rows =
                                             "sieve analysis of all that is in the scene and neither discharged nor "
                                             "escaped, one row with each row of /series",
                                         .presence = with_product,
                                         .columns = curve_columns()};
  return table;
}

const Table<Sieves>& product_sieves() {
  static const Table<Sieves> table{
      .group = "/product", .rows = "written once", .presence = with_product, .columns = sieve_columns()};
  return table;
}

const Table<Sieves>& holdup_sieves() {
  static const Table<Sieves> table{
      .group = "/holdup", .rows = "written once", .presence = with_product, .columns = sieve_columns()};
  return table;
}

}  // namespace gyro
