// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/run_ensemble.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gyro::bench {

/// The reference runs of a scene, kept as data.
struct Reference {
  using Table = std::map<std::string, std::vector<double>>;  ///< values by metric, by seed

  Table fine;    ///< a sixteenth of the default step
  Table coarse;  ///< an eighth, up to the first break; until then the difference bounds the error of `fine`
  int seeds = 0;
  double time_step = 0;  ///< of `fine` [s]
  double cpu_per_simulated_second = 0;
  std::string fingerprint, git, command;
};

/// Runs the reference of a scene.
Reference make_reference(const AccuracyScene& scene, const std::filesystem::path& folder, int threads);

/// Writes a scene's reference into the file and keeps those of other scenes. @throws OutputError
void write_reference(const std::filesystem::path& file, const std::string& scene, const Reference& reference);

/// Whether the file has a reference of a scene. @throws BadInput if the file is not JSON
bool has_reference(const std::filesystem::path& file, const std::string& scene);

/// Reference of a scene, if it was made with the present files of the scene.
/// @throws BadInput if there is none, or it was made with other files
Reference read_reference(const std::filesystem::path& file, const AccuracyScene& scene,
                         const std::filesystem::path& folder);

}  // namespace gyro::bench
