// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/cache.hpp"

#include "core/base/errors.hpp"
#include "core/geometry/stl_file.hpp"
#include "core/rocks/recipe.hpp"

#include <unistd.h>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

namespace gyro {
namespace {

constexpr std::string_view mark = "gyrosim rock library\n";
constexpr std::uint32_t format_version = 2;

class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    operator()(std::uint64_t{values.size()});
    for (const T& value : values) operator()(value);
  }
  void operator()(const std::string& text) {
    operator()(std::uint64_t{text.size()});
    bytes_ += text;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

struct Damaged {};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, next(sizeof value).data(), sizeof value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    const std::uint64_t count = counted();
    values.clear();
    for (std::uint64_t k = 0; k < count; ++k) operator()(values.emplace_back());
  }
  void operator()(std::string& text) { text = next(counted()); }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::uint64_t counted() {
    std::uint64_t count;
    operator()(count);
    if (count > bytes_.size()) throw Damaged{};  // nothing takes less than a byte
    return count;
  }
  std::string_view next(std::uint64_t size) {
    if (size > bytes_.size()) throw Damaged{};
    const std::string_view part = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return part;
  }
  std::string_view bytes_;
};

/// Every field of a rock, in the order of the file.
template <class Archive, class Rock>
void visit_fields(Archive& archive, Rock& rock) {
  archive(rock.name), archive(rock.diameter), archive(rock.solid_volume), archive(rock.sieve_size);
  archive(rock.centres), archive(rock.radii), archive(rock.particle_density);
  archive(rock.bonds), archive(rock.colour_begin), archive(rock.bounding_radius);
  archive(rock.packing_fraction), archive(rock.coordination);
  archive(rock.mass_error), archive(rock.inertia_error), archive(rock.centre_error), archive(rock.critical_step);
  archive(rock.hull_vertices), archive(rock.hull_faces);
}

std::filesystem::path cache_path(const std::string& folder, const std::string& recipe) {
  return std::filesystem::path(folder) / ("rocks-" + fnv1a_128(recipe) + ".bin");
}

}  // namespace

std::string pack_library(const RockLibrary& library, const std::string& recipe) {
  Writer writer;
  writer(recipe);
  writer(library.notes);
  writer(std::uint64_t{library.rocks.size()});
  for (const RockTemplate& rock : library.rocks) visit_fields(writer, rock);
  const std::string body = writer.take();
  Writer head;
  head(format_version);
  return std::string(mark) + head.take() + fnv1a_128(body) + body;
}

std::optional<RockLibrary> unpack_library(std::string_view bytes, const std::string& recipe) {
  constexpr std::size_t hash_size = 32;
  if (!bytes.starts_with(mark) || bytes.size() < mark.size() + sizeof format_version + hash_size) return {};
  bytes.remove_prefix(mark.size());
  try {
    Reader head(bytes.substr(0, sizeof format_version));
    std::uint32_t version;
    head(version);
    bytes.remove_prefix(sizeof version);
    const std::string_view hash = bytes.substr(0, hash_size), body = bytes.substr(hash_size);
    if (version != format_version || fnv1a_128(body) != hash) return {};

    Reader reader(body);
    std::string written_for;
    std::uint64_t count;
    RockLibrary library;
    reader(written_for);
    if (written_for != recipe) return {};
    reader(library.notes);
    reader(count);
    for (std::uint64_t k = 0; k < count; ++k) visit_fields(reader, library.rocks.emplace_back());
    if (!reader.at_end()) return {};
    library.from_cache = true;
    return library;
  } catch (const Damaged&) {
    return {};
  }
}

std::optional<RockLibrary> read_cached(const std::string& folder, const std::string& recipe) {
  try {
    return unpack_library(read_bytes(cache_path(folder, recipe).string()), recipe);
  } catch (const BadInput&) {  // not there
    return {};
  }
}

void write_cached(const std::string& folder, const std::string& recipe, const RockLibrary& library) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path path = cache_path(folder, recipe);
  std::filesystem::path half = path;
  half += ".";
  half += std::to_string(getpid());
  const std::string bytes = pack_library(library, recipe);
  std::ofstream file(half, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) std::filesystem::rename(half, path, error);
  if (!file || error) std::filesystem::remove(half, error);
}

}  // namespace gyro
