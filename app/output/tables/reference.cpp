// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/reference.hpp"

#include "app/output/tables/tables.hpp"
#include "io/run/case_record.hpp"
#include "io/run/snapshots.hpp"
#include "io/run/summary.hpp"

#include <nlohmann/json.hpp>

#include <cctype>

namespace gyro {
namespace {

using Json = nlohmann::ordered_json;

std::string width_text(Shape shape, const char* array) {
  return shape == Shape::number ? "1" : shape == Shape::array ? array : "3";
}

template <class Now, class Window>
OutputGroup group_of(const Table<Now, Window>& table) {
  OutputGroup group{std::string(table.group), std::string(table.rows), {}};
  for (const Column<Now, Window>& c : table.columns) {
    const Presence& when = c.presence.holds == always.holds ? table.presence : c.presence;
    group.entries.push_back({std::string(c.name), std::string(c.units), width_text(c.value.shape(), c.array),
                             to_string(c.sampling()), when.text, std::string(c.description)});
  }
  return group;
}

/// Adds the attributes of a group of curves.
OutputGroup with_attributes(OutputGroup group) {
  for (const CurveAttribute& a : curve_attributes())
    group.entries.push_back({a.name, a.units, "1", "attribute", with_resolution.text, a.description});
  return group;
}

/// Adds the datasets of a group that are written once.
template <class Now>
OutputGroup with_fixed(OutputGroup group, const Table<Now>& fixed) {
  for (OutputEntry& e : group_of(fixed).entries) group.entries.push_back(std::move(e));
  return group;
}

OutputGroup case_group() {
  OutputGroup group{"/case", "attributes of the group, written at the start", {}};
  for (const RecordAttribute& a : record_attributes())
    group.entries.push_back({a.name, a.name == "seed" ? "1" : "-", "1", "", "always", a.description});
  return group;
}

OutputGroup snapshot_group(const std::string& kind, const std::string& content, const char* when) {
  OutputGroup group{"snapshots/" + kind + "_NNNNNN.vtp", content, {}};
  for (const SnapshotField& f : snapshot_fields())
    if (f.kind == kind)
      group.entries.push_back(
          {f.name, f.units, std::to_string(f.width), to_string(Sampling::instant), when, f.description});
  return group;
}

OutputGroup fields_group() {
  OutputGroup group{"fields.h5",
                    "the same frames with output.formats: [hdf5], in groups of VTKHDF 2.0: /VTKHDF (particles), "
                    "/fragments, /bonds, /liners "
                    "(walls that change) and /liners_fixed; rows that belong to no frame fill up chunks",
                    {}};
  const auto add = [&](const char* name, const char* units, const char* width, const char* description) {
    group.entries.push_back({name, units, width, to_string(Sampling::instant), "in each group", description});
  };
  add("Steps/Values", "s", "1", "time of frame k; the attribute NSteps of Steps is the number of frames");
  add("NumberOfPoints", "1", "1", "points of frame k");
  add("Steps/PointOffsets", "1", "1", "the first of them in Points");
  add("Points", "m", "3", "positions");
  add("PointData/NAME", "-", "1 or 3", "field of the points, as in the files above");
  add("Steps/PointDataOffsets/NAME", "1", "1", "first row of frame k in PointData/NAME");
  add("CellData/NAME", "-", "1 or 3", "field of the bonds or triangles, as in the files above");
  add("Steps/CellDataOffsets/NAME", "1", "1", "first row of frame k in CellData/NAME");
  add("Steps/PartOffsets", "1", "1", "k: a frame has one part");
  add("Steps/NumberOfParts", "1", "1", "1");
  add("Lines/NumberOfCells", "1", "1", "cells of frame k; likewise, here and below, for Vertices, Polygons and Strips");
  add("Lines/NumberOfConnectivityIds", "1", "1", "points of all cells of frame k");
  add("Lines/Offsets", "1", "1",
      "places in Connectivity where a cell begins, and the last one's end, counted from the frame's first");
  add("Steps/CellOffsets", "1", "4",
      "for Vertices, Lines, Polygons and Strips: first row of frame k in Offsets, less k");
  add("Lines/Connectivity", "1", "1", "points of the cells of all frames, one cell after the other");
  add("Steps/ConnectivityIdOffsets", "1", "4",
      "first row of frame k in Connectivity, for Vertices, Lines, Polygons and Strips");
  return group;
}

OutputGroup summary_group() {
  OutputGroup group{"summary.json", "figures of the run, written at its end; null where they do not apply", {}};
  for (const SummaryMember& m : summary_members())
    group.entries.push_back({m.name, m.units, "1", "", m.when, m.description});
  return group;
}

/// How many numbers a row has: "1", "3", "1 per sieve".
std::string numbers_text(const OutputEntry& e) {
  return std::isdigit(static_cast<unsigned char>(e.width[0])) != 0 ? e.width : "1 per " + e.width;
}

/// "W, mean; with a gyrating wall"
std::string properties_of(const OutputEntry& e) {
  std::string text = e.units == "1" ? "pure number" : e.units == "-" ? "text or list" : e.units;
  if (e.width != "1") text += ", " + numbers_text(e);
  if (!e.sampling.empty()) text += ", " + e.sampling;
  return text + "; " + e.when;
}

/// With a capital letter and a full stop.
std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

/// Text of a cell of the page, where < would begin a tag.
std::string cell(std::string text) {
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<')) text.replace(at, 1, "&lt;");
  return text;
}

constexpr const char* head =
    R"(Every dataset of results.h5 has attributes `units`, `sampling` and `description`. A row belongs to its `time`, the end of
the interval that it stands for; `sampling` says how:

* `instant`: the value at `time`. Speeds, angles, masses, counts, sums since the start, and what never changes.
* `mean`: the mean over the interval. Powers, torques, forces and rates.
* `sum`: the sum over the interval.
* `attribute`: no dataset, but a number that is an attribute of the group.

Units are SI. The unit of a pure number is 1; text, lists and yes/no values have the unit -. In summary.json, the name of a figure
ends in its unit if that is not SI (`_tph`: t/h, `_kwh_per_t`: kWh/t). `_seconds` marks times, simulated or of the clock; `_fraction` and
`_share` mark pure numbers; `_error` behind the name of a figure marks its standard error, in the same unit. What a case does not have is left out. `<wall>` stands for the name of a
wall, `<id>` for the id of a particle.
)";

}  // namespace

