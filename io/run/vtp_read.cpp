// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the files that write_vtp() and write_vtp_plain() write: no other form of VTK's XML.
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/run/poly_data.hpp"

#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

namespace gyro {
namespace {

/// The text of an attribute of an element; empty if it has none.
std::string_view attribute(std::string_view element, std::string_view name) {
  std::string start(1, ' ');
  start.append(name).append("=\"");
  const std::size_t begin = element.find(start);
  if (begin == std::string_view::npos) return {};
  const std::size_t first = begin + start.size(), end = element.find('"', first);
  return end == std::string_view::npos ? std::string_view() : element.substr(first, end - first);
}

std::uint64_t number(std::string_view text) {
  return std::strtoull(std::string(text).c_str(), nullptr, 10);
}

/// The bytes behind the "_" of the appended data.
class Appended {
 public:
  explicit Appended(std::string_view bytes) : bytes_(bytes) {}

  /// The values of an array, in blocks compressed by zlib (vtp_plain.cpp has the form).
  template <class T>
  std::vector<T> array(std::uint64_t offset) const {
    const std::string raw = unpacked(offset);
    std::vector<T> values(raw.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), raw.data(), values.size() * sizeof(T));
    return values;
  }

 private:
  std::uint64_t word(std::uint64_t at) const {
    if (at > bytes_.size() || bytes_.size() - at < sizeof(std::uint64_t)) throw BadInput("an array is cut off");
    std::uint64_t value = 0;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return value;
  }

  std::string unpacked(std::uint64_t offset) const {
    constexpr std::uint64_t largest_block = 1 << 28, word_size = sizeof(std::uint64_t);
    const std::uint64_t blocks = word(offset);
    if (blocks == 0) return {};
    const std::uint64_t size = word(offset + word_size), last = word(offset + 2 * word_size);
    if (blocks > bytes_.size() / word_size || size == 0 || size > largest_block || last > size)
      throw BadInput("an array has a wrong head");
    std::string all;
    std::uint64_t at = offset + (3 + blocks) * word_size;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t packed = word(offset + (3 + b) * word_size);
      append_block(at, packed, b + 1 == blocks && last > 0 ? last : size, all);
      at += packed;
    }
    return all;
  }

  void append_block(std::uint64_t at, std::uint64_t packed, std::uint64_t size, std::string& to) const {
    if (at > bytes_.size() || packed > bytes_.size() - at) throw BadInput("an array is cut off");
    const std::size_t before = to.size();
    to.resize(before + size);
    uLongf length = size;
    const auto* source = reinterpret_cast<const Bytef*>(bytes_.data() + at);
    if (::uncompress(reinterpret_cast<Bytef*>(to.data() + before), &length, source, packed) != Z_OK || length != size)
      throw BadInput("a block cannot be decompressed");
  }

  std::string_view bytes_;
};

/// Adds an array to the part of the data in whose element it stands.
void add_array(std::string_view element, std::string_view part, const Appended& bytes, PolyData& data) {
  const std::string name(attribute(element, "Name"));
  const std::string_view type = attribute(element, "type"), components = attribute(element, "NumberOfComponents");
  const std::uint64_t offset = number(attribute(element, "offset"));
  if (part == "FieldData") {
    const auto values = name == "TimeValue" && type == "Float64" ? bytes.array<double>(offset) : std::vector<double>();
    if (!values.empty()) data.time = values.front();
  } else if (part == "Points" && type == "Float32") {
    data.positions = bytes.array<float>(offset);
  } else if (part == "PointData" || part == "CellData") {
    PolyArray array{name, components.empty() ? 1 : static_cast<int>(number(components)), {}};
    if (type == "Float32")
      array.values = bytes.array<float>(offset);
    else if (type == "Int32")
      array.values = bytes.array<std::int32_t>(offset);
    else if (type == "UInt32")
      array.values = bytes.array<std::uint32_t>(offset);
    else
      return;
    (part == "PointData" ? data.point_fields : data.cell_fields).push_back(std::move(array));
  } else if (type == "Int32") {
    PolyCells* cells = part == "Verts"   ? &data.vertices
                       : part == "Lines" ? &data.lines
                       : part == "Polys" ? &data.triangles
                                         : nullptr;
    if (cells) (name == "connectivity" ? cells->points : cells->ends) = bytes.array<std::int32_t>(offset);
  }
}

PolyData parse(std::string_view text) {
  const std::size_t appended = text.find("<AppendedData encoding=\"raw\">");
  const std::size_t mark = appended == std::string_view::npos ? appended : text.find('_', appended);
  if (mark == std::string_view::npos || text.find("type=\"PolyData\"") > appended)
    throw BadInput("it is no VTK PolyData with appended raw data");
  if (text.find("header_type=\"UInt64\"") > appended || text.find("vtkZLibDataCompressor") > appended)
    throw BadInput("its arrays are not compressed by zlib with heads of UInt64");
  const Appended bytes(text.substr(mark + 1));
  PolyData data;
  std::string_view part, xml = text.substr(0, appended);
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', at + 1)) {
    const std::string_view element = xml.substr(at + 1, xml.find('>', at) - at - 1);
    const std::string_view name = element.substr(0, element.find_first_of(" \n\r\t/"));
    if (name == "DataArray")
      add_array(element, part, bytes, data);
    else if (!name.empty())
      part = name;
  }
  return data;
}

}  // namespace

PolyData read_vtp(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  try {
    return parse(text);
  } catch (const BadInput& problem) {
    throw BadInput(path.string() + ": is damaged (" + problem.what() + "); restore the file, or run the case again");
  }
}

}  // namespace gyro
