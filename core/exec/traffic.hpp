// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// What has passed between the host and a device since the program's start.
struct Traffic {
  std::int64_t launches = 0;        ///< of kernels by the host, one by one
  std::int64_t graph_launches = 0;  ///< each of a whole step
  std::int64_t graphs_recorded = 0;
  std::int64_t graphs_made = 0;  ///< from records; the others changed the arguments of one that was there
  std::int64_t reads = 0, bytes_read = 0;
  std::int64_t writes = 0, bytes_written = 0;

  template <class F, class... T>
  static constexpr void for_each_field(F&& f, T&... t) {
    f("launches", t.launches...);
    f("graph_launches", t.graph_launches...);
    f("graphs_recorded", t.graphs_recorded...);
    f("graphs_made", t.graphs_made...);
    f("reads", t.reads...);
    f("bytes_read", t.bytes_read...);
    f("writes", t.writes...);
    f("bytes_written", t.bytes_written...);
  }
};
static_assert(declares_every_field<Traffic>);

inline std::vector<std::pair<std::string, std::int64_t>> by_name(const Traffic& traffic) {
  std::vector<std::pair<std::string, std::int64_t>> numbers;
  Traffic::for_each_field([&](const char* name, const std::int64_t& n) { numbers.emplace_back(name, n); }, traffic);
  return numbers;
}

}  // namespace gyro
