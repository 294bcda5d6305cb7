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
       .description = "share of the mass that passes each sieve of `sizes`; zeros without mass. Below the attribute "
                      "`resolution` of the group it is incomplete, because particles are the smallest pieces",
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
       .description = "size that 80 % of the mass pass; NaN without mass. Pieces finer than particles are not in it"},
      {.name = "p50",
       .units = "m",
       .value = [](const Row& r) { return r.curve.p50; },
       .description = "size that 50 % of the mass pass; NaN without mass. Pieces finer than particles are not in it"},
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

/// Columns of what is estimated.
std::vector<Column<CurveReading>> fines_columns() {
  return {
      {.name = "passing_with_fines",
       .units = "1",
       .value = [](const Row& r) -> std::span<const double> { return r.fines->passing; },
       .description = "estimate of the share of the mass that passes each sieve of `sizes`, with the pieces finer than "
                      "particles that the law of output.fines gives; zeros without mass",
       .presence = with_fines,
       .array = "sieve"},
      {.name = "p80_with_fines",
       .units = "m",
       .value = [](const Row& r) { return r.fines->p80; },
       .description = "size that 80 % of the mass pass, from passing_with_fines; NaN without mass",
       .presence = with_fines},
      {.name = "p50_with_fines",
       .units = "m",
       .value = [](const Row& r) { return r.fines->p50; },
       .description = "size that 50 % of the mass pass, from passing_with_fines; NaN without mass",
       .presence = with_fines},
      {.name = "fines_share",
       .units = "1",
       .value = [](const Row& r) { return r.fines->share; },
       .description = "estimated share of the mass that is finer than the coarsest particle of its fragment; NaN "
                      "without mass",
       .presence = with_fines},
      {.name = "released_energy",
       .units = "J/kg",
       .value = [](const Row& r) { return r.fines->energy; },
       .description = "elastic energy that the broken bonds of this rock released / its mass; NaN without mass",
       .presence = with_fines},
      {.name = "t10",
       .units = "1",
       .value = [](const Row& r) { return r.fines->t10; },
       .description =
           "share finer than a tenth of the size that a rock was fed with, by its released energy, mean over "
           "the mass; NaN without mass",
       .presence = with_t10},
      {.name = "beyond_share",
       .units = "1",
       .value = [](const Row& r) { return r.fines->beyond_share; },
       .description = "share of the mass with a t10 above 40 %, more than is usual in crushers: the estimate is an "
                      "extrapolation there; NaN without mass",
       .presence = with_t10},
  };
}

std::vector<Column<CurveReading>> all_columns() {
  std::vector<Column<CurveReading>> columns = curve_columns();
  for (Column<CurveReading>& column : fines_columns()) columns.push_back(std::move(column));
  return columns;
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
      .columns = all_columns()};
  return table;
}

const Table<CurveReading>& holdup_table() {
  static const Table<CurveReading> table{.group = "/holdup",
                                         .rows =
                                             "sieve analysis of all that is in the scene and neither discharged nor "
                                             "escaped, one row with each row of /series",
                                         .presence = with_product,
                                         .columns = all_columns()};
  return table;
}

const std::vector<CurveAttribute>& curve_attributes() {
  static const std::vector<CurveAttribute> attributes{
      {"resolution", "m", &Resolution::coarsest,
       "size of the coarsest particle of rock that can break, as the curves count it: finer rock is incomplete in "
       "them, "
       "because particles are the smallest pieces"},
      {"finest_particle", "m", &Resolution::finest,
       "size of the finest particle of rock that can break: the curves have nothing that is finer, and what real rock "
       "has there is unknown"}};
  return attributes;
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
