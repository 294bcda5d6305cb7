// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/base64.hpp"
#include "io/run/poly_data.hpp"
#include "io/run/replace_file.hpp"

#include <zlib.h>

#include <bit>
#include <new>
#include <string_view>

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

std::string_view bytes_of(const void* data, std::size_t size) {
  return {static_cast<const char*>(data), size};
}

/// Data in the form of VTK: number of blocks, size of a block, size of the last block if it is smaller (else 0),
/// compressed size of each block; then the blocks. Each of the two parts is base64 of its own.
std::string encoded(std::string_view data) {
  const std::size_t blocks = (data.size() + block_bytes - 1) / block_bytes;
  std::vector<std::uint64_t> header{blocks, block_bytes, data.size() % block_bytes};
  std::string compressed;
  std::vector<unsigned char> room(::compressBound(block_bytes));
  for (std::size_t begin = 0; begin < data.size(); begin += block_bytes) {
    const std::string_view block = data.substr(begin, block_bytes);
    uLongf length = room.size();
    if (::compress2(room.data(), &length, reinterpret_cast<const unsigned char*>(block.data()), block.size(),
                    Z_DEFAULT_COMPRESSION) != Z_OK)
      throw std::bad_alloc();
    header.push_back(length);
    compressed += bytes_of(room.data(), length);
  }
  return base64(bytes_of(header.data(), header.size() * sizeof(std::uint64_t))) + base64(compressed);
}

/// The XML elements of the file.
class Vtp {
 public:
  std::string xml;

  template <class T>
  void add(const std::string& name, int components, const std::vector<T>& values, const std::string& more = "") {
    xml += "<DataArray type=\"" + std::string(type_name<T>()) + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\"" + more + " format=\"binary\">\n";
    xml += encoded(bytes_of(values.data(), values.size() * sizeof(T))) + "\n</DataArray>\n";
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
  file.xml += "</Piece>\n</PolyData>\n</VTKFile>\n";
  replace_file(path, file.xml);
}

}  // namespace gyro
