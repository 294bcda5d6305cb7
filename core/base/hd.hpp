// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// GYRO_HD marks a function that runs on the host and on the device. GYRO_ANY_CALLEE before a template of that kind lets
// it call a functor of the host where only host code calls the template. On the host, GYRO_FLATTEN compiles all that a
// function calls into it, so that packs stay in registers; GYRO_APART keeps a function out of its callers, GYRO_COLD
// one that is rarely called. The only place in the project that asks which compiler is at work.
#if defined(__CUDACC__)
#define GYRO_HD __host__ __device__
#define GYRO_ANY_CALLEE _Pragma("nv_exec_check_disable")
#define GYRO_FLATTEN
#define GYRO_APART
#define GYRO_COLD
#else
#define GYRO_HD
#define GYRO_ANY_CALLEE
#define GYRO_FLATTEN [[gnu::flatten]]
#define GYRO_APART [[gnu::noinline]]
#define GYRO_COLD [[gnu::noinline, gnu::cold]]
#endif

namespace gyro {

/// Index of a particle, bond, contact or wall in its array. Signed, so that loops and
/// differences are safe; 2^31 particles are beyond the memory of one device.
using Index = std::int32_t;

/// Number that a particle keeps for life, whatever its row in the columns. Given in feed order.
using ParticleId = std::uint32_t;

/// Number that a rock (meta-particle as fed) keeps for life; its fragments keep it too.
using RockId = std::int32_t;

/// "No such thing" for every signed index and number above.
inline constexpr Index none = -1;

}  // namespace gyro
