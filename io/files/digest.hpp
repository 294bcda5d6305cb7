// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace gyro {

/// The 128-bit XXH3 hash of bytes that are passed in pieces. It identifies files and texts, and detects accidental
/// damage. It does not protect from a file that was made deliberately to have the digest of another.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;
  void update(std::span<const char> bytes);
  /// Digest of all bytes so far, as 32 hexadecimal digits.
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string digest_of(std::string_view bytes);

/// Digest of the content of a file. @throws BadInput, with the path, if the file cannot be read to its end
std::string digest_of_file(const std::filesystem::path& file);

}  // namespace gyro
