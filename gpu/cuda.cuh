// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index_range.hpp"
#include "core/exec/block_launch.hpp"
#include "core/exec/phase_timer.hpp"
#include "gpu/sort_scan.hpp"
#include "gpu/step_graph.hpp"
#include "gpu/traffic.hpp"

#include <exception>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gyro {

// The only __global__ functions of the project, but for those of CUB. Kernels are the structs of
// core/kernels; they stay in constant memory (__grid_constant__), no thread copies them. Those of steps ahead of the
// host do nothing while *halted.

inline constexpr int threads_per_block = 128, warp = 32;

/// Thread blocks that must fit on a multiprocessor at once: 4 lets a thread have 128 registers, which most kernels do
/// with. A kernel that would spill (scripts/kernel_report.py) has a member blocks_at_once that asks for fewer.
template <class Kernel>
constexpr int blocks_at_once() {
  if constexpr (requires { Kernel::blocks_at_once; })
    return Kernel::blocks_at_once;
  else
    return 4;
}

inline constexpr Index reduce_chunk = 1024;  // as on the CPU: sums are added in the same order
inline constexpr Index reduce_tile = 32;

/// @param halted  may be null; EnterStep, which sets it, has one thread
__device__ inline bool is_halted(const std::int32_t* halted) {
  return halted != nullptr && *halted != 0;
}

template <class Kernel>
__global__ void __launch_bounds__(threads_per_block, blocks_at_once<Kernel>())
    run_each(Index n, const std::int32_t* halted, const __grid_constant__ Kernel kernel) {
  const Index i = static_cast<Index>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n && !is_halted(halted)) kernel(i);
}

template <class Kernel>
__global__ void __launch_bounds__(threads_per_block, blocks_at_once<Kernel>())
    run_picked(Index n, const std::int32_t* halted, const __grid_constant__ Kernel kernel) {
  const Index i = static_cast<Index>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n && !is_halted(halted) && kernel.pick(i)) kernel(typename Kernel::Lane{i});
}

/// One thread block for each block of the kernel, colour by colour: items are added to rows in the order of the CPU.
template <class Kernel>
__global__ void __launch_bounds__(threads_per_block, blocks_at_once<Kernel>())
    run_blocks(const std::int32_t* halted, const __grid_constant__ Kernel kernel) {
  if (is_halted(halted)) return;
  const Index k = static_cast<Index>(blockIdx.x), step = static_cast<Index>(blockDim.x),
              me = static_cast<Index>(threadIdx.x);
  const IndexRange colours = kernel.colours(k);
  const int passes = kernel.passes(k);
  for (int pass = 0; pass < passes; ++pass) {
    if constexpr (requires { kernel.rows(k); }) {
      const IndexRange rows = kernel.rows(k);
      for (Index row = rows.begin + me; row < rows.end; row += step) kernel.prepare(row, k, pass);
      __syncthreads();
    }
    for (Index c = colours.begin; c < colours.end; ++c) {
      const IndexRange items = kernel.items_of_colour(c);
      for (Index item = items.begin + me; item < items.end; item += step) kernel(typename Kernel::Lane{item}, k, pass);
      __syncthreads();
    }
  }
}

/// Sum of each chunk, in order. The threads of a warp map together, one of them adds.
template <class T, class Map>
__global__ void __launch_bounds__(reduce_tile, 8) sum_chunks(Index n, const __grid_constant__ Map map, T* part) {
  __shared__ alignas(T) unsigned char bytes[reduce_tile * sizeof(T)];
  T* tile = reinterpret_cast<T*>(bytes);
  const Index me = static_cast<Index>(threadIdx.x), first = static_cast<Index>(blockIdx.x) * reduce_chunk;
  const Index end = n - first < reduce_chunk ? n : first + reduce_chunk;
  T sum{};
  for (Index i = first; i < end; i += reduce_tile) {
    if (i + me < end) tile[me] = map(i + me);
    __syncthreads();
    if (me == 0)
      for (Index k = 0; k < reduce_tile && i + k < end; ++k) sum = sum + tile[k];
    __syncthreads();
  }
  if (me == 0) part[blockIdx.x] = sum;
}

/// Element k becomes what was element source[k], zero where that is `none`.
template <class T>
struct Keep {
  const T* from;
  const Index* source;
  T* to;  ///< zero at first
  GYRO_HD void operator()(Index k) const {
    if (source[k] != none) to[k] = from[source[k]];
  }
};

class ThreadTeam;

/// The CUDA executor: the contract is in core/exec/cpu.hpp. Everything runs on one stream, in order. Making one throws
/// NoDevice when there is no device to use.
class Cuda {
 public:
  template <class T>
  using Buffer = DeviceBuffer<T>;
  template <class T>
  using Scratch = DeviceBuffer<T>;

  /// Host seconds by phase: of launching, unless GYRO_CUDA_SYNC=1 is set in the environment, which
  /// waits for every kernel.
  const PhaseTimer& timer() const { return timer_; }

  ThreadTeam* host_team() const { return nullptr; }
  static std::vector<std::pair<std::string, std::int64_t>> traffic() { return by_name(gyro::traffic()); }

  static constexpr bool runs_ahead = true;
  int max_steps_ahead() const { return max_steps_ahead_; }

  /// From some steps on as a graph: each is one call of the host. Recording one costs about as much as launching a
  /// step.
  template <class Launches>
  void repeat(int times, const std::int32_t* halted, const Launches& launches) {
    const Halting scope(halted_, halted);
    if (times < steps_worth_a_graph || !with_graphs_ || !recorded(launches)) {
      for (int time = 0; time < times; ++time) launches();
      return;
    }
    const PhaseTimer::Mark mark = timer_.begin("steps in graphs");
    for (int time = 0; time < times; ++time) graph_.launch(stream_);
    timer_.end(mark);
  }

