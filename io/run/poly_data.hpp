// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// A field of points or cells.
struct PolyArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<float>, std::vector<std::int32_t>, std::vector<std::uint32_t>> values;  ///< row after row
};

/// Cells of one kind: the points of all of them, one behind the other, and where each ends.
struct PolyCells {
  std::vector<std::int32_t> points, ends;
};

/// Points, lines and triangles with fields: VTK's PolyData.
struct PolyData {
  std::vector<float> positions;  ///< x, y, z of point after point [m]
  PolyCells vertices, lines, triangles;
  std::vector<PolyArray> point_fields, cell_fields;  ///< cells in the order vertices, lines, triangles
  std::optional<double> time;                        ///< [s]; none for what is the same at all times
};

/// Writes a VTK XML file (.vtp): binary data appended, compressed by zlib. With VTK's library where the program was
/// built with it, else with write_vtp_plain(). @throws OutputError
void write_vtp(const std::filesystem::path& path, const PolyData& data);

/// The same file, made without VTK's library. Format: VTK File Formats (docs.vtk.org), XML, "raw" appended data, header
/// UInt64, blocks compressed by zlib.
void write_vtp_plain(const std::filesystem::path& path, const PolyData& data);

}  // namespace gyro
