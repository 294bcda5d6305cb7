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

/// Cells of one kind: the points of all cells in sequence, and for each cell the index after its last point.
struct PolyCells {
  std::vector<std::int32_t> points, ends;
};

/// Points, lines and triangles with fields: VTK's PolyData.
struct PolyData {
  std::vector<float> positions;  ///< x, y, z of each point in sequence [m]
  PolyCells vertices, lines, triangles;
  std::vector<PolyArray> point_fields, cell_fields;  ///< cells in the order vertices, lines, triangles
  std::optional<double> time;                        ///< [s]; empty for data that do not depend on time
};

/// Writes a VTK XML file (.vtp) with binary data in its elements, compressed by zlib. Data are not appended after the
/// elements, which takes a quarter less space: VTK 9.1 and ParaView 5.11 cannot read such files with the expat library
/// of Debian 12 since its security update of 2025 (2.5.0-1+deb12u2). Uses VTK's library if the program was built with
/// it, and write_vtp_plain() otherwise. @throws OutputError
void write_vtp(const std::filesystem::path& path, const PolyData& data);

/// Writes the same file without VTK's library. Format: VTK File Formats (docs.vtk.org), XML, inline "binary" data,
/// header UInt64, blocks compressed by zlib. @throws OutputError
void write_vtp_plain(const std::filesystem::path& path, const PolyData& data);

/// Reads a file that one of the two has written. @throws BadInput with the path for a missing or damaged file
PolyData read_vtp(const std::filesystem::path& path);

}  // namespace gyro
