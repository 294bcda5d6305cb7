// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Thin owner types for the serial HDF5 C API. Every failure throws gyro::OutputError with the path and the reason.
/// Every handle is closed by its owner. Threads may use different files at the same time: they take turns in the
/// library, which need not be built for threads.
namespace gyro::hdf5 {

/// An HDF5 identifier that is released with this object.
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
  /// Releases the identifier now. @returns false if the library reports a failure
  bool close();

 private:
  std::int64_t id_;
};

/// Type of the numbers in a file. Rows in memory are doubles, which hold all of these exactly (int64 up to 2^53).
enum class Number { float32, float64, uint8, int32, uint32, int64 };

/// The type of numbers in memory.
template <class T>
constexpr Number number_of() {
  static_assert(std::is_arithmetic_v<T> &&
                (sizeof(T) == 4 || sizeof(T) == 1 || (sizeof(T) == 8 && std::is_signed_v<T>)));
  if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 4 ? Number::float32 : Number::float64;
  if constexpr (sizeof(T) == 1) return Number::uint8;
  if constexpr (sizeof(T) == 8) return Number::int64;
  return std::is_signed_v<T> ? Number::int32 : Number::uint32;
}

std::size_t size_of(Number number);  ///< [bytes]

/// A table of numbers, rows x columns. A table with one column is one-dimensional.
class Dataset {
 public:
  Dataset(Handle handle, std::string where);
  std::int64_t rows() const;
  std::int64_t columns() const;
  std::int64_t chunk_rows() const;
  /// Adds rows at the end. @param values  row after row; a whole number of rows
  void append(std::span<const double> values) { append(values.data(), values.size(), Number::float64); }
  /// The same for numbers of any type. @param count  of numbers
  void append(const void* values, std::size_t count, Number in_memory);
  /// Overwrites one row, or adds it behind the last one. @param values  of all columns
  void write_row(std::int64_t row, std::span<const double> values);
  /// Removes all rows after the first `rows`.
  void truncate(std::int64_t rows) { resize(rows); }
  /// Removes rows at the end, or adds rows of zeros there.
  void resize(std::int64_t rows);
  /// Passes everything that was appended to the operating system.
  void flush();
  /// Type of the numbers in the file.
  Number number() const;
  /// All numbers, row after row, converted to T.
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

/// Shape and storage of an extendible dataset.
struct Layout {
  Number number = Number::float64;
  std::int64_t columns = 1;
  std::int64_t chunk_rows = 1024;
  int deflate = 0;  ///< level of compression, 0: none. Only for data that are appended in whole chunks: a compressed
                    ///< chunk that is rewritten moves, which bloats the file and breaks it if the writer is killed
};

/// An HDF5 file. Names are paths inside it ("/series/time"); missing groups of a path are created.
class File {
 public:
  /// Creates a file in the newest format of the library; an existing file is emptied.
  static File create(const std::filesystem::path& path);
  /// Opens a file for reading. It may be a file that is being written, or one whose writer was killed.
  static File open(const std::filesystem::path& path);
  /// Opens for reading a file that nobody is writing. A damaged file is refused at once, while open() would read it
  /// again several times in case a writer had not finished.
  static File open_closed(const std::filesystem::path& path);
  /// Opens a file for changes, whoever is reading it. It may be a closed file, or one whose writer was killed.
  /// @param name  path for messages, if `path` is a copy that will replace the file of this name; empty: `path`
  static File modify(const std::filesystem::path& path, const std::filesystem::path& name = {});
  /// Opens a closed file to add rows (start_appending() is implied), whoever is reading it. The library's locks are not
  /// used: with them, a reader that keeps the file open would keep the writer out. There must be no other writer.
  static File append_to(const std::filesystem::path& path);
  /// Opens a closed file to change numbers in place, whoever is reading it, as append_to() does.
  static File change(const std::filesystem::path& path);

  void create_group(std::string_view name);
  Dataset create_dataset(std::string_view name, const Layout& layout);
  /// Writes a dataset that will not grow.
  void write_numbers(std::string_view name, std::span<const double> values, Number number = Number::float64);
  void write_strings(std::string_view name, std::span<const std::string> values);

  bool contains(std::string_view name) const;
  bool is_group(std::string_view name) const;
  std::vector<std::string> children(std::string_view group) const;  ///< names in alphabetical order
  Dataset dataset(std::string_view name) const;
  std::vector<std::string> read_strings(std::string_view name) const;

  /// Sets an attribute of a group or dataset; an existing one is replaced.
  void set_attribute(std::string_view object, std::string_view name, std::string_view value);
  void set_attribute(std::string_view object, std::string_view name, double value);
  void set_attribute(std::string_view object, std::string_view name, std::uint64_t value);
  /// The same for a row of numbers.
  void set_attribute(std::string_view object, std::string_view name, std::span<const std::int64_t> values);
  /// The same for a text in the form that VTK asks for: ASCII, of fixed length.
  void set_fixed_text(std::string_view object, std::string_view name, std::string_view text);
  void set_integer(std::string_view object, std::string_view name, std::int64_t value);
  /// Overwrites an attribute that is one integer, where it lies in the file.
  void overwrite_integer(std::string_view object, std::string_view name, std::int64_t value);
  std::string string_attribute(std::string_view object, std::string_view name) const;
  double number_attribute(std::string_view object, std::string_view name) const;
  std::uint64_t integer_attribute(std::string_view object, std::string_view name) const;

  /// Makes a name for a group or dataset of another file. @param file  relative to this file's folder
  void link_to_file(std::string_view name, const std::string& file, const std::string& object);

  /// Starts the mode in which only rows are added (single writer, multiple readers). In this mode the file can be read
  /// at any time, and it remains readable if this process is killed.
  void start_appending();
  void flush();
  /// Closes the file. All datasets must have been released before. @throws OutputError if not everything was written
  void close();

 private:
  File(Handle handle, std::string path) : handle_(std::move(handle)), path_(std::move(path)) {}
  Handle object(std::string_view name) const;
  Handle attribute(std::string_view object, std::string_view name) const;
  void write_attribute(std::string_view object, std::string_view name, std::int64_t type, const void* value);
  void write_attribute(std::string_view object, std::string_view name, std::int64_t type, const Handle& space,
                       const void* value);
  static File open_without_locks(const std::filesystem::path& path, unsigned flags);
  std::string where(std::string_view name) const;

  Handle handle_;
  std::string path_;
};

}  // namespace gyro::hdf5
