// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace gyro {

template <class T>
struct MadeOf {
  using Number = T;
};
/// The number type that a row of a column is made of, and of nothing else. A number is a row of one; a struct
/// says its own: `template <> struct RowOf<Sphere> : MadeOf<double> {};`
template <class T>
struct RowOf : MadeOf<T> {};

/// Rows of equally many numbers of one type.
struct SavedColumn {
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::int32_t>,
               std::vector<std::uint32_t>, std::vector<std::uint8_t>>
      numbers;
  std::size_t width = 1;  ///< numbers in a row
};

/// What must be kept to go on bit for bit, as named columns of numbers: whoever has a state puts it in and
/// gets it back, whoever writes files sees numbers only. Names are paths, as "particles/position".
class SavedState {
 public:
  /// Keeps the bits of all rows.
  template <class T>
  void put(const std::string& name, const std::vector<T>& rows) {
    using Number = typename RowOf<T>::Number;
    static_assert(std::is_arithmetic_v<Number>, "RowOf must say which numbers a row of this type is made of");
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(Number) == 0);
    std::vector<Number> numbers(rows.size() * width_of<T>());
    if (!rows.empty()) std::memcpy(numbers.data(), static_cast<const void*>(rows.data()), rows.size() * sizeof(T));
    columns_[name] = {std::move(numbers), width_of<T>()};
  }
  template <class T>
  void put_one(const std::string& name, const T& row) {
    put(name, std::vector<T>{row});
  }

  /// @throws BadInput when there is no such column, or one of other rows
  template <class T>
  std::vector<T> get(const std::string& name) const {
    using Number = typename RowOf<T>::Number;
    const auto found = columns_.find(name);
    const auto* numbers = found != columns_.end() ? std::get_if<std::vector<Number>>(&found->second.numbers) : nullptr;
    if (numbers == nullptr || found->second.width != width_of<T>())
      throw BadInput("has no " + name + " of this form; the state of a run in the same precision is accepted");
    std::vector<T> rows(numbers->size() / width_of<T>());
    if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), numbers->data(), rows.size() * sizeof(T));
    return rows;
  }
  /// Rows of a column that must be as long as others. @throws BadInput as get, or for another number of rows
  template <class T>
  std::vector<T> get(const std::string& name, std::size_t rows) const {
    std::vector<T> found = get<T>(name);
    if (found.size() != rows)
      throw BadInput("has " + std::to_string(found.size()) + " rows of " + name + "; " + std::to_string(rows) +
                     " are accepted");
    return found;
  }
  template <class T>
  T get_one(const std::string& name) const {
    return get<T>(name, 1).front();
  }

  /// A struct field by field, numbers and vectors: Fields::for_each_field(f, fields) calls f(name, field) for
  /// each. Fields become columns of the group.
  template <class Fields>
  void put_fields(const std::string& group, const Fields& fields) {
    Fields::for_each_field(
        [&]<class T>(const char* name, const T& field) {
          if constexpr (std::is_arithmetic_v<T>)
            put_one(group + "/" + name, field);
          else
            put(group + "/" + name, field);
        },
        fields);
  }
  template <class Fields>
  Fields get_fields(const std::string& group) const {
    Fields fields;
    Fields::for_each_field(
        [&]<class T>(const char* name, T& field) {
          if constexpr (std::is_arithmetic_v<T>)
            field = get_one<T>(group + "/" + name);
          else
            field = get<typename T::value_type>(group + "/" + name);
        },
        fields);
    return fields;
  }

  void put_text(const std::string& name, const std::string& text) {
    put(name, std::vector<std::uint8_t>(text.begin(), text.end()));
  }
  std::string get_text(const std::string& name) const {
    const std::vector<std::uint8_t> text = get<std::uint8_t>(name);
    return {text.begin(), text.end()};
  }

  std::map<std::string, SavedColumn>& columns() { return columns_; }
  const std::map<std::string, SavedColumn>& columns() const { return columns_; }

 private:
  template <class T>
  static constexpr std::size_t width_of() {
    return sizeof(T) / sizeof(typename RowOf<T>::Number);
  }

  std::map<std::string, SavedColumn> columns_;
};

}  // namespace gyro
