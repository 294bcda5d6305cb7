// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/bond_lane.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <type_traits>
#include <vector>

// A number that has no value but knows how it was computed. A kernel that runs on such numbers shows which operations
// its results need: an expression that stands in the text twice is one, and one that no result needs is none, as in
// what a compiler makes of the text.

namespace gyro::bench {

enum class Operation : std::uint8_t {
  input,
  add,
  subtract,
  multiply,
  divide,
  root,
  negate,
  compare,
  combine,
  choose,
  convert
};

/// Operations of one precision.
struct OperationCounts {
  int add = 0;  ///< and subtract
  int multiply = 0, divide = 0, root = 0;
};

/// The expressions that a kernel made of its inputs, each once.
class Expressions {
 public:
  /// What was read from memory.
  /// @param part  of what lies at the address
  int input(const void* address, int part) {
    return find({Operation::input, true, part, address, 0, no_operands}, false);
  }
  /// The same number for all bonds.
  int constant(double value, bool is_double) {
    return find({Operation::input, is_double, -1, nullptr, value, no_operands}, true);
  }
  /// @param operands  -1: none
  int expression(Operation operation, bool is_double, std::array<int, 3> operands);

  /// A number or a condition that the kernel stores or decides by.
  void need(int expression) { needed_.push_back(expression); }

  /// Operations that the needed expressions take, but for those of constants alone, which can be done once for all
  /// bonds.
  OperationCounts counts(bool is_double) const;

 private:
  static constexpr std::array<int, 3> no_operands{-1, -1, -1};
  struct Node {
    Operation operation;
    bool is_double;
    int part;
    const void* address;
    double value;
    std::array<int, 3> operands;
    auto operator<=>(const Node&) const = default;
  };
  int find(const Node& node, bool constant);

  std::map<Node, int> numbers_;
  std::vector<Node> nodes_;
  std::vector<bool> constant_;
  std::vector<int> needed_;
};

/// The expressions to which traced numbers belong: one recording at a time.
inline Expressions* recorded = nullptr;

/// A comparison of traced numbers.
struct TracedCondition {
  int expression;

  friend TracedCondition operator&(TracedCondition a, TracedCondition b) { return combined(a, b); }
  friend TracedCondition operator|(TracedCondition a, TracedCondition b) { return combined(a, b); }

 private:
  static TracedCondition combined(TracedCondition a, TracedCondition b) {
    return {recorded->expression(Operation::combine, false, {a.expression, b.expression, -1})};
  }
};

/// @tparam T  float or double
template <class T>
struct Traced {
  static constexpr bool is_double = std::is_same_v<T, double>;
  int expression;

  Traced() = default;
  Traced(T value) : expression(recorded->constant(static_cast<double>(value), is_double)) {}  // NOLINT: as of a Pack
  static Traced of(int expression) {
    Traced t;
    t.expression = expression;
    return t;
  }
  static Traced of(Operation operation, Traced a, Traced b) {
    return of(recorded->expression(operation, is_double, {a.expression, b.expression, -1}));
  }
  static Traced of(Operation operation, Traced a) {
    return of(recorded->expression(operation, is_double, {a.expression, -1, -1}));
  }

  friend Traced operator+(Traced a, Traced b) { return of(Operation::add, a, b); }
  friend Traced operator-(Traced a, Traced b) { return of(Operation::subtract, a, b); }
  friend Traced operator*(Traced a, Traced b) { return of(Operation::multiply, a, b); }
  friend Traced operator/(Traced a, Traced b) { return of(Operation::divide, a, b); }
  friend Traced operator-(Traced a) { return of(Operation::negate, a); }
  friend Traced sqrt(Traced a) { return of(Operation::root, a); }
  friend TracedCondition operator<(Traced a, Traced b) { return compared(a, b); }
  friend TracedCondition operator>(Traced a, Traced b) { return compared(b, a); }
  friend TracedCondition operator>=(Traced a, Traced b) { return compared(a, b); }

 private:
  static TracedCondition compared(Traced a, Traced b) {
    return {recorded->expression(Operation::compare, false, {a.expression, b.expression, -1})};
  }
};

template <class T>
Traced<T> select(TracedCondition choose, Traced<T> a, Traced<T> b) {
  return Traced<T>::of(
      recorded->expression(Operation::choose, Traced<T>::is_double, {choose.expression, a.expression, b.expression}));
}
template <class To, class From>
Traced<To> lane_cast(Traced<From> a) {
  if constexpr (std::is_same_v<To, From>)
    return a;
  else
    return Traced<To>::of(recorded->expression(Operation::convert, Traced<To>::is_double, {a.expression, -1, -1}));
}

/// One intact bond of traced numbers, as lanes of BondForces: nothing fails.
struct TracedLane {
  template <class T>
  using Number = Traced<T>;
  static constexpr int count = 1;
  static constexpr bool in_halves = false;

  /// Indices and states are what they are.
  template <class T>
  auto load(const T* column) const {
    if constexpr (std::is_integral_v<T>)
      return *column;
    else
      return Traced<T>::of(recorded->input(column, 0));
  }
  template <class To, class T>
  Traced<To> load_as(const T* column) const {
    return lane_cast<To>(load(column));
  }
  template <class T, class Row>
  Vec3<Traced<T>> vector(const Row* rows, Index row) const {
    return lane_cast<T>(vector_of(rows + row));
  }
  template <class T, class Row>
  Vec3<Traced<T>> difference(const Row* rows, Index a, Index b) const {
    return lane_cast<T>(vector_of(rows + a) - vector_of(rows + b));
  }
  Quat<Traced<double>> quaternion(const Quatd* rows, Index row) const {
    const Vec3<Traced<double>> v = vector_of(rows + row);
    return {Traced<double>::of(recorded->input(rows + row, 3)), v.x, v.y, v.z};
  }
  template <class Real>
  BondConstants<Traced<Real>> spread(const BondConstants<Real>& law) const {
    return gyro::cast<Traced<Real>>(law);
  }

  template <class Real>
  TracedCondition is_intact(const std::int32_t&) const {
    return {recorded->input(this, 0)};
  }
  bool any_unbroken(std::int32_t) const { return true; }
  bool any_pressed(std::int32_t) const { return false; }
  bool any(TracedCondition condition) const {
    recorded->need(condition.expression);
    return false;
  }
  bool test(TracedCondition, int) const { return false; }
  Index index(int) const { return 0; }
  std::int32_t value(std::int32_t number, int) const { return number; }
  template <class T>
  T value(Traced<T>, int) const {
    return 0;
  }

  template <class Real>
  void add(Load*, Index, Index, std::int32_t, const BondLoad<Traced<Real>>& load, Traced<Real>) const {
    for (const Vec3<Traced<Real>>& v : {load.force, load.torque_i, load.torque_j})
      for (const Traced<Real> number : {v.x, v.y, v.z}) recorded->need(number.expression);
    recorded->need(load.damped.expression);
  }

 private:
  static Vec3<Traced<double>> vector_of(const void* row) {
    const auto part = [&](int k) { return Traced<double>::of(recorded->input(row, k)); };
    return {part(0), part(1), part(2)};
  }
};

}  // namespace gyro::bench
