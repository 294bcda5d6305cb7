// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace gyro {

// State lies in columns: structs as Particles or Bonds are templates over the kind of column, and declare their columns
// once in for_each_column(). With buffers they own memory of an executor, with vectors they are host copies, with
// pointers they are what kernels take by value.

template <class T>
using Pointer = T*;
template <class T>
using ConstPointer = const T*;

/// Pointers to all columns of an owner.
/// @tparam View   with pointers, or const pointers, as columns
template <class View, class Owner>
View view_of(Owner& owner) {
  View view{};
  View::for_each_column([](const char*, auto& pointer, auto& column) { pointer = column.data(); }, view, owner);
  return view;
}

/// Whether for_each_column() of a view visits every column.
template <class View>
constexpr bool declares_every_column() {
  std::size_t count = 0;
  View view{};
  View::for_each_column([&count](const char*, const auto&) { ++count; }, view);
  return count * sizeof(void*) == sizeof(View);
}

}  // namespace gyro
