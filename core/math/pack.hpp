// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/quat.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#if defined(__AVX__)
#include <immintrin.h>
#endif

// Packs: N numbers that a CPU core works on at once, with the operators of one number, so that
// a law written for one bond serves N. GCC's and clang's vector types do the work; a processor
// with shorter registers gets several instructions for one pack. GPU code never sees a pack: a
// thread there is one lane.

namespace gyro {

/// The compiler's vector of N numbers. A struct of its own, because the attribute must see a
/// finished type.
template <class T, int N>
struct VectorOf {
  static constexpr std::size_t bytes = sizeof(T) * N;
  using type [[gnu::vector_size(bytes)]] = T;
};

/// A vector at any address, among numbers of any type. In place of std::memcpy, which GCC 12 does in halves of 16 bytes
/// through the stack: the processor then waits until they are written before it can read them as one.
template <class Vector>
struct [[gnu::packed, gnu::may_alias]] VectorAnywhere {
  Vector v;
};
/// The k-th vector of those that lie side by side from `first` on.
template <class Vector>
Vector vector_at(const void* first, int k = 0) {
  return static_cast<const VectorAnywhere<Vector>*>(first)[k].v;
}
template <class Vector>
void store_vector(void* first, int k, const Vector& v) {
  static_cast<VectorAnywhere<Vector>*>(first)[k].v = v;
}

/// Result of a comparison, one lane each: all bits set (true) or none.
template <class T, int N>
struct PackMask {
  using Int = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  using Vector = typename VectorOf<Int, N>::type;
  Vector v;

  bool operator[](int lane) const { return v[lane] != 0; }
  friend PackMask operator&(PackMask a, PackMask b) { return {a.v & b.v}; }
  friend PackMask operator|(PackMask a, PackMask b) { return {a.v | b.v}; }
  friend PackMask operator~(PackMask a) { return {~a.v}; }
};

/// N numbers of type T (float or double).
template <class T, int N>
struct Pack {
  using Vector = typename VectorOf<T, N>::type;
  using Mask = PackMask<T, N>;
  static constexpr int lanes = N;
  Vector v;

  Pack() = default;
  Pack(T s) : v(spread(s, std::make_integer_sequence<int, N>{})) {}  // NOLINT: a number is a pack of equal numbers
  explicit Pack(Vector x) : v(x) {}

  T operator[](int lane) const { return v[lane]; }
  friend Pack operator+(Pack a, Pack b) { return Pack{a.v + b.v}; }
  friend Pack operator-(Pack a, Pack b) { return Pack{a.v - b.v}; }
  friend Pack operator*(Pack a, Pack b) { return Pack{a.v * b.v}; }
  friend Pack operator/(Pack a, Pack b) { return Pack{a.v / b.v}; }
  friend Pack operator-(Pack a) { return Pack{-a.v}; }
  friend Mask operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend Mask operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend Mask operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend Mask operator>=(Pack a, Pack b) { return {a.v >= b.v}; }

 private:
  template <int... lane>
  static Vector spread(T s, std::integer_sequence<int, lane...>) {
    return Vector{((void)lane, s)...};
  }
};

/// Whether any lane of a comparison is true.
template <class Vector>
bool any_bit(const Vector& v) {
#if defined(__AVX__)
  if constexpr (sizeof v == 32) {
    const auto bits = reinterpret_cast<__m256i>(v);
    return _mm256_testz_si256(bits, bits) == 0;
  }
#endif
  std::uint64_t words[sizeof(Vector) / 8], all = 0;
  std::memcpy(words, &v, sizeof v);
  for (const std::uint64_t w : words) all |= w;
  return all != 0;
}

/// Bit k is set if lane k is true.
template <class T, int N>
std::uint32_t bits_of(const PackMask<T, N>& m) {
#if defined(__AVX512DQ__)
  if constexpr (sizeof m.v == 64 && sizeof(T) == 8) return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m.v));
#endif
#if defined(__AVX__)
  if constexpr (sizeof m.v == 32 && sizeof(T) == 8)
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m.v)));
#endif
  std::uint32_t bits = 0;
  for (int k = 0; k < N; ++k) bits |= (m[k] ? 1u : 0u) << k;
  return bits;
}

template <class T, int N>
Pack<T, N> select(PackMask<T, N> m, Pack<T, N> a, Pack<T, N> b) {
  return Pack<T, N>{m.v ? a.v : b.v};
}
/// Calls f(k) for k = 0, ..., N - 1, each a constant, so that what it indexes stays in registers.
template <int N, class F>
void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f(std::integral_constant<int, k>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// A function of each lane.
template <class T, int N, class F>
Pack<T, N> lane_by_lane(Pack<T, N> a, const F& f) {
  alignas(64) T lane[N];
  std::memcpy(lane, &a.v, sizeof lane);
  for (int k = 0; k < N; ++k) lane[k] = f(lane[k]);
  std::memcpy(&a.v, lane, sizeof lane);
  return a;
}
template <class T, int N>
Pack<T, N> sqrt(Pack<T, N> a) {
  return lane_by_lane(a, [](T x) { return std::sqrt(x); });
}
template <class T, int N>
Pack<T, N> floor(Pack<T, N> a) {
  return lane_by_lane(a, [](T x) { return std::floor(x); });
}

/// A vector in another number type. GCC 12 makes three instructions more of __builtin_convertvector where numbers
/// become wider, and the one that it should be of numbers that are converted one by one.
template <class To, class Vector, int... lane>
typename VectorOf<To, sizeof...(lane)>::type vector_cast(const Vector& a, std::integer_sequence<int, lane...>) {
  return typename VectorOf<To, sizeof...(lane)>::type{static_cast<To>(a[lane])...};
}
template <class To, class From, int N>
Pack<To, N> pack_cast(Pack<From, N> a) {
  if constexpr (sizeof(To) > sizeof(From))
    return Pack<To, N>{vector_cast<To>(a.v, std::make_integer_sequence<int, N>{})};
  else
    return Pack<To, N>{__builtin_convertvector(a.v, typename Pack<To, N>::Vector)};
}

/// The same by the name that serves single numbers and packs.
template <class To, class From, int N>
Pack<To, N> lane_cast(Pack<From, N> a) {
  return pack_cast<To>(a);
}

/// Two packs side by side.
template <class T>
Pack<T, 8> joined(const Pack<T, 4>& a, const Pack<T, 4>& b) {
  return Pack<T, 8>{__builtin_shufflevector(a.v, b.v, 0, 1, 2, 3, 4, 5, 6, 7)};
}

/// Number type of one lane.
template <class T>
struct LaneOf {
  using type = T;
};
template <class T, int N>
struct LaneOf<Pack<T, N>> {
  using type = T;
};

}  // namespace gyro
