// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// Marks a function that runs on the host and on the device. Only this file asks which
// compiler is at work.
#if defined(__CUDACC__)
#define GYRO_HD __host__ __device__
#else
#define GYRO_HD
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
