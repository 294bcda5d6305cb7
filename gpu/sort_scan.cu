// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that sees CUB: it takes longer to compile than all of our own kernels.
#include "gpu/sort_scan.hpp"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

namespace gyro {

void SortScan::exclusive_scan(const Stream& stream, Index count, Index* numbers) {
  std::size_t bytes = 0;
  check_cuda(cub::DeviceScan::ExclusiveSum(nullptr, bytes, numbers, numbers, count, stream.get()), "sizing a scan");
  scratch_.resize(bytes);
  check_cuda(cub::DeviceScan::ExclusiveSum(scratch_.data(), bytes, numbers, numbers, count, stream.get()), "scanning");
}

void SortScan::sort_by_key(const Stream& stream, DeviceBuffer<std::uint64_t>& keys, DeviceBuffer<Index>& values) {
  const auto count = static_cast<Index>(keys.size());
  other_keys_.resize(keys.size());
  other_values_.resize(values.size());
  cub::DoubleBuffer<std::uint64_t> both_keys(keys.data(), other_keys_.data());
  cub::DoubleBuffer<Index> both_values(values.data(), other_values_.data());
  constexpr int bits = 8 * sizeof(std::uint64_t);
  std::size_t bytes = 0;
  check_cuda(cub::DeviceRadixSort::SortPairs(nullptr, bytes, both_keys, both_values, count, 0, bits, stream.get()),
             "sizing a sort");
  scratch_.resize(bytes);
  check_cuda(
      cub::DeviceRadixSort::SortPairs(scratch_.data(), bytes, both_keys, both_values, count, 0, bits, stream.get()),
      "sorting");
  // The result lies where the last pass put it, and may lie in a different buffer for each of the two.
  if (both_keys.selector == 1) keys.swap(other_keys_);
  if (both_values.selector == 1) values.swap(other_values_);
}

}  // namespace gyro
