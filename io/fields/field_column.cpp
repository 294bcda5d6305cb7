// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/field_column.hpp"

#include <algorithm>
#include <bit>

namespace gyro {
namespace {

// A frame like the first has some four chunks: fewer would fill up more, more would cost time and space for their
// index.
constexpr std::size_t smallest_chunk = 1024, largest_chunk = 16384;  // rows
constexpr int compression = 4;                                       // zlib's level

std::size_t chunk_rows(std::size_t rows) {
  return std::clamp(std::bit_ceil(rows / 4 + 1), smallest_chunk, largest_chunk);
}

std::int64_t rounded_up(std::int64_t rows, std::int64_t chunk) {
  return (rows + chunk - 1) / chunk * chunk;
}

}  // namespace

void FieldColumn::create(hdf5::File& file, const std::string& name, hdf5::Number number, int columns,
                         std::size_t rows) {
  file.create_dataset(name, {number, columns, static_cast<std::int64_t>(chunk_rows(rows)), compression});
}

std::int64_t FieldColumn::store(const hdf5::File& file, std::span<const std::byte> values, hdf5::Number number) {
  const bool same = values.size() <= stored_.size() && std::equal(values.begin(), values.end(), stored_.begin());
  if (same) return stored_at_;
  stored_at_ = append(file, values, number);
  stored_.assign(values.begin(), values.end());
  return stored_at_;
}

std::int64_t FieldColumn::append(const hdf5::File& file, std::span<const std::byte> values, hdf5::Number number) const {
  hdf5::Dataset dataset = file.dataset(name_);
  const std::int64_t first = dataset.rows();
  dataset.append(values.data(), values.size() / hdf5::size_of(number), number);
  dataset.resize(rounded_up(dataset.rows(), dataset.chunk_rows()));
  return first;
}

}  // namespace gyro
