// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"
#include "core/exec/phase_timer.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <span>

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
  void forget() { used_ = 0; }  ///< when no buffer is left

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

/// Twin of Cuda (gpu/cuda.cuh) that runs every loop backwards: no result may depend on the order.
class Mirror {
 public:
  template <class T>
  using Buffer = MirrorBuffer<T>;

  const PhaseTimer& timer() const { return timer_; }
  ThreadTeam* host_team() const { return nullptr; }

  template <class Kernel>
  void for_each(const char*, Index n, const Kernel& kernel) {
    const Opened opened;
    for (Index i = n - 1; i >= 0; --i) kernel(i);
  }
  template <class Kernel>
  void for_each_picked(const char*, Index n, const Kernel& kernel) {
    const Opened opened;
    for (Index i = n - 1; i >= 0; --i)
      if (kernel.pick(i)) kernel(typename Kernel::Lane{i});
  }
  template <class Kernel>
  void for_each_block(const char*, const BlockLaunch& launch, const Kernel& kernel) {
    const Opened opened;
    for (Index k = launch.blocks - 1; k >= 0; --k) {
      const IndexRange rows = kernel.rows(k), colours = kernel.colours(k);
      for (int pass = 0; pass < kernel.passes(k); ++pass) {
        for (Index row = rows.end - 1; row >= rows.begin; --row) kernel.prepare(row, k, pass);
        for (Index c = colours.begin; c < colours.end; ++c) {
          const IndexRange items = kernel.items_of_colour(c);
          for (Index item = items.end - 1; item >= items.begin; --item) kernel(typename Kernel::Lane{item}, k, pass);
        }
      }
    }
  }
  template <class Kernel>
  void for_each_colour(const char*, std::span<const Index> colour_begin, const Kernel& kernel) {
    const Opened opened;
    for (std::size_t c = 0; c + 1 < colour_begin.size(); ++c)
      for (Index item = colour_begin[c + 1] - 1; item >= colour_begin[c]; --item) kernel(typename Kernel::Lane{item});
  }
  template <class T, class Map>
  T reduce(const char*, Index n, const Map& map) {
    const Opened opened;
    T total{};
    for (Index first = 0; first < n; first += 1024) {
      T sum{};
      for (Index i = first; i < std::min(n, first + 1024); ++i) sum = sum + map(i);
      total = total + sum;
    }
    return total;
  }
  Index exclusive_scan(Index n, Index* counts) {
    const Opened opened;
    std::exclusive_scan(counts, counts + n + 1, counts, 0);
    return counts[n];
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
    return std::vector<T>(buffer.data(), buffer.data() + buffer.size());
  }
  template <class T>
  static void upload(Buffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize(0);
    append(buffer, values);
  }
  template <class T>
  static void append(Buffer<T>& buffer, const std::vector<T>& values) {
    const std::size_t first = buffer.size();
    buffer.resize(first + values.size());
    const Opened opened;
    std::copy(values.begin(), values.end(), buffer.data() + first);
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
  PhaseTimer timer_;
};

}  // namespace gyro::test
