// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/base/index_range.hpp"
#include "core/base/thread_team.hpp"
#include "core/exec/block_launch.hpp"
#include "core/exec/phase_timer.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gyro {

/// The CPU executor: a team of threads. An executor is the only thing that the solver's loops know of a machine,
/// and knows nothing of what they compute; gpu/ has its twin. Contract of each operation:
///
///   for_each(label, n, kernel)             kernel(i) for i in [0, n), any order; no two calls write the same
///   for_each_picked(label, n, kernel)      kernel(lanes) over those i of [0, n) for which kernel.pick(i), called once
///                                          each, is true; any order. A kernel may have pick_each(pack) too, which
///                                          says it of a PickPack of neighbouring i
///   for_each_block(label, launch, kernel)  kernel(lanes, k, pass) over the items of each block k, see below
///   reduce(label, n, map)                  sum of map(i), added in a fixed order
///   exclusive_scan(n, counts)              in place, n + 1 numbers; returns the total
///   sort_by_key(keys, values)              stable
///   host, upload, append, keep             the host's side of a buffer
///   release(buffer)                        its memory, where that costs little; it is renewed before it is used again
///   renew(buffer, n)                       gives it a size, whatever its contents are then: never two copies of them
///   host_team()                            threads for work on the host; null without any
///   traffic()                              what has passed between host and device; empty without a device
///   runs_ahead                             whether it takes steps while the host does not look: only then is there
///   max_steps_ahead()                       how many of them at most, and
///   repeat(times, halted, launches)          launches(), which does nothing but launch kernels, `times` times with the
///                                            arguments of the first time; while *halted, these kernels do nothing
///
/// A kernel over blocks says how its work lies: rows(k), if it has rows, are prepared first, by prepare(row, k, pass);
/// items(k) are then worked on as if one after the other; both passes(k) times. A CPU core takes Kernel::Pack::count
/// items at a time, and rows by prepare(RowPack{row}, k, pass), Kernel::RowPack::count at a time; the last ones one by
/// one. A GPU takes one item a thread (Kernel::Lane) and all items of a colour at once, for the colours(k) in their
/// order. share(k) are ranges, of rows or items, that measure the work; they are disjoint and ascend with k.
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

  /// Room for elements that kernels write before they are read: memory that none is written to is never taken. A new
  /// size loses what it holds.
  template <class T>
  class Scratch {
   public:
    std::size_t size() const { return size_; }
    T* data() { return elements_.get(); }
    const T* data() const { return elements_.get(); }
    void resize(std::size_t size) {
      if (size > size_) elements_.reset(), elements_ = std::make_unique_for_overwrite<T[]>(size);
      size_ = size;
    }

   private:
    std::unique_ptr<T[]> elements_;
    std::size_t size_ = 0;
  };

  /// @param threads  at least 1
  explicit Cpu(int threads) : threads_(std::max(1, threads)), team_(std::make_unique<ThreadTeam>(threads_)) {}

  static constexpr bool runs_ahead = false;
  static int max_steps_ahead() { return 1; }
  static std::vector<std::pair<std::string, std::int64_t>> traffic() { return {}; }

  int threads() const { return threads_; }
  ThreadTeam* host_team() const { return team_.get(); }
  PhaseTimer& timer() { return timer_; }
  const PhaseTimer& timer() const { return timer_; }

  template <class Kernel>
  void for_each(const char* label, Index n, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    GYRO_EXPECT(n >= 0);
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

  template <class Kernel>
  void for_each_picked(const char* label, Index n, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    GYRO_EXPECT(n >= 0);
    const PhaseTimer::Mark mark = timer_.begin(label);
    if (n < inline_limit || threads_ == 1) {
      work_on_picked({0, n}, kernel);
    } else {
      const Index share = (n + threads_ - 1) / threads_;
      team_->run([&](int t) { work_on_picked({std::min(n, t * share), std::min(n, (t + 1) * share)}, kernel); });
    }
    timer_.end(mark);
  }

  template <class Kernel>
  void for_each_block(const char* label, const BlockLaunch& launch, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    if (launch.blocks == 0) return;
    const PhaseTimer::Mark mark = timer_.begin(label);
    if (threads_ == 1 || kernel.share(launch.blocks - 1).end - kernel.share(0).begin < inline_limit) {
      for (Index k = 0; k < launch.blocks; ++k) work_on_block(k, kernel);
    } else {
      // A thread starts with its share of the work, the same in each step, so that it stays in its cache, and then
      // helps the others.
      std::vector<BlockShare> shares = shares_of(launch.blocks, kernel);
      team_->run([&](int t) {
        for (int turn = 0; turn < threads_; ++turn) {
          BlockShare& share = shares[static_cast<std::size_t>((t + turn) % threads_)];
          for (Index k; (k = share.next.fetch_add(1, std::memory_order_relaxed)) < share.end;) work_on_block(k, kernel);
        }
      });
    }
    timer_.end(mark);
  }

  template <class T, class Map>
  T reduce(const char* label, Index n, const Map& map) {
    GYRO_EXPECT(n >= 0);
    if (n == 0) return T{};
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
    GYRO_EXPECT(n >= 0 && counts != nullptr);
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
    GYRO_EXPECT(values.size() == n);
    Buffer<std::uint64_t> spare_keys(n);
    Buffer<Index> spare_values(n);
    for (int shift = 0; shift < 64; shift += 8) {
      std::size_t count[257] = {};
      for (const std::uint64_t key : keys) ++count[((key >> shift) & 255) + 1];
      if (std::any_of(count + 1, count + 257, [n](std::size_t c) { return c == n; })) continue;
      std::partial_sum(count, count + 257, count);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t to = count[(keys[i] >> shift) & 255]++;
        spare_keys[to] = keys[i];
        spare_values[to] = values[i];
      }
      keys.swap(spare_keys);
      values.swap(spare_values);
    }
  }

  /// Host copy of a buffer, and back. On this executor both live in the same memory.
  template <class T>
  static const std::vector<T>& host(const Buffer<T>& buffer) {
    return buffer;
  }
  template <class T>
  static std::span<const T> host(const Scratch<T>& scratch) {
    return {scratch.data(), scratch.size()};
  }
  template <class T>
  static void upload(Buffer<T>& buffer, std::vector<T> values) {
    buffer = std::move(values);
  }
  /// Adds elements at the end. A buffer that must grow gets an eighth more than it needs, where a vector would double.
  template <class T>
  static void append(Buffer<T>& buffer, std::vector<T> values) {
    const std::size_t size = buffer.size() + values.size();
    if (buffer.empty()) {
      buffer = std::move(values);
      return;
    }
    if (size > buffer.capacity()) buffer.reserve(size + size / 8);
    buffer.insert(buffer.end(), values.begin(), values.end());
  }
  /// Rearranges a buffer: element k becomes what was element source[k], zero where that is `none`. In place where
  /// elements only move to the front.
  template <class T>
  static void keep(Buffer<T>& buffer, const std::vector<Index>& source) {
    Buffer<T> rearranged;
    bool in_place = source.size() <= buffer.size();
    for (std::size_t k = 0; k < source.size(); ++k) {
      GYRO_EXPECT(source[k] == none || (source[k] >= 0 && source[k] < static_cast<Index>(buffer.size())));
      in_place = in_place && (source[k] == none || source[k] >= static_cast<Index>(k));
    }
    if (!in_place) rearranged.resize(source.size());
    Buffer<T>& to = in_place ? buffer : rearranged;
    for (std::size_t k = 0; k < source.size(); ++k)
      to[k] = source[k] == none ? T{} : buffer[static_cast<std::size_t>(source[k])];
    if (in_place)
      buffer.resize(source.size());
    else
      buffer.swap(rearranged);
  }

  template <class T>
  static void renew(Buffer<T>& buffer, std::size_t size) {
    if (size > buffer.capacity()) Buffer<T>().swap(buffer), buffer.reserve(size + size / 8);
    buffer.resize(size);
  }

  template <class T>
  static void release(Buffer<T>& buffer) {
    Buffer<T>().swap(buffer);
  }

 private:
  static constexpr Index inline_limit = 128;  // below, waking threads costs more than they save
  static constexpr Index chunk = 1024;

  /// The order of items is enough for one thread: no colours.
  template <class Kernel>
  static void work_on_block(Index k, const Kernel& kernel) {
    using Pack = typename Kernel::Pack;
    const IndexRange items = kernel.items(k);
    const int passes = kernel.passes(k);
    for (int pass = 0; pass < passes; ++pass) {
      if constexpr (requires { kernel.rows(k); }) prepare_rows(k, pass, kernel);
      Index item = items.begin;
      for (; item + Pack::count <= items.end; item += Pack::count) kernel(Pack{item}, k, pass);
      for (; item < items.end; ++item) kernel(typename Kernel::Lane{item}, k, pass);
    }
  }
  template <class Kernel>
  static void prepare_rows(Index k, int pass, const Kernel& kernel) {
    using RowPack = typename Kernel::RowPack;
    const IndexRange rows = kernel.rows(k);
    Index row = rows.begin;
    for (; row + RowPack::count <= rows.end; row += RowPack::count) kernel.prepare(RowPack{row}, k, pass);
    for (; row < rows.end; ++row) kernel.prepare(row, k, pass);
  }
  /// Works on the picked indices in packs, and on the last ones, which do not fill a pack, one by one.
  template <class Kernel>
  static void work_on_picked(const IndexRange& range, const Kernel& kernel) {
    constexpr int room = 64, lanes = Kernel::Pack::count;
    static_assert(room % lanes == 0);
    Index picked[room + lanes];
    int count = 0;
    const auto take = [&](Index i) {
      if constexpr (lanes == 1) {
        kernel(typename Kernel::Lane{i});
      } else {
        picked[count++] = i;
        if (count < room) return;
        for (int k = 0; k < room; k += lanes) kernel(typename Kernel::Pack{picked + k});
        count = 0;
      }
    };
    Index i = range.begin;
    if constexpr (lanes > 1 && requires { typename Kernel::PickPack; }) {
      constexpr int looks = Kernel::PickPack::count;
      static_assert(looks <= lanes);
      for (; i + looks <= range.end; i += looks) {
        Index run[looks];
        std::iota(run, run + looks, i);
        const std::uint32_t bits = kernel.pick_each(typename Kernel::PickPack{run});
        for (int k = 0; k < looks; ++k) {  // no branch: a processor cannot predict which are picked
          picked[count] = i + k;
          count += static_cast<int>(bits >> k & 1u);
        }
        if (count < room) continue;
        for (int k = 0; k < room; k += lanes) kernel(typename Kernel::Pack{picked + k});
        count -= room;
        std::copy_n(picked + room, count, picked);
      }
    }
    for (; i < range.end; ++i)
      if (kernel.pick(i)) take(i);
    int k = 0;
    if constexpr (lanes > 1)
      for (; k + lanes <= count; k += lanes) kernel(typename Kernel::Pack{picked + k});
    for (; k < count; ++k) kernel(typename Kernel::Lane{picked[k]});
  }
  /// Blocks [next, end) that one thread starts with. On a cache line of its own: all threads count down theirs.
  struct alignas(64) BlockShare {
    std::atomic<Index> next{0};
    Index end = 0;
  };
  template <class Kernel>
  std::vector<BlockShare> shares_of(Index blocks, const Kernel& kernel) const {
    std::vector<BlockShare> shares(static_cast<std::size_t>(threads_));
    const Index begin = kernel.share(0).begin, work = kernel.share(blocks - 1).end - begin;
    const Index each = (work + threads_ - 1) / threads_;
    Index block = 0;
    for (int t = 0; t < threads_; ++t) {
      BlockShare& share = shares[static_cast<std::size_t>(t)];
      share.next = block;
      while (block < blocks && (t + 1 == threads_ || kernel.share(block).begin - begin < (t + 1) * each)) ++block;
      share.end = block;
    }
    return shares;
  }

  int threads_;
  std::unique_ptr<ThreadTeam> team_;
  PhaseTimer timer_;
};

}  // namespace gyro
