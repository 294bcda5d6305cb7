// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/hdf5_internal.hpp"

#include <array>
#include <stdexcept>

namespace gyro::hdf5 {
namespace {

struct Extent {
  int rank;
  std::array<hsize_t, 2> size;  ///< rows, columns (1 for a one-dimensional dataset)
};

Extent extent_of(const Handle& dataset, const std::string& where) {
  const Handle space = own(H5Dget_space(dataset.get()), where, "read the shape");
  Extent extent{H5Sget_simple_extent_ndims(space.get()), {0, 1}};
  if (extent.rank < 1 || extent.rank > 2) throw std::logic_error(where + ": not a table");
  check(H5Sget_simple_extent_dims(space.get(), extent.size.data(), nullptr), where, "read the shape");
  return extent;
}

}  // namespace

Dataset::Dataset(Handle handle, std::string where) : handle_(std::move(handle)), where_(std::move(where)) {}

std::int64_t Dataset::rows() const {
  return static_cast<std::int64_t>(extent_of(handle_, where_).size[0]);
}

std::int64_t Dataset::columns() const {
  return static_cast<std::int64_t>(extent_of(handle_, where_).size[1]);
}

void Dataset::append(std::span<const double> values) {
  if (values.empty()) return;
  silence_library();
  Extent extent = extent_of(handle_, where_);
  if (values.size() % extent.size[1] != 0) throw std::logic_error(where_ + ": not a whole number of rows");
  const std::array<hsize_t, 2> start{extent.size[0], 0};
  const std::array<hsize_t, 2> count{values.size() / extent.size[1], extent.size[1]};
  extent.size[0] += count[0];
  check(H5Dset_extent(handle_.get(), extent.size.data()), where_, "grow");
  const Handle in_file = own(H5Dget_space(handle_.get()), where_, "read the shape");
  check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), where_,
        "select rows");
  const Handle in_memory = own(H5Screate_simple(extent.rank, count.data(), nullptr), where_, "select rows");
  check(H5Dwrite(handle_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, values.data()), where_,
        "write");
}

void Dataset::flush() {
  silence_library();
  check(H5Dflush(handle_.get()), where_, "write");
}

std::vector<double> Dataset::read() const {
  silence_library();
  const Extent extent = extent_of(handle_, where_);
  std::vector<double> values(extent.size[0] * extent.size[1]);
  if (!values.empty())
    check(H5Dread(handle_.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), where_, "read");
  return values;
}

void Dataset::set_attribute(std::string_view name, std::string_view value) {
  silence_library();
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
  silence_library();
  const Handle attribute =
      own(H5Aopen(handle_.get(), std::string(name).c_str(), H5P_DEFAULT), where_, "read the attribute");
  return read_string(attribute, where_);
}

}  // namespace gyro::hdf5
