// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"
#include "io/run/replace_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace gyro {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

constexpr std::size_t block_bytes = 1 << 20;  ///< size of a block; blocks are compressed separately

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "UInt32";
}

/// The two parts of the file: the XML elements, and the bytes to which they refer.
class Vtp {
 public:
  std::string xml, bytes;

  template <class T>
  void add(const std::string& name, int components, const std::vector<T>& values, const std::string& more = "") {
    xml += "<DataArray type=\"" + std::string(type_name<T>()) + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\"" + more + " format=\"appended\" offset=\"" + std::to_string(bytes.size()) +
           "\"/>\n";
    append(reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(T));
  }

  void add(const std::vector<PolyArray>& fields) {
    for (const PolyArray& field : fields)
      std::visit([&](const auto& values) { add(field.name, field.components, values); }, field.values);
  }

  void add(const char* kind, const PolyCells& cells) {
    xml += std::string("<") + kind + ">\n";
    add("connectivity", 1, cells.points);
    add("offsets", 1, cells.ends);
    xml += std::string("</") + kind + ">\n";
  }

 private:
  /// Appends data in the form of VTK: number of blocks, size of a block, size of the last block if it is smaller (else
  /// 0), compressed size of each block, and the blocks.
  void append(const unsigned char* data, std::size_t size) {
    const std::size_t blocks = (size + block_bytes - 1) / block_bytes;
    std::vector<std::uint64_t> header{blocks, block_bytes, size % block_bytes};
    std::string compressed;
    std::vector<unsigned char> room(::compressBound(block_bytes));
    for (std::size_t begin = 0; begin < size; begin += block_bytes) {
      uLongf length = room.size();
      if (::compress2(room.data(), &length, data + begin, std::min(block_bytes, size - begin), Z_DEFAULT_COMPRESSION) !=
          Z_OK)
        throw std::bad_alloc();
      header.push_back(length);
      compressed.append(reinterpret_cast<const char*>(room.data()), length);
    }
    bytes.append(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(std::uint64_t));
    bytes += compressed;
  }
};

std::string count(const char* name, std::size_t number) {
  return std::string(" ") + name + "=\"" + std::to_string(number) + "\"";
}

}  // namespace

void write_vtp_plain(const std::filesystem::path& path, const PolyData& data) {
  Vtp file;
  file.xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n";
  if (data.time) {
    file.xml += "<FieldData>\n";
    file.add("TimeValue", 1, std::vector{*data.time}, " NumberOfTuples=\"1\"");
    file.xml += "</FieldData>\n";
  }
  file.xml += "<Piece" + count("NumberOfPoints", data.positions.size() / 3) +
              count("NumberOfVerts", data.vertices.ends.size()) + count("NumberOfLines", data.lines.ends.size()) +
              count("NumberOfStrips", 0) + count("NumberOfPolys", data.triangles.ends.size()) + ">\n<PointData>\n";
  file.add(data.point_fields);
  file.xml += "</PointData>\n<CellData>\n";
  file.add(data.cell_fields);
  file.xml += "</CellData>\n<Points>\n";
  file.add("Points", 3, data.positions);
  file.xml += "</Points>\n";
  file.add("Verts", data.vertices);
  file.add("Lines", data.lines);
  file.add("Polys", data.triangles);
  file.xml += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  replace_file(path, file.xml + file.bytes + "\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace gyro
