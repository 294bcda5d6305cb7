// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace gyro {

/// XXH3 of 128 bits over bytes that come in pieces: tells files and texts apart, and finds what was damaged. It
/// protects from accidents, not from somebody who makes a file with the digest of another.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;
  void update(std::span<const char> bytes);
  /// Of all bytes so far, as 32 hexadecimal digits.
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string digest_of(std::string_view bytes);

/// Of the content of a file. @throws BadInput, with the path, when it cannot be read to its end
std::string digest_of_file(const std::filesystem::path& file);

}  // namespace gyro