std::vector<OutputGroup> output_reference() {
  return {group_of(series_table()),
          group_of(ledger_table()),
          group_of(performance_table()),
          group_of(breakage_table()),
          group_of(fragments_table()),
          with_attributes(with_fixed(group_of(product_table()), product_sieves())),
          with_attributes(with_fixed(group_of(holdup_table()), holdup_sieves())),
          with_fixed(group_of(liner_cells_table()), liner_shape_table()),
          group_of(liner_triangles_table()),
          case_group(),
          summary_group(),
          snapshot_group("particles", "points, in single precision; open particles.pvd", "with output.snapshots"),
          snapshot_group("bonds", "lines, in single precision; open bonds.pvd", "with output.snapshots and bonds"),
          snapshot_group("fragments",
                         "points at the centres of mass, in single precision; open fragments.pvd. Fragments that have "
                         "left the chamber are not among them",
                         "with output.snapshots and bonds"),
          snapshot_group("walls", "triangles, in single precision; open walls.pvd", "with output.snapshots"),
          fields_group()};
}

std::string outputs_text() {
  std::string text = head;
  for (const OutputGroup& group : output_reference()) {
    text += "\n" + group.name + ": " + group.content + "\n";
    for (const OutputEntry& e : group.entries)
      text += group.name + "/" + e.name + "\n    " + properties_of(e) + "\n    " + e.description + "\n";
  }
  return text;
}

std::string outputs_page() {
  std::string text =
      "# Outputs of a run\n\nWritten by `gyrosim describe outputs --markdown` from the tables that write the "
      "files; a test compares them.\n\n";
  text += head;
  for (const OutputGroup& group : output_reference()) {
    text += "\n## `" + group.name + "`\n\n" + sentence(group.content) + "\n\n";
    text += "| name | units | numbers | sampling | present | what it is |\n|---|---|---|---|---|---|\n";
    for (const OutputEntry& e : group.entries)
      text += "| `" + e.name + "` | " + e.units + " | " + numbers_text(e) + " | " + e.sampling + " | " + e.when +
              " | " + cell(e.description) + " |\n";
  }
  return text;
}

std::string outputs_json() {
  Json outputs = Json::array();
  for (const OutputGroup& group : output_reference())
    for (const OutputEntry& e : group.entries)
      outputs.push_back({{"group", group.name},
                         {"name", e.name},
                         {"units", e.units},
                         {"width", e.width},
                         {"sampling", e.sampling},
                         {"when", e.when},
                         {"description", e.description},
                         {"rows", group.content}});
  return Json{{"outputs", outputs}}.dump(2) + "\n";
}

}  // namespace gyro
