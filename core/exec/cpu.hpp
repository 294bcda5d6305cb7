// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exec/phase_timer.hpp"
#include "core/exec/thread_team.hpp"
#include "core/kernels/bond_pack.hpp"
#include "core/state/bonds.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace gyro {

/// The CPU executor: a team of threads, and packs. An executor is the only thing that the solver's loops
/// know of a machine; gpu/ has its twin. Contract of each operation:
///
///   for_each(label, n, kernel)      kernel(i) for i in [0, n), any order; no two calls write the same
///   for_each_block(label, list, k)  BondForces over the bonds of each block, in the bonds' order
///   reduce(label, n, map)           sum of map(i), added in a fixed order
///   exclusive_scan(n, counts)       in place, n + 1 numbers; returns the total
///   sort_by_key(keys, values)       stable
///   host, upload, append, keep      the host's side of a buffer
///
/// A buffer has size(), data() and resize(n), which keeps what is there and sets what is new to zero.
/// Its elements are read and written by kernels or through the last four operations only. Kernels get
/// pointers, which hold until the buffer is next given a size or contents.
///
/// Labels name the phases of a step for timers and profilers.
class Cpu {
 public:
  template <class T>
  using Buffer = std::vector<T>;

  explicit Cpu(int threads) : threads_(std::max(1, threads)), team_(std::make_unique<ThreadTeam>(threads_)) {}

  int threads() const { return threads_; }
  PhaseTimer& timer() { return timer_; }
  const PhaseTimer& timer() const { return timer_; }

  template <class Kernel>
  void for_each(const char* label, Index n, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    const PhaseTimer::Mark mark = timer_.begin(label);
    if (n < inline_limit || threads_ == 1) {
      for (Index i = 0; i < n; ++i) kernel(i);
    } else {
      const Index share = (n + threads_ - 1) / threads_;
      team_->run([&](int t) {
        const Index end = std::min(n, (t + 1) * share);
        for (Index i = t * share; i < end; ++i) kernel(i);
      });
    }
    timer_.end(mark);
  }

  /// @param kernel  BondForces or another kernel over the bonds of a block
  template <class Kernel>
  void for_each_block(const char* label, const BlockList& list, const Kernel& kernel) {
    const Block* blocks = list.blocks;  // the order of their bonds is enough for one thread: no colours
    const PhaseTimer::Mark mark = timer_.begin(label);
    // A thread starts with the rocks whose particles are its share of for_each, so that loads stay in its
    // cache, and then helps the others.
    std::vector<BlockRange> ranges = shares_of(blocks, list.count);
    team_->run([&](int t) {
      for (int turn = 0; turn < threads_; ++turn) {
        BlockRange& range = ranges[static_cast<std::size_t>((t + turn) % threads_)];
        for (Index k; (k = range.next.fetch_add(1, std::memory_order_relaxed)) < range.end;) {
          const Block block = blocks[k];
          for (Index p = block.first_particle; p < block.end_particle; ++p) kernel.clear(p);
          for (Index b = block.first_bond; b < block.end_bond; b += bond_alignment)
            kernel(PackLanes<bond_alignment>{b}, k);
        }
      }
    });
    timer_.end(mark);
  }

  template <class T, class Map>
  T reduce(const char* label, Index n, const Map& map) {
    const PhaseTimer::Mark mark = timer_.begin(label);
    const Index chunks = (n + chunk - 1) / chunk;
    std::vector<T> part(static_cast<std::size_t>(chunks));
    const auto add_up = [&](Index c) {
      T sum{};
      for (Index i = c * chunk; i < std::min(n, (c + 1) * chunk); ++i) sum = sum + map(i);
      part[static_cast<std::size_t>(c)] = sum;
    };
    if (chunks == 1) {
      add_up(0);
    } else {
      team_->run([&](int t) {
        for (Index c = t; c < chunks; c += threads_) add_up(c);
      });
    }
    T total{};
    for (const T& p : part) total = total + p;
    timer_.end(mark);
    return total;
  }

  static Index exclusive_scan(Index n, Index* counts) {
    Index sum = 0;
    for (Index i = 0; i <= n; ++i) {
      const Index count = i < n ? counts[i] : 0;
      counts[i] = sum;
      sum += count;
    }
    return sum;
  }

  /// Orders values by key, equal keys in their old order. Byte-wise radix sort that skips bytes in
  /// which all keys agree.
  void sort_by_key(Buffer<std::uint64_t>& keys, Buffer<Index>& values) {
    const std::size_t n = keys.size();
    spare_keys_.resize(n);
    spare_values_.resize(n);
    for (int shift = 0; shift < 64; shift += 8) {
      std::size_t count[257] = {};
      for (const std::uint64_t key : keys) ++count[((key >> shift) & 255) + 1];
      if (std::any_of(count + 1, count + 257, [n](std::size_t c) { return c == n; })) continue;
      std::partial_sum(count, count + 257, count);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t to = count[(keys[i] >> shift) & 255]++;
        spare_keys_[to] = keys[i];
        spare_values_[to] = values[i];
      }
      keys.swap(spare_keys_);
      values.swap(spare_values_);
    }
  }

  /// Host copy of a buffer, and back. On this executor both live in the same memory.
  template <class T>
  static const std::vector<T>& host(const Buffer<T>& buffer) {
    return buffer;
  }
  template <class T>
  static void upload(Buffer<T>& buffer, std::vector<T> values) {
    buffer = std::move(values);
  }
  /// Adds elements at the end.
  template <class T>
  static void append(Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.insert(buffer.end(), values.begin(), values.end());
  }
  /// Shortens a buffer: element k becomes what was element source[k], zero where that is `none`.
  /// @param source  source[k] >= k
  template <class T>
  static void keep(Buffer<T>& buffer, const std::vector<Index>& source) {
    for (std::size_t k = 0; k < source.size(); ++k)
      buffer[k] = source[k] == none ? T{} : buffer[static_cast<std::size_t>(source[k])];
    buffer.resize(source.size());
  }

 private:
  static constexpr Index inline_limit = 128;  // below, waking threads costs more than they save
  static constexpr Index chunk = 1024;

  /// Blocks [next, end) that one thread starts with. On a line of its own: threads count at the same time.
  struct alignas(64) BlockRange {
    std::atomic<Index> next{0};
    Index end = 0;
  };
  std::vector<BlockRange> shares_of(const Block* blocks, Index n) const {
    std::vector<BlockRange> ranges(static_cast<std::size_t>(threads_));
    const Index particles = n > 0 ? blocks[n - 1].end_particle : 0;
    const Index share = (particles + threads_ - 1) / threads_;
    Index block = 0;
    for (int t = 0; t < threads_; ++t) {
      BlockRange& range = ranges[static_cast<std::size_t>(t)];
      range.next = block;
      while (block < n && (t + 1 == threads_ || blocks[block].first_particle < (t + 1) * share)) ++block;
      range.end = block;
    }
    return ranges;
  }

  int threads_;
  std::unique_ptr<ThreadTeam> team_;
  PhaseTimer timer_;
  Buffer<std::uint64_t> spare_keys_;
  Buffer<Index> spare_values_;
};

}  // namespace gyro
