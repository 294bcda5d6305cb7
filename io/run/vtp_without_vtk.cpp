// SPDX-License-Identifier: GPL-3.0-or-later
// Writes snapshots in a program that was built without VTK's library.
#include "io/run/poly_data.hpp"

namespace gyro {

void write_vtp(const std::filesystem::path& path, const PolyData& data) {
  write_vtp_plain(path, data);
}

}  // namespace gyro
