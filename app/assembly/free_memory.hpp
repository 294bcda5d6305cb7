// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace gyro {

/// Memory that this process can still get.
struct FreeMemory {
  double bytes;      ///< infinity if nothing is known
  std::string what;  ///< completes "0.9 of", for example "the memory that is free"
};

/// The smallest of: the free memory of the machine; what each control group of this process, from its own to the
/// root, leaves of its limit (version 2 and version 1; the file cache counts as free, since it is given back before
/// a process is killed); what the limits of address space and data (ulimit -v, -d) leave.
/// @param root  of the file system with /proc and /sys
FreeMemory free_memory(const std::filesystem::path& root = "/");

}  // namespace gyro
