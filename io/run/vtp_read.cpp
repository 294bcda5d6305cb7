// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the files that write_vtp() and write_vtp_plain() write: no other form of VTK's XML.
#include "core/base/errors.hpp"
#include "io/files/base64.hpp"
#include "io/files/read_file.hpp"
#include "io/run/poly_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace gyro {
namespace {

constexpr std::string_view white_space = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(white_space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white_space) + 1 - first);
}

/// The text of an attribute of an element; empty if it has none.
std::string_view attribute(std::string_view element, std::string_view name) {
  std::string start(1, ' ');
  start.append(name).append("=\"");
  const std::size_t begin = element.find(start);
  if (begin == std::string_view::npos) return {};
  const std::size_t first = begin + start.size(), end = element.find('"', first);
  return end == std::string_view::npos ? std::string_view() : element.substr(first, end - first);
}

constexpr std::size_t word_bytes = sizeof(std::uint64_t);

constexpr std::size_t base64_length(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

std::string bytes_of(std::string_view text) {
  std::optional<std::string> bytes = from_base64(text);
  if (!bytes) throw BadInput("the text of an array is no base64");
  return *std::move(bytes);
}

/// The first words of an array's text, which are base64 of their own.
std::vector<std::uint64_t> first_words(std::string_view text, std::size_t count) {
  const std::size_t length = base64_length(count * word_bytes);
  if (text.size() < length) throw BadInput("an array is cut off");
  const std::string bytes = bytes_of(text.substr(0, length));
  if (bytes.size() != count * word_bytes) throw BadInput("an array has a wrong header");
  std::vector<std::uint64_t> words(count);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

/// Adds the data of a block that has `size` bytes when it is decompressed.
void append_block(std::string_view block, std::uint64_t size, std::string& to) {
  constexpr std::uint64_t largest_ratio = 1032;  // of deflate (zlib Technical Details, zlib.net)
  if (size > largest_ratio * block.size()) throw BadInput("a block is too short for its data");
  const std::size_t before = to.size();
  to.resize(before + size);
  uLongf length = size;
  const auto* source = reinterpret_cast<const Bytef*>(block.data());
  auto* target = reinterpret_cast<Bytef*>(to.data() + before);
  if (::uncompress(target, &length, source, block.size()) != Z_OK || length != size)
    throw BadInput("a block cannot be decompressed");
}

/// The data of an array from its text: vtp_plain.cpp has the form. No size is believed before the text is seen to be
/// long enough for it.
std::string unpacked(std::string_view text) {
  constexpr std::size_t fixed = 3;  // words: number of blocks, size of a block, size of the last one if it is smaller
  const std::uint64_t blocks = first_words(text, fixed).front();
  if (blocks > text.size()) throw BadInput("an array is cut off");
  const std::vector<std::uint64_t> header = first_words(text, fixed + blocks);
  const std::uint64_t size = header[1], last = header[2];
  if (blocks > 0 && (size == 0 || last > size)) throw BadInput("an array has a wrong header");
  const std::string packed = bytes_of(text.substr(base64_length(header.size() * word_bytes)));
  std::string_view rest = packed;
  std::string all;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::uint64_t length = header[fixed + b];
    if (length > rest.size()) throw BadInput("an array is cut off");
    append_block(rest.substr(0, length), b + 1 == blocks && last > 0 ? last : size, all);
    rest.remove_prefix(length);
  }
  if (!rest.empty()) throw BadInput("an array has data behind its last block");
  return all;
}

/// An element with the text up to the next one.
struct Element {
  std::string_view attributes, text;
};

template <class T>
std::vector<T> values_of(const Element& element) {
  if (attribute(element.attributes, "format") != "binary") throw BadInput("an array is not in binary form");
  const std::string raw = unpacked(element.text);
  if (raw.size() % sizeof(T) != 0) throw BadInput("an array ends within a number");
  std::vector<T> values(raw.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), raw.data(), raw.size());
  return values;
}

