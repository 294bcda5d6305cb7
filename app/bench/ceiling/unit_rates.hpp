// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro::bench {

/// Time that a core takes for one operation on one number, when independent operations on packs keep its units busy
/// [ns].
struct OperationTimes {
  double add, multiply;
  double pair;  ///< an addition and a multiplication, which some processors do in different units
  double divide, root;
};

/// Bytes of a vector register.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

/// Measures them once, for some milliseconds. Operands lie in registers; no multiplication is joined with an addition.
/// @tparam T  float or double
/// @tparam N  numbers of a pack
template <class T, int N>
OperationTimes measured_times();

}  // namespace gyro::bench
