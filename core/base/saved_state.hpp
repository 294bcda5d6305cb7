// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/base/fields.hpp"

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gyro {

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

/// Rows of equally many numbers of one type.
struct SavedColumn {
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::int32_t>,
               std::vector<std::uint32_t>, std::vector<std::uint8_t>>
      numbers;
  std::size_t width = 1;  ///< numbers in a row
};

/// The state of a run as named columns of numbers, enough to continue it bit for bit. Owners of state put it in and
/// get it back; file writers see numbers only. Names are paths, as "particles/position/radius".
///
/// A struct that declares its fields is saved field by field: each becomes a column `name/field`, of one row for a
/// single struct and of as many rows as a vector of structs has.
class SavedState {
 public:
  /// Keeps the bits of all rows.
  template <class T>
  void put(const std::string& name, const std::vector<T>& rows) {
    if constexpr (HasFields<T>)
      put_each_field(name, rows);
    else
      put_numbers(name, rows.data(), rows.size());
  }
  /// One row, or one struct, whose fields may be vectors.
  template <class T>
  void put_one(const std::string& name, const T& row) {
    if constexpr (HasFields<T>) {
      static_assert(declares_every_field<T>, "for_each_field() must visit every member");
      T::for_each_field(
          [&]<class Field>(const char* field_name, const Field& field) {
            if constexpr (is_vector<Field>)
              put(name + "/" + field_name, field);
            else
              put_one(name + "/" + field_name, field);
          },
          row);
    } else {
      put_numbers(name, &row, 1);
    }
  }

  /// @throws BadInput when there is no such column, or one of other rows
  template <class T>
  std::vector<T> get(const std::string& name) const {
    if constexpr (HasFields<T>)
      return get_each_field<T>(name);
    else
      return get_numbers<T>(name);
  }
  /// Rows of a column that must be as long as others. @throws BadInput as get, or for another number of rows
  template <class T>
  std::vector<T> get(const std::string& name, std::size_t rows) const {
    std::vector<T> found = get<T>(name);
    if (found.size() != rows)
      throw BadInput("has " + std::to_string(found.size()) + " rows of " + name + " where " + std::to_string(rows) +
                     " are needed");
    return found;
  }
  template <class T>
  T get_one(const std::string& name) const {
    if constexpr (HasFields<T>) {
      T row{};
      T::for_each_field(
          [&]<class Field>(const char* field_name, Field& field) {
            if constexpr (is_vector<Field>)
              field = get<typename Field::value_type>(name + "/" + field_name);
            else
              field = get_one<Field>(name + "/" + field_name);
          },
          row);
      return row;
    } else {
      return get<T>(name, 1).front();
    }
  }

  /// Other names of put_one() and get_one() for a struct.
  template <HasFields T>
  void put_fields(const std::string& group, const T& fields) {
    put_one(group, fields);
  }
  template <HasFields T>
  T get_fields(const std::string& group) const {
    return get_one<T>(group);
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

  template <class T>
  void put_numbers(const std::string& name, const T* rows, std::size_t count) {
    using Number = typename RowOf<T>::Number;
    static_assert(std::is_arithmetic_v<Number>, "give the type for_each_field(), or say in RowOf what it is made of");
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(Number) == 0);
    std::vector<Number> numbers(count * width_of<T>());
    if (count > 0) std::memcpy(numbers.data(), static_cast<const void*>(rows), count * sizeof(T));
    columns_[name] = {std::move(numbers), width_of<T>()};
  }
  template <class T>
  std::vector<T> get_numbers(const std::string& name) const {
    using Number = typename RowOf<T>::Number;
    const auto found = columns_.find(name);
    const auto* numbers = found != columns_.end() ? std::get_if<std::vector<Number>>(&found->second.numbers) : nullptr;
    if (numbers == nullptr || found->second.width != width_of<T>())
      throw BadInput("has no column " + name +
                     " of this form; only the state of a run in the same precision can be restored");
    std::vector<T> rows(numbers->size() / width_of<T>());
    if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), numbers->data(), rows.size() * sizeof(T));
    return rows;
  }

  /// Place of a field in its struct [bytes].
  template <class T, class Field>
  static std::ptrdiff_t offset_of(const T& object, const Field& field) {
    return reinterpret_cast<const char*>(&field) - reinterpret_cast<const char*>(&object);
  }
  template <class T>
  void put_each_field(const std::string& name, const std::vector<T>& rows) {
    static_assert(declares_every_field<T>, "for_each_field() must visit every member");
    static_assert(std::is_trivially_copyable_v<T>, "a row of a column is plain numbers");
    const T form{};
    T::for_each_field(
        [&]<class Field>(const char* field_name, const Field& field) {
          const std::ptrdiff_t offset = offset_of(form, field);
          std::vector<Field> column(rows.size());
          for (std::size_t k = 0; k < rows.size(); ++k)
            std::memcpy(static_cast<void*>(&column[k]), reinterpret_cast<const char*>(&rows[k]) + offset,
                        sizeof(Field));
          put(name + "/" + field_name, column);
        },
        form);
  }
  template <class T>
  std::vector<T> get_each_field(const std::string& name) const {
    std::vector<T> rows;
    T form{};
    bool first = true;
    T::for_each_field(
        [&]<class Field>(const char* field_name, Field& field) {
          const std::string path = name + "/" + field_name;
          const std::vector<Field> column = first ? get<Field>(path) : get<Field>(path, rows.size());
          if (std::exchange(first, false)) rows.resize(column.size());
          const std::ptrdiff_t offset = offset_of(form, field);
          for (std::size_t k = 0; k < rows.size(); ++k)
            std::memcpy(reinterpret_cast<char*>(&rows[k]) + offset, &column[k], sizeof(Field));
        },
        form);
    return rows;
  }

  std::map<std::string, SavedColumn> columns_;
};

}  // namespace gyro
