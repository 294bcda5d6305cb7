// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

// The only things that threads of one kernel may do to the same memory: raise a flag, look at it, and take a
// number. Both are whole numbers, so results never depend on who came first once they are sorted.

namespace gyro {

/// Sets a flag that any number of threads may set.
GYRO_HD inline void raise_flag(std::int32_t* flag) {
#if defined(__CUDA_ARCH__)
  atomicExch(flag, 1);
#else
  __atomic_store_n(flag, 1, __ATOMIC_RELAXED);
#endif
}

/// Whether a flag is up that other threads may raise meanwhile.
GYRO_HD inline bool is_raised(const std::int32_t* flag) {
#if defined(__CUDA_ARCH__)
  return *static_cast<const volatile std::int32_t*>(flag) != 0;
#else
  return __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
#endif
}

/// Adds one to a counter. @return its value before
GYRO_HD inline std::int32_t take_number(std::int32_t* counter) {
#if defined(__CUDA_ARCH__)
  return atomicAdd(counter, 1);
#else
  return __atomic_fetch_add(counter, 1, __ATOMIC_RELAXED);
#endif
}

}  // namespace gyro
