// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/check_cuda.hpp"
#include "gpu/traffic.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace gyro {

/// Copies to the host, after all that the device has been asked to do.
template <class T>
void read(T* host, const T* device, std::size_t count) {
  if (count == 0) return;
  count_read(count * sizeof(T));
  check_cuda(cudaMemcpy(host, device, count * sizeof(T), cudaMemcpyDeviceToHost), "reading from the device");
}

/// Array in device memory. Elements travel as bytes; the host never touches them one by one.
template <class T>
class DeviceBuffer {
  static_assert(std::is_trivially_copyable_v<T>, "elements travel to the device as bytes");

 public:
  DeviceBuffer() = default;
  DeviceBuffer(DeviceBuffer&& other) noexcept { swap(other); }
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~DeviceBuffer() { cudaFree(data_); }  // a failure here has been reported by the call that caused it

  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }

  /// Keeps what is there; new elements are zero bytes. Pointers hold while the size does not grow.
  /// @throws NoDevice when memory runs out
  void resize(std::size_t size) {
    if (size > capacity_) grow(size);
    if (size > size_) check_cuda(cudaMemset(data_ + size_, 0, (size - size_) * sizeof(T)), "clearing device memory");
    size_ = size;
  }

  std::vector<T> to_host() const {
    std::vector<T> values(size_);
    read(values.data(), data_, size_);
    return values;
  }
  /// Replaces elements from `first` on and sets the size to their end.
  void from_host(std::size_t first, const std::vector<T>& values) {
    if (first + values.size() > capacity_) grow(first + values.size());
    size_ = first + values.size();
    if (values.empty()) return;
    count_write(values.size() * sizeof(T));
    check_cuda(cudaMemcpy(data_ + first, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice),
               "writing to the device");
  }

  void swap(DeviceBuffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  void grow(std::size_t size) {
    DeviceBuffer larger;
    larger.capacity_ = size + size / 4;  // lists grow a little at each rebuild
    check_cuda(cudaMalloc(&larger.data_, larger.capacity_ * sizeof(T)), "asking for device memory");
    larger.size_ = size_;
    if (size_ > 0)
      check_cuda(cudaMemcpy(larger.data_, data_, size_ * sizeof(T), cudaMemcpyDeviceToDevice), "moving device memory");
    swap(larger);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace gyro
