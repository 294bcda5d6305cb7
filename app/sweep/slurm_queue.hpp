// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/point_state.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace gyro {

/// A task of a job that an earlier call has submitted.
struct SlurmTask {
  std::string id;  ///< "JOB_TASK"
  std::string point;
};

/// The tasks in the file of submitted jobs, DIRECTORY/slurm-jobs.csv.
std::vector<SlurmTask> submitted_tasks(const std::filesystem::path& directory);

/// Points that have a task in the queue or running, of those that earlier calls have submitted.
/// @throws NoDevice if `squeue` cannot be asked
std::set<std::string> points_in_queue(const std::filesystem::path& directory);

/// Submits DIRECTORY/job.sh and notes its tasks. @returns the number of the job
/// @throws NoDevice if `sbatch` is not installed or refuses the job, with its message
std::string submit(const std::filesystem::path& directory, const std::vector<const CheckedPoint*>& points);

/// Number of a job in the output of `sbatch --parsable`, which is "NUMBER" or "NUMBER;CLUSTER"; empty for another text.
std::string job_number(const std::string& output);

}  // namespace gyro
