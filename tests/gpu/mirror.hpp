// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"
#include "core/exec/phase_timer.hpp"
#include "core/exec/traffic.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <new>
#include <numeric>
#include <stdexcept>

// A device made of host memory: what the CUDA executor demands of the solver, on any machine.

namespace gyro::test {

/// Memory that only kernels and copies can reach: at any other time a read or write is a crash.
class DeviceMemory {
 public:
  static DeviceMemory& instance() {
    static DeviceMemory memory;
    return memory;
  }
  void* take(std::size_t bytes) {
    const std::size_t from = used_;
    used_ += (bytes + 63) / 64 * 64;
    if (used_ > room) throw std::bad_alloc();
    return begin_ + from;
  }
  void open() { protect(PROT_READ | PROT_WRITE); }
  void shut() { protect(PROT_NONE); }
  /// When no buffer is left.
  void forget() {
    madvise(begin_, room, MADV_DONTNEED);  // what is not there need not be shut
    used_ = 0;
  }

 private:
  static constexpr std::size_t room = std::size_t{1} << 30;
  DeviceMemory()
      : begin_(static_cast<char*>(mmap(nullptr, room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0))) {
    if (begin_ == MAP_FAILED) throw std::bad_alloc();
  }
  void protect(int how) {
    if (mprotect(begin_, room, how) != 0) throw std::bad_alloc();
  }
  char* begin_;
  std::size_t used_ = 0;
};

/// While it lives, device memory can be reached.
struct Opened {
  Opened() { DeviceMemory::instance().open(); }
  ~Opened() { DeviceMemory::instance().shut(); }
};

template <class T>
class MirrorBuffer {
 public:
  MirrorBuffer() = default;
  MirrorBuffer(MirrorBuffer&& other) noexcept { swap(other); }
  MirrorBuffer& operator=(MirrorBuffer&& other) noexcept {
    swap(other);
    return *this;
  }
  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  void resize(std::size_t size) {
    const Opened opened;
    if (size > capacity_) {
      T* larger = static_cast<T*>(DeviceMemory::instance().take((size + size / 4) * sizeof(T)));
      if (size_ > 0) std::memcpy(static_cast<void*>(larger), data_, size_ * sizeof(T));
      data_ = larger;
      capacity_ = size + size / 4;
    }
    if (size > size_) std::memset(static_cast<void*>(data_ + size_), 0, (size - size_) * sizeof(T));
    size_ = size;
  }
  void swap(MirrorBuffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Twin of Cuda (gpu/cuda.cuh) that runs every loop backwards: no result may depend on the order. Steps ahead are
/// recorded once and run from the record, as a graph is; nothing else may be asked of the device meanwhile.
class Mirror {
 public:
  template <class T>
  using Buffer = MirrorBuffer<T>;
  template <class T>
  using Scratch = MirrorBuffer<T>;

  /// @param max_steps_ahead  at least 1
  explicit Mirror(int max_steps_ahead = 1000) : max_steps_ahead_(max_steps_ahead) {}

  const PhaseTimer& timer() const { return timer_; }
  ThreadTeam* host_team() const { return nullptr; }
  static std::vector<std::pair<std::string, std::int64_t>> traffic() { return by_name(counts); }
  inline static Traffic counts;  ///< since the program's start

  static constexpr bool runs_ahead = true;
  int max_steps_ahead() const { return max_steps_ahead_; }
  template <class Launches>
  void repeat(int times, const std::int32_t* halted, const Launches& launches) {
    expect_nothing_recorded();
    const Record record = recorded(launches);
    ++counts.graphs_recorded;
    counts.graph_launches += times;
    const Opened opened;
    for (int time = 0; time < times; ++time)
      for (const auto& kernel : record)
        if (*halted == 0) kernel();
  }

  template <class Kernel>
  void for_each(const char*, Index n, const Kernel& kernel) {
    launch([=] {
      for (Index i = n - 1; i >= 0; --i) kernel(i);
    });
  }
  template <class Kernel>
  void for_each_picked(const char*, Index n, const Kernel& kernel) {
    launch([=] {
      for (Index i = n - 1; i >= 0; --i)
        if (kernel.pick(i)) kernel(typename Kernel::Lane{i});
    });
  }
  template <class Kernel>
  void for_each_block(const char*, const BlockLaunch& shape, const Kernel& kernel) {
    launch([=] {
      for (Index k = shape.blocks - 1; k >= 0; --k) {
        const IndexRange colours = kernel.colours(k);
        for (int pass = 0; pass < kernel.passes(k); ++pass) {
          if constexpr (requires { kernel.rows(k); })
            for (Index row = kernel.rows(k).end - 1; row >= kernel.rows(k).begin; --row) kernel.prepare(row, k, pass);
          for (Index c = colours.begin; c < colours.end; ++c) {
            const IndexRange items = kernel.items_of_colour(c);
            for (Index item = items.end - 1; item >= items.begin; --item) kernel(typename Kernel::Lane{item}, k, pass);
          }
        }
      }
    });
  }
  template <class T, class Map>
  T reduce(const char*, Index n, const Map& map) {
    const Opened opened;
    count_read(sizeof(T));
    T total{};
    for (Index first = 0; first < n; first += 1024) {
      T sum{};
      for (Index i = first; i < std::min(n, first + 1024); ++i) sum = sum + map(i);
      total = total + sum;
    }
    return total;
  }
  Index exclusive_scan(Index n, Index* numbers) {
    const Opened opened;
    count_read(sizeof(Index));
    std::exclusive_scan(numbers, numbers + n + 1, numbers, 0);
    return numbers[n];
  }
  /// Into other memory, as a device does: pointers into the buffers are stale afterwards.
  void sort_by_key(Buffer<std::uint64_t>& keys, Buffer<Index>& values) {
    const std::vector<std::uint64_t> key = host(keys);
    const std::vector<Index> value = host(values);
    std::vector<std::size_t> order(key.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
    std::vector<std::uint64_t> sorted_keys;
    std::vector<Index> sorted_values;
    for (const std::size_t k : order) {
      sorted_keys.push_back(key[k]);
      sorted_values.push_back(value[k]);
    }
    Buffer<std::uint64_t> new_keys;
    Buffer<Index> new_values;
    upload(new_keys, sorted_keys);
    upload(new_values, sorted_values);
    keys.swap(new_keys);
    values.swap(new_values);
  }

  template <class T>
  static std::vector<T> host(const Buffer<T>& buffer) {
    const Opened opened;
    if (buffer.size() > 0) count_read(buffer.size() * sizeof(T));
    return std::vector<T>(buffer.data(), buffer.data() + buffer.size());
  }
  template <class T>
  static void upload(Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize(0);
    append(buffer, values);
  }
  template <class T>
  static void append(Buffer<T>& buffer, const std::vector<T>& values) {
    expect_nothing_recorded();
    ++counts.writes;
    counts.bytes_written += static_cast<std::int64_t>(values.size() * sizeof(T));
    const std::size_t first = buffer.size();
    buffer.resize(first + values.size());
    const Opened opened;
    std::copy(values.begin(), values.end(), buffer.data() + first);
  }
  template <class T>
  static void release(Buffer<T>&) {}
  template <class T>
  static void renew(Buffer<T>& buffer, std::size_t size) {
    buffer.resize(size);
  }
  template <class T>
  static void keep(Buffer<T>& buffer, const std::vector<Index>& source) {
    const std::vector<T> old = host(buffer);
    std::vector<T> kept(source.size());
    for (std::size_t k = 0; k < source.size(); ++k)
      kept[k] = source[k] == none ? T{} : old[static_cast<std::size_t>(source[k])];
    upload(buffer, kept);
  }

 private:
  using Record = std::vector<std::function<void()>>;
  template <class Launches>
  static Record recorded(const Launches& launches) {
    Record record;
    struct Recording {
      explicit Recording(Record& to) { recorded_ = &to; }
      ~Recording() { recorded_ = nullptr; }
    } const recording(record);
    launches();
    return record;
  }
  template <class Kernel>
  static void launch(const Kernel& kernel) {
    if (recorded_) return recorded_->push_back(kernel);
    const Opened opened;
    ++counts.launches;
    kernel();
  }
  static void count_read(std::size_t bytes) {
    expect_nothing_recorded();
    ++counts.reads;
    counts.bytes_read += static_cast<std::int64_t>(bytes);
  }
  static void expect_nothing_recorded() {
    if (recorded_) throw std::logic_error("something else than a launch among steps ahead");
  }

  inline static Record* recorded_ = nullptr;  ///< null except in repeat()
  PhaseTimer timer_;
  int max_steps_ahead_;
};

}  // namespace gyro::test