int components_of(std::string_view attributes) {
  constexpr std::uint64_t most = 9;  // of a tensor
  const std::string_view text = attribute(attributes, "NumberOfComponents");
  const std::uint64_t components = text.empty() ? 1 : std::strtoull(std::string(text).c_str(), nullptr, 10);
  if (components == 0 || components > most) throw BadInput("an array has a wrong number of components");
  return static_cast<int>(components);
}

/// Adds a field; one of another type than ours is left out.
void add_field(const Element& element, std::vector<PolyArray>& fields) {
  PolyArray array{std::string(attribute(element.attributes, "Name")), components_of(element.attributes), {}};
  const std::string_view type = attribute(element.attributes, "type");
  if (type == "Float32")
    array.values = values_of<float>(element);
  else if (type == "Int32")
    array.values = values_of<std::int32_t>(element);
  else if (type == "UInt32")
    array.values = values_of<std::uint32_t>(element);
  else
    return;
  fields.push_back(std::move(array));
}

/// Adds an array to the part of the data in whose element it stands.
void add_array(const Element& element, std::string_view part, PolyData& data) {
  const std::string_view name = attribute(element.attributes, "Name"), type = attribute(element.attributes, "type");
  if (part == "FieldData" && name == "TimeValue" && type == "Float64") {
    if (const auto values = values_of<double>(element); !values.empty()) data.time = values.front();
  } else if (part == "Points" && type == "Float32") {
    data.positions = values_of<float>(element);
  } else if (part == "PointData") {
    add_field(element, data.point_fields);
  } else if (part == "CellData") {
    add_field(element, data.cell_fields);
  } else if (type == "Int32") {
    PolyCells* cells = part == "Verts"   ? &data.vertices
                       : part == "Lines" ? &data.lines
                       : part == "Polys" ? &data.triangles
                                         : nullptr;
    if (cells) (name == "connectivity" ? cells->points : cells->ends) = values_of<std::int32_t>(element);
  }
}

/// Checks the outermost element, and that it is closed: a file that was cut off between two arrays has lost the others.
void require_our_form(std::string_view xml) {
  const std::size_t start = std::min(xml.find("<VTKFile"), xml.size());
  const std::string_view root = xml.substr(start, xml.find('>', start) - start);
  if (attribute(root, "type") != "PolyData") throw BadInput("it is no VTK PolyData");
  if (attribute(root, "header_type") != "UInt64" || attribute(root, "compressor") != "vtkZLibDataCompressor")
    throw BadInput("its arrays are not compressed by zlib with headers of UInt64");
  if (!trimmed(xml).ends_with("</VTKFile>")) throw BadInput("it is cut off");
}

PolyData parse(std::string_view xml) {
  constexpr std::array<std::string_view, 8> parts{"FieldData", "PointData", "CellData", "Points",
                                                  "Verts",     "Lines",     "Strips",   "Polys"};
  require_our_form(xml);
  PolyData data;
  std::string_view part;
  for (std::size_t at = xml.find('<'); at != std::string_view::npos;) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) throw BadInput("an element is cut off");
    const std::string_view element = xml.substr(at + 1, end - at - 1);
    const std::string_view name = element.substr(0, element.find_first_of(" \n\r\t/"));
    at = xml.find('<', end);
    if (name == "DataArray")
      add_array({element, trimmed(xml.substr(end + 1, at - end - 1))}, part, data);
    else if (std::ranges::find(parts, name) != parts.end())
      part = name;
  }
  return data;
}

}  // namespace

PolyData read_vtp(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  if (text.find("<AppendedData") != std::string::npos)
    throw BadInput(path.string() +
                   ": has its data appended after the elements, as an earlier gyrosim wrote them; run the case again");
  try {
    return parse(text);
  } catch (const BadInput& problem) {
    throw BadInput(path.string() + ": is damaged (" + problem.what() + "); restore the file, or run the case again");
  }
}

}  // namespace gyro
