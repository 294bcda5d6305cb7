// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/hdf5/internal.hpp"

#include <array>
#include <stdexcept>

namespace gyro::hdf5 {
namespace {

struct Extent {
  int rank;
  std::array<hsize_t, 2> size;  ///< rows and columns; a one-dimensional dataset has 1 column
};

Extent extent_of(const Handle& dataset, const std::string& where) {
  const Handle space = own(H5Dget_space(dataset.get()), where, "read the shape");
  Extent extent{H5Sget_simple_extent_ndims(space.get()), {0, 1}};
  if (extent.rank < 1 || extent.rank > 2) throw std::logic_error(where + ": not a table");
  check(H5Sget_simple_extent_dims(space.get(), extent.size.data(), nullptr), where, "read the shape");
  return extent;
}

/// Rows of a dataset, in its file and in memory.
struct Rows {
  Handle in_file, in_memory;
};

Rows select_rows(const Handle& dataset, const std::string& where, hsize_t first, hsize_t rows) {
  const Extent extent = extent_of(dataset, where);
  const std::array<hsize_t, 2> start{first, 0}, count{rows, extent.size[1]};
  Handle in_file = own(H5Dget_space(dataset.get()), where, "read the shape");
  check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), where,
        "select rows");
  return {std::move(in_file), own(H5Screate_simple(extent.rank, count.data(), nullptr), where, "select rows")};
}

}  // namespace

Dataset::Dataset(Handle handle, std::string where) : handle_(std::move(handle)), where_(std::move(where)) {}

std::int64_t Dataset::rows() const {
  const InLibrary in_library;
  return static_cast<std::int64_t>(extent_of(handle_, where_).size[0]);
}

std::int64_t Dataset::columns() const {
  const InLibrary in_library;
  return static_cast<std::int64_t>(extent_of(handle_, where_).size[1]);
}

std::int64_t Dataset::chunk_rows() const {
  const InLibrary in_library;
  const Handle creation = own(H5Dget_create_plist(handle_.get()), where_, "read the chunks");
  std::array<hsize_t, 2> chunk{};
  check(H5Pget_chunk(creation.get(), 2, chunk.data()), where_, "read the chunks");
  return static_cast<std::int64_t>(chunk[0]);
}

Number Dataset::number() const {
  const InLibrary in_library;
  const Handle type = own(H5Dget_type(handle_.get()), where_, "read the type");
  for (const Number number :
       {Number::float32, Number::float64, Number::uint8, Number::int32, Number::uint32, Number::int64})
    if (H5Tequal(type.get(), file_type(number)) > 0) return number;
  throw std::logic_error(where_ + ": not one of our numbers");
}

void Dataset::append(const void* values, std::size_t total, Number in_memory) {
  if (total == 0) return;
  const InLibrary in_library;
  Extent extent = extent_of(handle_, where_);
  if (total % extent.size[1] != 0) throw std::logic_error(where_ + ": not a whole number of rows");
  const hsize_t before = extent.size[0], added = total / extent.size[1];
  extent.size[0] += added;
  check(H5Dset_extent(handle_.get(), extent.size.data()), where_, "grow");
  const Rows rows = select_rows(handle_, where_, before, added);
  check(H5Dwrite(handle_.get(), memory_type(in_memory), rows.in_memory.get(), rows.in_file.get(), H5P_DEFAULT, values),
        where_, "write");
}

void Dataset::write_row(std::int64_t row, std::span<const double> values) {
  const InLibrary in_library;
  if (row == rows()) return append(values);
  const Rows at = select_rows(handle_, where_, static_cast<hsize_t>(row), 1);
  check(H5Dwrite(handle_.get(), H5T_NATIVE_DOUBLE, at.in_memory.get(), at.in_file.get(), H5P_DEFAULT, values.data()),
        where_, "write");
}

void Dataset::resize(std::int64_t rows) {
  const InLibrary in_library;
  Extent extent = extent_of(handle_, where_);
  extent.size[0] = static_cast<hsize_t>(rows);
  check(H5Dset_extent(handle_.get(), extent.size.data()), where_, "resize");
}

void Dataset::flush() {
  const InLibrary in_library;
  check(H5Dflush(handle_.get()), where_, "write");
}

void Dataset::read(void* values, std::size_t count, Number in_memory) const {
  const InLibrary in_library;
  if (count > 0)
    check(H5Dread(handle_.get(), memory_type(in_memory), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), where_, "read");
}

std::vector<double> Dataset::read_rows(std::int64_t first, std::int64_t count) const {
  const InLibrary in_library;
  std::vector<double> values(static_cast<std::size_t>(count * columns()));
  if (values.empty()) return values;
  const Rows rows = select_rows(handle_, where_, static_cast<hsize_t>(first), static_cast<hsize_t>(count));
  check(H5Dread(handle_.get(), memory_type(Number::float64), rows.in_memory.get(), rows.in_file.get(), H5P_DEFAULT,
                values.data()),
        where_, "read");
  return values;
}

void Dataset::set_attribute(std::string_view name, std::string_view value) {
  const InLibrary in_library;
  const Handle type = string_type();
  const Handle space = own(H5Screate(H5S_SCALAR), where_, "make an attribute");
  const Handle attribute =
      own(H5Acreate2(handle_.get(), std::string(name).c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
          where_, "make an attribute");
  const std::string text(value);
  const char* pointer = text.c_str();
  check(H5Awrite(attribute.get(), type.get(), &pointer), where_, "write an attribute");
}

std::string Dataset::string_attribute(std::string_view name) const {
  const InLibrary in_library;
  const Handle attribute =
      own(H5Aopen(handle_.get(), std::string(name).c_str(), H5P_DEFAULT), where_, "read the attribute");
  return read_string(attribute, where_);
}

}  // namespace gyro::hdf5