  template <class Kernel>
  void for_each(const char* label, Index n, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    if (n == 0) return;
    const PhaseTimer::Mark mark = timer_.begin(label);
    run_each<<<blocks_for(n), threads_per_block, 0, stream_.get()>>>(n, halted_, kernel);
    finish(label, mark);
  }

  template <class Kernel>
  void for_each_picked(const char* label, Index n, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    if (n == 0) return;
    const PhaseTimer::Mark mark = timer_.begin(label);
    run_picked<<<blocks_for(n), threads_per_block, 0, stream_.get()>>>(n, halted_, kernel);
    finish(label, mark);
  }

  /// A colour is one pass of the block's threads: more of them than a colour has bonds would only wait.
  template <class Kernel>
  void for_each_block(const char* label, const BlockLaunch& launch, const Kernel& kernel) {
    static_assert(std::is_trivially_copyable_v<Kernel>, "kernels travel to the device as bytes");
    if (launch.blocks == 0) return;
    const PhaseTimer::Mark mark = timer_.begin(label);
    const unsigned threads = launch.colour_size <= warp       ? warp
                             : launch.colour_size <= 2 * warp ? 2 * warp
                                                              : threads_per_block;
    run_blocks<<<static_cast<unsigned>(launch.blocks), threads, 0, stream_.get()>>>(halted_, kernel);
    finish(label, mark);
  }

  template <class T, class Map>
  T reduce(const char* label, Index n, const Map& map) {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_copyable_v<Map>, "they travel as bytes");
    T total{};
    if (n == 0) return total;
    const PhaseTimer::Mark mark = timer_.begin(label);
    const Index chunks = (n + reduce_chunk - 1) / reduce_chunk;
    std::vector<T> parts(static_cast<std::size_t>(chunks));
    if (parts_.size() < parts.size() * sizeof(T)) parts_.resize(parts.size() * sizeof(T));
    T* const on_device = reinterpret_cast<T*>(parts_.data());  // aligned for any T, as all device memory is
    sum_chunks<<<static_cast<unsigned>(chunks), reduce_tile, 0, stream_.get()>>>(n, map, on_device);
    finish(label, mark);
    read(parts.data(), on_device, parts.size());
    for (const T& p : parts) total = total + p;
    return total;
  }

  Index exclusive_scan(Index n, Index* counts) {
    sort_scan_.exclusive_scan(stream_, n + 1, counts);
    Index total = 0;
    read(&total, counts + n, 1);
    return total;
  }
  void sort_by_key(Buffer<std::uint64_t>& keys, Buffer<Index>& values) {
    if (keys.size() > 0) sort_scan_.sort_by_key(stream_, keys, values);
  }

  template <class T>
  static std::vector<T> host(const Buffer<T>& buffer) {
    return buffer.to_host();
  }
  template <class T>
  static void upload(Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.from_host(0, values);
  }
  template <class T>
  static void append(Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.from_host(buffer.size(), values);
  }
  template <class T>
  static void release(Buffer<T>&) {}  // asking for it again would cost more than a rebuild of the lists
  template <class T>
  static void renew(Buffer<T>& buffer, std::size_t size) {
    buffer.resize(size);
  }
  template <class T>
  static void keep(Buffer<T>& buffer, const std::vector<Index>& source) {
    Buffer<Index> places;
    upload(places, source);
    Buffer<T> kept;
    kept.resize(source.size());
    const auto n = static_cast<Index>(source.size());
    if (n > 0) {  // on the default stream, in order with the executor's own
      run_each<<<blocks_for(n), threads_per_block>>>(n, nullptr, Keep<T>{buffer.data(), places.data(), kept.data()});
      count_launch("keep");
    }
    buffer.swap(kept);
  }

 private:
  static constexpr int steps_worth_a_graph = 4;

  /// While it lives, kernels do nothing while *halted.
  class Halting {
   public:
    Halting(const std::int32_t*& place, const std::int32_t* halted) : place_(place) { place_ = halted; }
    ~Halting() { place_ = nullptr; }
    Halting(const Halting&) = delete;
    Halting& operator=(const Halting&) = delete;

   private:
    const std::int32_t*& place_;
  };

  /// Graphs save time only: without one, the steps are launched one by one, and say what is wrong if they cannot be.
  template <class Launches>
  bool recorded(const Launches& launches) {
    try {
      graph_.record(stream_, launches);
    } catch (const std::exception&) {
      with_graphs_ = false;
    }
    return with_graphs_;
  }

  static unsigned blocks_for(Index n) { return static_cast<unsigned>((n - 1) / threads_per_block + 1); }

  static void count_launch(const char* label) {
    check_cuda(cudaGetLastError(), label);
    ++gyro::traffic().launches;
  }
  void finish(const char* label, const PhaseTimer::Mark& mark) {
    count_launch(label);
    wait_if_asked(label, mark);
  }
  void wait_if_asked(const char* label, const PhaseTimer::Mark& mark) {
    if (wait_for_all_) check_cuda(cudaDeviceSynchronize(), label);
    timer_.end(mark);
  }

  struct Device {
    Device() { take_device(); }
  };

  Device device_;  // before all that needs one
  bool wait_for_all_ = waits_for_all();
  bool with_graphs_ = !wait_for_all_ && !without_graphs();
  int max_steps_ahead_ = gyro::max_steps_ahead();
  PhaseTimer timer_;
  Stream stream_;
  StepGraph graph_;
  const std::int32_t* halted_ = nullptr;  ///< of steps ahead; null except in repeat()
  SortScan sort_scan_;
  Buffer<std::byte> parts_;  ///< of a sum
};

}  // namespace gyro
