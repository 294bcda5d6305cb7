// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/table_writer.hpp"
#include "app/output/tables/tables.hpp"
#include "core/base/saved_state.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cmath>
#include <set>

namespace gyro {
namespace {

struct Now {
  double time;
  std::optional<double> size;
  std::vector<Vec3d> forces;
  std::vector<double> cells;
};

struct Span {
  double length, power;
  Vec3d force;
};

const Table<Now, Span>& table() {
  static const Table<Now, Span> t{
      .group = "/t",
      .rows = "rows of a test",
      .presence = always,
      .columns = {
          {.name = "time", .units = "s", .value = [](const Now& n) { return n.time; }, .description = "time"},
          {.name = "power", .units = "W", .value = [](const Span& s) { return s.power; }, .description = "power"},
          {.name = "feed",
           .units = "1",
           .value = [](const Now&) { return 1.0; },
           .description = "f",
           .presence = with_feed},
          {.name = "size", .units = "m", .value = [](const Now& n) { return n.size; }, .description = "size"},
          {.name = "force", .units = "N", .value = [](const Span& s) { return s.force; }, .description = "force"},
          {.name = "force_<wall>",
           .units = "N",
           .value = [](const Now& n) -> std::span<const Vec3d> { return n.forces; },
           .description = "force on <wall>",
           .repeat = Repeat{"<wall>", &OutputForm::walls}},
          {.name = "cells",
           .units = "Pa",
           .value = [](const Now& n) -> std::span<const double> { return n.cells; },
           .description = "cells",
           .sampled = Sampling::sum,
           .array = "cell"},
      }};
  return t;
}

OutputForm two_walls() {
  OutputForm form;
  form.walls = {"floor", "lid"};
  return form;
}

/// Names of a table, each once.
template <class Now, class Window>
void require_sound(const Table<Now, Window>& t) {
  std::set<std::string> names;
  for (const auto& column : t.columns) {
    INFO(t.group << "/" << column.name);
    CHECK(names.insert(std::string(column.name)).second);
    CHECK((column.value.shape() == Shape::array) == (std::string(column.array) != ""));
    CHECK((column.value.shape() == Shape::vectors) == column.repeat.has_value());
  }
}

}  // namespace

TEST_CASE("Header and rows of a table come from its columns: instants, means over windows, absent columns") {
  const ScratchDirectory scratch;
  TableWriter writer(table(), two_walls(), 2);
  std::vector<std::string> names;
  for (const Channel& channel : writer.declaration().channels) names.push_back(channel.name);
  CHECK(names == std::vector<std::string>{"time", "power", "size", "force", "force_floor", "force_lid", "cells"});
  ResultsContent content;
  content.groups = {writer.declaration()};
  {
    ResultsFile file(scratch.path() / "r.h5", content);
    writer.add({.length = 1, .power = 10, .force = {0, 0, 1}});
    writer.add({.length = 3, .power = 2, .force = {4, 0, 1}});
    CHECK(writer.length() == 4);
    writer.append(file, {4, 0.5, {{1, 2, 3}, {4, 5, 6}}, {7, 8}});
    CHECK(writer.length() == 0);
    writer.add({.length = 2, .power = 5, .force = {0, 0, 0}});
    writer.append(file, {6, std::nullopt, {{1, 2, 3}, {4, 5, 6}}, {9, 10}});
    file.close();
  }
  const hdf5::File file = hdf5::File::open(scratch.path() / "r.h5");
  CHECK(file.dataset("/t/time").read() == std::vector<double>{4, 6});
  CHECK(file.dataset("/t/power").read() == std::vector<double>{4, 5});
  CHECK(file.dataset("/t/power").string_attribute("sampling") == "mean");
  CHECK(file.dataset("/t/force").read() == std::vector<double>{3, 0, 1, 0, 0, 0});
  CHECK(file.dataset("/t/force_lid").read() == std::vector<double>{4, 5, 6, 4, 5, 6});
  CHECK(file.dataset("/t/force_lid").string_attribute("description") == "force on lid");
  CHECK(file.dataset("/t/size").read()[0] == 0.5);
  CHECK(std::isnan(file.dataset("/t/size").read()[1]));
  CHECK(file.dataset("/t/cells").read() == std::vector<double>{7, 8, 9, 10});
  CHECK(file.dataset("/t/cells").string_attribute("sampling") == "sum");
}

TEST_CASE("The means of an interrupted row are those of a row without interruption") {
  TableWriter whole(table(), two_walls(), 2), first(table(), two_walls(), 2), second(table(), two_walls(), 2);
  const Span a{0.1, 0.3, {1, 2, 3}}, b{0.7, 0.9, {0.1, 0.2, 0.3}};
  whole.add(a), whole.add(b);
  first.add(a);
  SavedState saved;
  saved.put_one("t", first.state());
  second.restore(saved.get_one<TableWriter<Now, Span>::State>("t"));
  second.add(b);
  CHECK(second.state().sums == whole.state().sums);
  CHECK(second.length() == whole.length());
  CHECK_THROWS_AS(second.restore({1, {1.0, 2.0}}), BadInput);
}

TEST_CASE("The tables of results.h5 have no column twice, and every column has the required properties") {
  require_sound(series_table());
  require_sound(ledger_table());
  require_sound(performance_table());
  require_sound(breakage_table());
  require_sound(fragments_table());
  require_sound(product_table());
  require_sound(holdup_table());
  require_sound(liner_cells_table());
  require_sound(liner_triangles_table());
  require_sound(liner_shape_table());
}

}  // namespace gyro
