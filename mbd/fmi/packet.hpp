// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace gyro {

/// Message between two processes of this program: a sequence of values and lists, read in the order of writing.
class Packet {
 public:
  Packet() = default;
  explicit Packet(std::vector<char> bytes) : bytes_(std::move(bytes)) {}
  const std::vector<char>& bytes() const { return bytes_; }

  /// Appends the bytes of a value.
  template <class T>
  Packet& put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const char* begin = reinterpret_cast<const char*>(&value);
    bytes_.insert(bytes_.end(), begin, begin + sizeof(T));
    return *this;
  }
  /// Appends the size of a list or text, then its values.
  template <class List>
  Packet& put_list(const List& list) {
    put(list.size());
    for (const auto& value : list) put(value);
    return *this;
  }

  /// The next value. @throws std::out_of_range if too few bytes are left
  template <class T>
  T get() {
    static_assert(std::is_trivially_copyable_v<T>);
    if (bytes_.size() - read_ < sizeof(T)) throw std::out_of_range("a packet is too short");
    T value;
    std::memcpy(&value, bytes_.data() + read_, sizeof(T));
    read_ += sizeof(T);
    return value;
  }
  /// The next list. @throws std::out_of_range if too few bytes are left
  template <class List>
  List get_list() {
    List list;
    for (auto count = get<std::size_t>(); count > 0; --count) list.push_back(get<typename List::value_type>());
    return list;
  }

 private:
  std::vector<char> bytes_;
  std::size_t read_ = 0;
};

}  // namespace gyro
