// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/files/digest.hpp"
#include "io/hdf5/hdf5.hpp"

#include <span>
#include <string>

namespace gyro {

/// Digest of the numbers of a dataset, kept up while rows are added: a row costs the same however many there are.
/// Numbers are rounded to the type of the file first, so that what is read back has the same digest.
class RowsDigest {
 public:
  explicit RowsDigest(hdf5::Number number) : number_(number) {}
  void add(std::span<const double> numbers);
  /// Of all numbers so far, as 32 hexadecimal digits.
  std::string hex() const { return digest_.hex(); }

 private:
  hdf5::Number number_;  ///< how the numbers lie in the file
  Digest digest_;
};

}  // namespace gyro
