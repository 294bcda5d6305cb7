// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/checkpoint.hpp"

#include "app/assembly/bad_key.hpp"
#include "app/version.hpp"
#include "io/files/read_file.hpp"
#include "io/run/state_file.hpp"

#include <sstream>

namespace gyro {
namespace {

constexpr int min_rest = 100;  ///< minimum of time between two states in memory / time to make one

/// The first input file of the case whose content differs from that of the checkpoint.
std::string changed_input(const std::string& now, const std::string& then) {
  std::istringstream lines(now), earlier(then);
  std::string line, other;
  while (std::getline(lines, line))
    if (!std::getline(earlier, other) || line != other) return line.substr(line.find(' ') + 1);
  return {};
}

void require_same(const Case& input, const std::string& resolved, const std::filesystem::path& file) {
  if (const auto differs = difference(input.resolved, resolved))
    throw BadKey(differs->key, differs->key + " is " + differs->value + ", in " + file.string() + " " + differs->other +
                                   "; only time.duration, output.series, output.snapshots and output.checkpoints may "
                                   "change; restore the value, or start the run again with --overwrite");
}

}  // namespace

std::filesystem::path checkpoint_file(const std::filesystem::path& directory) {
  return directory / "checkpoint.h5";
}

SavedState read_checkpoint(const std::filesystem::path& directory, const Case& input) {
  const std::filesystem::path file = checkpoint_file(directory);
  SavedState state = read_state(file);
  require_same(input, state.get_text("case/resolved"), file);
  const std::string changed = changed_input(input.inputs, state.get_text("case/inputs"));
  if (!changed.empty())
    throw BadInput(changed + ": has changed since " + file.string() +
                   " was written; restore the file, or start the run again with --overwrite");
  return state;
}

void require_same_case(const std::filesystem::path& directory, const Case& input) {
  const std::filesystem::path file = directory / "case.yaml";
  if (!std::filesystem::exists(file)) return;
  const std::string resolved = read_file(file);
  if (!resolved.empty()) require_same(input, resolved, file);
}

std::string writer_of(const SavedState& checkpoint) {
  return checkpoint.get_text("case/writer");
}

std::string this_program() {
  return std::string(version::number) + " (" + version::git + ")";
}

CheckpointKeeper::CheckpointKeeper(const std::filesystem::path& directory, const Case& input)
    : file_(checkpoint_file(directory)), input_(input) {}

void CheckpointKeeper::keep(const Simulation& simulation, const RunOutput& output) {
  if (!simulation.unsaveable().empty()) return;
  const Clock::time_point before = Clock::now();
  good_ = simulation.save();
  output.save(good_);
  good_.put_text("case/resolved", input_.resolved);
  good_.put_text("case/inputs", input_.inputs);
  good_.put_text("case/writer", this_program());
  kept_ = Clock::now();
  cost_ = kept_ - before;
}

void CheckpointKeeper::keep_if_due(const Simulation& simulation, RunOutput& output) {
  const std::chrono::duration<double> since = Clock::now() - written_;
  if (input_.output.checkpoints > 0 && since.count() >= input_.output.checkpoints)
    write(simulation, output);
  else if (Clock::now() - kept_ >= min_rest * cost_)
    keep(simulation, output);
}

void CheckpointKeeper::write(const Simulation& simulation, RunOutput& output) {
  keep(simulation, output);
  write_last_good(output);
}

void CheckpointKeeper::write_last_good(RunOutput& output) {
  output.sync();
  if (good_.columns().empty()) return;  // a run whose state cannot be saved
  write_state(file_, good_);
  written_ = Clock::now();
}

}  // namespace gyro
