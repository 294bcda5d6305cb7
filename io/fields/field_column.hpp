// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// A dataset of fields.h5 whose rows belong to frames.
///
/// The rows of a frame begin with a chunk, and the last chunk is filled up with zeros: a chunk is compressed and
/// written once, so that it never moves, and a process that is killed leaves the frames before it readable. What begins
/// like the rows stored last, as walls that stand still do, is not stored again.
class FieldColumn {
 public:
  /// Creates the dataset. @param rows  of the first frame, from which the size of a chunk follows
  static void create(hdf5::File& file, const std::string& name, hdf5::Number number, int columns, std::size_t rows);
  explicit FieldColumn(std::string name) : name_(std::move(name)) {}

  /// Stores the rows of a frame. @returns the first of them in the dataset
  template <class T>
  std::int64_t store(const hdf5::File& file, const std::vector<T>& values) {
    return store(file, std::as_bytes(std::span(values)), hdf5::number_of<T>());
  }
  /// The same, but always after all rows that there are.
  template <class T>
  std::int64_t append(const hdf5::File& file, const std::vector<T>& values) {
    return append(file, std::as_bytes(std::span(values)), hdf5::number_of<T>());
  }

 private:
  std::int64_t store(const hdf5::File& file, std::span<const std::byte> values, hdf5::Number number);
  std::int64_t append(const hdf5::File& file, std::span<const std::byte> values, hdf5::Number number) const;

  std::string name_;
  std::vector<std::byte> stored_;  ///< the rows that were stored last by this process
  std::int64_t stored_at_ = 0;
};

}  // namespace gyro
