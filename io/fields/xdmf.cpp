// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/xdmf.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace gyro {

const char* const xdmf_head =
    "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
    "<Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
const char* const xdmf_tail = "</Grid>\n</Domain>\n</Xdmf>\n";

namespace {

std::string attribute(const char* name, const std::string& value) {
  std::string text(" ");
  return text.append(name).append("=\"").append(value).append("\"");
}

std::string number_type(hdf5::Number number) {
  using hdf5::Number;
  const char* type = number == Number::float32 || number == Number::float64 ? "Float"
                     : number == Number::uint32 || number == Number::uint8  ? "UInt"
                                                                            : "Int";
  return attribute("NumberType", type) + attribute("Precision", std::to_string(hdf5::size_of(number)));
}

/// Sizes of a table as XDMF writes them: "rows", or "rows columns".
std::string sizes(std::int64_t rows, std::int64_t other, const FieldRows& of) {
  std::string text = std::to_string(rows);
  if (of.columns > 1) text.append(" ").append(std::to_string(other));
  return text;
}

std::string zeros(const FieldRows& rows) {
  return "<DataItem Format=\"XML\"" + attribute("Dimensions", sizes(1, rows.columns, rows)) + number_type(rows.number) +
         ">" + (rows.columns == 3 ? "0 0 0" : "0") + "</DataItem>";
}

/// Rows of a dataset: "FILE:DATASET|start:stride:count:size of the dataset". A row of zeros stands for no rows.
std::string item(const FieldRows& rows, const std::string& file) {
  if (rows.rows == 0) return zeros(rows);
  const std::string counts = sizes(rows.rows, rows.columns, rows);
  return "<DataItem Format=\"HDF\"" + attribute("Dimensions", counts) + number_type(rows.number) + ">" + file + ":" +
         rows.dataset + "|" + sizes(rows.first, 0, rows) + ":" + sizes(1, 1, rows) + ":" + counts + ":" +
         sizes(rows.rows_of_all, rows.columns, rows) + "</DataItem>";
}

std::string topology(const FieldFrame& frame, const std::string& file) {
  constexpr std::array types{"Polyvertex", "Polyline", "Triangle"};
  const std::int64_t cells = std::max<std::int64_t>(frame.cells, 1), ids = std::max(frame.connectivity.rows, cells);
  std::string text = std::string("<Topology TopologyType=\"") + types[static_cast<std::size_t>(frame.kind)] + "\"" +
                     attribute("NumberOfElements", std::to_string(cells));
  if (frame.kind != CellKind::triangles) text += attribute("NodesPerElement", std::to_string(ids / cells));
  return text + ">" + item(frame.connectivity, file) + "</Topology>\n";
}

std::string field(const FieldRows& rows, const char* center, const std::string& file) {
  return "<Attribute" + attribute("Name", rows.name()) +
         attribute("AttributeType", rows.columns == 3 ? "Vector" : "Scalar") + attribute("Center", center) + ">" +
         item(rows, file) + "</Attribute>\n";
}

std::string time_text(double time) {
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "<Time Value=\"%.12g\"/>\n", time);
  return text.data();
}

}  // namespace

std::string xdmf_grid(const FieldFrame& frame, const std::string& name, const std::string& file) {
  std::string text = "<Grid" + attribute("Name", name) + ">\n" + topology(frame, file);
  text += "<Geometry GeometryType=\"XYZ\">" + item(frame.points, file) + "</Geometry>\n";
  for (const FieldRows& rows : frame.point_fields) text += field(rows, "Node", file);
  for (const FieldRows& rows : frame.cell_fields) text += field(rows, "Cell", file);
  return text + "</Grid>\n";
}

std::string xdmf_collection(double time, const std::string& grids) {
  return "<Grid Name=\"frame\" GridType=\"Collection\" CollectionType=\"Spatial\">\n" + time_text(time) + grids +
         "</Grid>\n";
}

std::string xdmf_timed(double time, std::string grid) {
  return grid.insert(grid.find('\n') + 1, time_text(time));
}

}  // namespace gyro
