// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// Four random words.
struct Random4 {
  std::uint32_t v[4];
};

/// Philox4x32-10: a random function of (key, counter), no state, no order of draws.
/// Salmon, Moraes, Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11.
GYRO_HD inline Random4 philox(std::uint32_t k0, std::uint32_t k1, Random4 c) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = std::uint64_t{0xD2511F53u} * c.v[0];
    const std::uint64_t p1 = std::uint64_t{0xCD9E8D57u} * c.v[2];
    c = {{static_cast<std::uint32_t>(p1 >> 32) ^ c.v[1] ^ k0, static_cast<std::uint32_t>(p1),
          static_cast<std::uint32_t>(p0 >> 32) ^ c.v[3] ^ k1, static_cast<std::uint32_t>(p0)}};
    k0 += 0x9E3779B9u;
    k1 += 0xBB67AE85u;
  }
  return c;
}

/// What a draw is for: keeps the streams of one seed apart.
enum class Stream : std::uint32_t { shape = 1, fill = 2, size = 3, place = 4, turn = 5, strength = 6 };

/// Uniform number in (0, 1), a pure function of its arguments, with 52 random bits.
/// @param thing, draw  what is drawn for (a rock, a bond) and the how-many-th draw for it
GYRO_HD inline double uniform(std::uint64_t seed, Stream stream, std::uint64_t thing, std::uint32_t draw) {
  const Random4 counter{{static_cast<std::uint32_t>(thing), static_cast<std::uint32_t>(thing >> 32), draw,
                         static_cast<std::uint32_t>(stream)}};
  const Random4 r = philox(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), counter);
  const std::uint64_t bits = (std::uint64_t{r.v[0]} << 20) | (r.v[1] >> 12);
  return (static_cast<double>(bits) + 0.5) * (1.0 / 4503599627370496.0);  // 2^-52
}

}  // namespace gyro
