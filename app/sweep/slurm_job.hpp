// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/checked_points.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gyro {

/// Largest number of tasks of a job array: Slurm's default MaxArraySize is 1001.
constexpr std::size_t max_tasks = 1000;

/// The text of a batch script: a job array with one task for each of the points. A task that reaches its time limit
/// gets SIGUSR1 some time before, passes it on to the run, which writes its checkpoint and ends with 75, and is put
/// into the queue again. It is not when the run has got no further than its last checkpoint.
/// @param program  this program
/// @param directory  of the sweep
/// Both must be absolute.
std::string slurm_script(const std::filesystem::path& program, const std::filesystem::path& directory,
                         const CheckedSweep& sweep, const std::vector<const CheckedPoint*>& points);

}  // namespace gyro
