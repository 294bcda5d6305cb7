// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/digest.hpp"

#include <cstdio>

namespace gyro {

std::string fnv1a_128(std::string_view bytes) {
  __extension__ using Word = unsigned __int128;
  // Offset and prime of draft-eastlake-fnv.
  Word hash = (Word{0x6c62272e07bb0142u} << 64) | Word{0x62b821756295c58du};
  const Word prime = (Word{1} << 88) | Word{0x13b};
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  char digits[33];
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash >> 64),
                static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace gyro
