// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/tables/form.hpp"
#include "core/math/vec3.hpp"
#include "io/run/channel.hpp"
#include "io/run/text.hpp"

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace gyro {

/// The form of a column, by the type that its function returns.
enum class Shape {
  number,   ///< a number; integers, and optional numbers (none: NaN)
  vector,   ///< Vec3d
  vectors,  ///< span of Vec3d: a dataset of three columns for each name of the column's Repeat
  array     ///< span of double: one number for each cell, sieve, ...
};

namespace column_detail {

constexpr Shape shape(double) {
  return Shape::number;
}
constexpr Shape shape(std::int64_t) {
  return Shape::number;
}
constexpr Shape shape(const std::optional<double>&) {
  return Shape::number;
}
constexpr Shape shape(const Vec3d&) {
  return Shape::vector;
}
constexpr Shape shape(std::span<const Vec3d>) {
  return Shape::vectors;
}
constexpr Shape shape(std::span<const double>) {
  return Shape::array;
}

inline void put(std::vector<double>& row, double v) {
  row.push_back(v);
}
inline void put(std::vector<double>& row, std::int64_t v) {
  row.push_back(static_cast<double>(v));
}
inline void put(std::vector<double>& row, const std::optional<double>& v) {
  row.push_back(v.value_or(std::numeric_limits<double>::quiet_NaN()));
}
inline void put(std::vector<double>& row, const Vec3d& v) {
  row.insert(row.end(), {v.x, v.y, v.z});
}
inline void put(std::vector<double>& row, std::span<const Vec3d> all) {
  for (const Vec3d& v : all) put(row, v);
}
inline void put(std::vector<double>& row, std::span<const double> all) {
  row.insert(row.end(), all.begin(), all.end());
}

}  // namespace column_detail

/// In place of a reading of windows, for tables without means over windows.
struct NoWindow {
  double length = 0;
};

/// The function of a column: a lambda without captures. What it reads decides what the column is: a function of `Now`
/// is evaluated at the end of the row, a function of `Window` in every coupling window and averaged over the row.
template <class Now, class Window>
class Value {
 public:
  template <class F>
  requires std::is_empty_v<F> && std::invocable<F, const Now&>
  constexpr Value(F)
      : shape_(column_detail::shape(std::remove_cvref_t<std::invoke_result_t<F, const Now&>>{})),
        now_([](const Now& reading, std::vector<double>& row) { column_detail::put(row, F{}(reading)); }) {}
  template <class F>
  requires std::is_empty_v<F> && std::invocable<F, const Window&>
  constexpr Value(F)
      : shape_(column_detail::shape(std::remove_cvref_t<std::invoke_result_t<F, const Window&>>{})),
        window_([](const Window& reading, std::vector<double>& row) { column_detail::put(row, F{}(reading)); }) {}

  Shape shape() const { return shape_; }
  bool is_mean() const { return window_ != nullptr; }
  void put(const Now& reading, std::vector<double>& row) const { now_(reading, row); }
  void put(const Window& reading, std::vector<double>& row) const { window_(reading, row); }

 private:
  Shape shape_;
  void (*now_)(const Now&, std::vector<double>&) = nullptr;
  void (*window_)(const Window&, std::vector<double>&) = nullptr;
};

/// Makes a dataset for each of several names.
struct Repeat {
  const char* placeholder;                      ///< in the column's name and description, as "<wall>"
  std::vector<std::string> OutputForm::*names;  ///< what replaces it
};

/// A column of a table of results.h5: the description of a dataset, and the function that computes its numbers.
template <class Now, class Window = NoWindow>
struct Column {
  Text name;
  Text units;  ///< as in "rad/s"; "1" for a pure number
  Value<Now, Window> value;
  Text description;                      ///< one line
  Presence presence = always;            ///< in addition to the presence of the table
  Sampling sampled = Sampling::instant;  ///< of a function of `Now`; one of `Window` gives means
  hdf5::Number number = hdf5::Number::float64;
  const char* array = "";             ///< what each number of an array belongs to, such as "sieve"
  std::optional<Repeat> repeat = {};  ///< of Shape::vectors

  Sampling sampling() const { return value.is_mean() ? Sampling::mean : sampled; }
};

/// A group of results.h5: its columns in the order of its rows.
template <class Now, class Window = NoWindow>
struct Table {
  Text group;  ///< as "/series"; "<wall>" stands for the names of walls
  Text rows;   ///< what a row stands for
  Presence presence;
  std::vector<Column<Now, Window>> columns;
};

/// Replaces the placeholder in a path by a name: "/liners/<wall>" and "mantle" give "/liners/mantle".
inline std::string fill_in(std::string text, const std::string& placeholder, const std::string& name) {
  if (const std::size_t at = text.find(placeholder); at != std::string::npos)
    text.replace(at, placeholder.size(), name);
  return text;
}

/// Datasets of a column in a run. @param array  numbers of its array, if it is one
template <class Now, class Window>
std::vector<Channel> channels_of(const Column<Now, Window>& column, const OutputForm& form, std::size_t array) {
  const Shape shape = column.value.shape();
  const std::size_t width = shape == Shape::number ? 1 : shape == Shape::array ? array : 3;
  const Channel one{std::string(column.name), std::string(column.units),      static_cast<int>(width), column.number,
                    column.sampling(),        std::string(column.description)};
  if (!column.repeat) return {one};
  std::vector<Channel> all;
  for (const std::string& name : form.*(column.repeat->names)) {
    all.push_back(one);
    all.back().name = fill_in(one.name, column.repeat->placeholder, name);
    all.back().description = fill_in(one.description, column.repeat->placeholder, name);
  }
  return all;
}

}  // namespace gyro
