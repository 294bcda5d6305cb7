// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Thin owner types over the serial HDF5 C API. Every failure throws gyro::OutputError with the
/// path and the reason; every handle closes itself.
namespace gyro::hdf5 {

/// An HDF5 identifier that is released when its owner goes.
class Handle {
 public:
  explicit Handle(std::int64_t id = -1) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle();
  std::int64_t get() const { return id_; }
  /// Releases it now. @returns false when the library reports a failure
  bool close();

 private:
  std::int64_t id_;
};

/// How numbers lie in the file. In memory rows are doubles, which hold all of these exactly
/// (int64 up to 2^53).
enum class Number { float32, float64, uint8, int32, uint32, int64 };

/// The same type in memory.
template <class T>
constexpr Number number_of() {
  static_assert(std::is_arithmetic_v<T>);
  if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 4 ? Number::float32 : Number::float64;
  if constexpr (sizeof(T) == 1) return Number::uint8;
  if constexpr (sizeof(T) == 8) return Number::int64;
  return std::is_signed_v<T> ? Number::int32 : Number::uint32;
}

/// A table of numbers, rows x columns; one column makes it one-dimensional.
class Dataset {
 public:
  Dataset(Handle handle, std::string where);
  std::int64_t rows() const;
  std::int64_t columns() const;
  /// Adds rows at the end. @param values row after row; a whole number of rows
  void append(std::span<const double> values) { append(values.data(), values.size(), Number::float64); }
  /// The same for numbers of any type. @param count of numbers
  void append(const void* values, std::size_t count, Number in_memory);
  /// Drops the rows from `rows` on.
  void truncate(std::int64_t rows);
  /// Hands everything appended to the operating system.
  void flush();
  /// How the numbers lie in the file.
  Number number() const;
  /// All rows, row after row, as doubles or as other numbers.
  template <class T = double>
  std::vector<T> read() const {
    std::vector<T> values(static_cast<std::size_t>(rows() * columns()));
    read(values.data(), values.size(), number_of<T>());
    return values;
  }
  /// Some rows, row after row.
  std::vector<double> read_rows(std::int64_t first, std::int64_t count) const;
  void set_attribute(std::string_view name, std::string_view value);
  std::string string_attribute(std::string_view name) const;

 private:
  void read(void* values, std::size_t count, Number in_memory) const;

  Handle handle_;
  std::string where_;  ///< file and name, for messages
};

/// Form of an extendible dataset.
struct Layout {
  Number number = Number::float64;
  std::int64_t columns = 1;
  std::int64_t chunk_rows = 1024;
  int deflate = 0;  ///< 0: none. Only for data appended in whole chunks: a compressed chunk that is
                    ///< rewritten moves, which bloats the file and breaks it if the writer is killed
};

/// One HDF5 file. Names are paths inside it ("/series/time"); missing groups are made on the way.
class File {
 public:
  /// Makes a new file, or empties the one there, in the newest format of the library.
  static File create(const std::filesystem::path& path);
  /// Opens for reading, also a file that is being written or whose writer was killed.
  static File open(const std::filesystem::path& path);
  /// Opens for reading a file that nobody writes: what is damaged is refused at once, where open() would try again
  /// and again, in case a writer had just not finished.
  static File open_closed(const std::filesystem::path& path);
  /// Opens a closed file, or one whose writer was killed, to change it.
  /// @param name  for messages, of a copy that is going to take the place of another file; empty: the path
  static File modify(const std::filesystem::path& path, const std::filesystem::path& name = {});

  void create_group(std::string_view name);
  Dataset create_dataset(std::string_view name, const Layout& layout);
  /// A dataset that will not grow, written at once.
  void write_numbers(std::string_view name, std::span<const double> values, Number number = Number::float64);
  void write_strings(std::string_view name, std::span<const std::string> values);

  bool contains(std::string_view name) const;
  bool is_group(std::string_view name) const;
  std::vector<std::string> children(std::string_view group) const;  ///< names in alphabetical order
  Dataset dataset(std::string_view name) const;
  std::vector<std::string> read_strings(std::string_view name) const;

  /// Attributes of a group or dataset; one that is there is replaced.
  void set_attribute(std::string_view object, std::string_view name, std::string_view value);
  void set_attribute(std::string_view object, std::string_view name, double value);
  void set_attribute(std::string_view object, std::string_view name, std::uint64_t value);
  std::string string_attribute(std::string_view object, std::string_view name) const;
  double number_attribute(std::string_view object, std::string_view name) const;
  std::uint64_t integer_attribute(std::string_view object, std::string_view name) const;

  /// From here on only rows are added (single writer, multiple readers): the file can be read at
  /// any moment and stays readable if this process is killed.
  void start_appending();
  void flush();
  /// Closes the file and reports what could not be written. Datasets must be gone by then.
  void close();

 private:
  File(Handle handle, std::string path) : handle_(std::move(handle)), path_(std::move(path)) {}
  Handle object(std::string_view name) const;
  Handle attribute(std::string_view object, std::string_view name) const;
  void write_attribute(std::string_view object, std::string_view name, std::int64_t type, const void* value);
  std::string where(std::string_view name) const;

  Handle handle_;
  std::string path_;
};

}  // namespace gyro::hdf5
