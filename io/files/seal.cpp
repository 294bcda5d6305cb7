// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/seal.hpp"

#include "core/base/errors.hpp"
#include "io/files/digest.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

namespace gyro {
namespace {

constexpr std::size_t seal_length = 32;  ///< hexadecimal digits of a Digest

}  // namespace

void seal(const std::filesystem::path& file) {
  const std::string digest = digest_of_file(file);
  std::ofstream out(file, std::ios::binary | std::ios::app);
  out << digest << std::flush;
  if (!out) throw OutputError(file.string() + ": cannot write its digest; check the free space of the disk");
}

bool is_sealed(const std::filesystem::path& file) {
  std::error_code error;
  std::uintmax_t rest = std::filesystem::file_size(file, error);
  if (error || rest < seal_length) return false;
  rest -= seal_length;
  std::ifstream in(file, std::ios::binary);
  Digest digest;
  std::vector<char> piece(1 << 20);
  while (in && rest > 0) {
    in.read(piece.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(rest, piece.size())));
    digest.update(std::span(piece.data(), static_cast<std::size_t>(in.gcount())));
    rest -= static_cast<std::uintmax_t>(in.gcount());
  }
  std::array<char, seal_length> end;
  in.read(end.data(), end.size());
  return in && std::string_view(end.data(), end.size()) == digest.hex();
}

}  // namespace gyro
