// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

// The fields of a struct, declared once beside them:
//
//   struct Breakage {
//     double time;
//     Vec3d position;
//
//     template <class F, class... B>
//     static constexpr void for_each_field(F&& f, B&... b) {
//       f("time", b.time...);
//       f("position", b.position...);
//     }
//   };
//   static_assert(declares_every_field<Breakage>);
//
// f gets the field of every object given, so that objects can be compared or copied field by field.

namespace gyro {

namespace fields_detail {

struct IgnoreField {
  template <class... Field>
  constexpr void operator()(const char*, Field&...) const {}
};

struct CountField {
  std::size_t* count;
  template <class... Field>
  constexpr void operator()(const char*, Field&...) const {
    ++*count;
  }
};

/// Stands for a value of any member's type.
struct AnyValue {
  template <class T>
  operator T() const;
};

/// Largest number of values that an aggregate can be made of.
template <class T, class... Values>
constexpr std::size_t member_count() {
  if constexpr (requires { T{std::declval<Values>()..., std::declval<AnyValue>()}; })
    return member_count<T, Values..., AnyValue>();
  else
    return sizeof...(Values);
}

/// Room for a T that is never made: its fields are named, not read.
template <class T>
union Unmade {
  char nothing = 0;
  T object;
  constexpr Unmade() {}
  constexpr ~Unmade() {}
};
template <class T>
inline Unmade<T> unmade;

template <class T>
constexpr std::size_t field_count() {
  std::size_t count = 0;
  T::for_each_field(CountField{&count}, unmade<T>.object);
  return count;
}

}  // namespace fields_detail

template <class T>
struct MadeOf {
  using Number = T;
};
/// The number type that a row of a column is made of. A number is a row of one; a type of several equal numbers
/// says which: `template <class T> struct RowOf<Vec3<T>> : MadeOf<T> {};`. A struct of different things
/// declares its fields instead.
template <class T>
struct RowOf : MadeOf<T> {};
template <class T>
requires std::is_enum_v<T>
struct RowOf<T> : MadeOf<std::underlying_type_t<T>> {
};

/// Whether T declares its fields.
template <class T>
concept HasFields = requires(T& object) {
  T::for_each_field(fields_detail::IgnoreField{}, object);
};

/// Whether for_each_field() visits as many fields as the struct has members. T is an aggregate without C arrays.
template <HasFields T>
inline constexpr bool declares_every_field = fields_detail::field_count<T>() == fields_detail::member_count<T>();

}  // namespace gyro
