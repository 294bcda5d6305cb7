// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/case.hpp"
#include "io/yaml/yaml_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// A key of the case with a value as `--set` takes it, and their places in the sweep file.
struct SweepSetting {
  std::string key;
  std::string value;  ///< YAML on one line
  Mark key_mark = {}, value_mark = {};
};

/// Alternatives of which each point of a sweep takes one: rows of settings of the same keys.
using SweepAxis = std::vector<std::vector<SweepSetting>>;

/// A seed and its place.
struct SweepSeed {
  std::uint64_t seed = 1;
  Mark mark = {};
};

/// `slurm`: what the job asks for. Empty texts are left out of the job.
struct SlurmRequest {
  std::string partition, time, account, memory;
  int cpus = 0;                      ///< of a point; 0: its threads
  int signal = 120;                  ///< before the time limit a run is told to write its checkpoint [s]
  int at_once = 0;                   ///< points that run at the same time; 0: as many as Slurm starts
  std::vector<std::string> options;  ///< further options of sbatch, each as one text
};

/// A sweep as its file describes it. README.md of this folder has the keys.
struct SweepFile {
  std::filesystem::path file;
  std::filesystem::path case_file;  ///< relative to the working directory, or absolute
  Mark case_mark = {};
  std::vector<SweepSetting> set;             ///< of all points
  std::vector<SweepAxis> axes;               ///< the points are all combinations of their rows
  std::vector<SweepSeed> seeds;              ///< of each combination; empty: the seed of the case
  std::map<std::string, std::string> names;  ///< short names of keys, for the names of points
  std::string until, max_walltime;           ///< options of the runs; empty: none
  int threads = 1;                           ///< of a run
  SlurmRequest slurm;
};

/// A sweep, or all problems of its file.
struct SweepReport {
  std::optional<SweepFile> loaded;
  std::vector<CaseProblem> problems;
};

/// Reads a sweep file. Its case and values are checked later, by check_points(). Bad input becomes a problem and is
/// never thrown.
SweepReport load_sweep(const std::filesystem::path& file);

}  // namespace gyro
