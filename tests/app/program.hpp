// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/io/run/scratch.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gyro {

/// Result of a call of the program.
struct Outcome {
  int code;              ///< exit code; -1 if a signal ended it
  std::string out, err;  ///< standard output and error
};

/// An empty working directory in which the program is called. Its cache and output are stored outside of it.
class Workplace {
 public:
  /// Runs `gyrosim ARGUMENTS` by the shell. One thread unless the arguments say otherwise.
  Outcome gyrosim(const std::string& arguments) const;
  /// The same, with a signal a few seconds after the start.
  Outcome gyrosim_with_signal(const std::string& arguments, const std::string& signal, double seconds) const;

  /// The same, with a limit on the size of files [bytes, approximately].
  Outcome gyrosim_with_file_limit(const std::string& arguments, std::size_t bytes) const;

  /// Runs a line of the shell, in which $GYROSIM is the program, with one thread and the cache of this place.
  Outcome shell(const std::string& line) const;

  std::filesystem::path path() const { return work_.path(); }
  void write(const std::string& name, const std::string& text) const;
  /// Files and folders below, in order.
  std::vector<std::string> listing() const;

 private:
  Outcome call(const std::string& command) const;

  ScratchDirectory work_, notes_;
};

/// Whole text of a file; empty if there is none.
std::string read_text(const std::filesystem::path& file);

/// summary.json of a run.
nlohmann::json summary_of(const std::filesystem::path& run);

/// A dataset of results.h5 of a run, as "series/time".
std::vector<double> result_of(const std::filesystem::path& run, const std::string& dataset);

/// Every number of results.h5 of a run that two equal runs share, by name in order.
std::vector<std::pair<std::string, std::vector<double>>> all_results(const std::filesystem::path& run);

/// Names of datasets of a group of results.h5, in order; none if there is no such group.
std::vector<std::string> results_in(const std::filesystem::path& run, const std::string& group);

}  // namespace gyro
