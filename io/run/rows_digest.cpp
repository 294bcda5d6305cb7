// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/rows_digest.hpp"

#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

namespace gyro {
namespace {

/// As HDF5 converts it: integers end at their limits.
template <class T>
T stored(double number) {
  if constexpr (std::integral<T>) {
    using Limits = std::numeric_limits<T>;
    if (std::isnan(number)) return 0;
    if (number <= static_cast<double>(Limits::min())) return Limits::min();
    if (number >= static_cast<double>(Limits::max())) return Limits::max();
  }
  return static_cast<T>(number);
}

template <class T>
void update(Digest& digest, std::span<const double> numbers) {
  std::vector<T> in_file(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) in_file[k] = stored<T>(numbers[k]);
  const auto bytes = std::as_bytes(std::span(in_file));
  digest.update({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

void RowsDigest::add(std::span<const double> numbers) {
  switch (number_) {
    case hdf5::Number::float32:
      return update<float>(digest_, numbers);
    case hdf5::Number::float64:
      return update<double>(digest_, numbers);
    case hdf5::Number::uint8:
      return update<std::uint8_t>(digest_, numbers);
    case hdf5::Number::int32:
      return update<std::int32_t>(digest_, numbers);
    case hdf5::Number::uint32:
      return update<std::uint32_t>(digest_, numbers);
    case hdf5::Number::int64:
      return update<std::int64_t>(digest_, numbers);
  }
}

}  // namespace gyro
