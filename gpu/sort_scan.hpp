// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "gpu/buffer.hpp"
#include "gpu/step_graph.hpp"

namespace gyro {

/// Sort and scan on the device. Memory that they need on the way is kept for the next call.
class SortScan {
 public:
  /// In place: number k becomes the sum of those before it.
  void exclusive_scan(const Stream& stream, Index count, Index* numbers);
  /// Orders values by key; equal keys keep their order.
  void sort_by_key(const Stream& stream, DeviceBuffer<std::uint64_t>& keys, DeviceBuffer<Index>& values);

 private:
  DeviceBuffer<std::byte> scratch_;
  DeviceBuffer<std::uint64_t> other_keys_;
  DeviceBuffer<Index> other_values_;
};

}  // namespace gyro
