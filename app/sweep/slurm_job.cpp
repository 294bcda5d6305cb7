// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/slurm_job.hpp"

#include "app/sweep/local_engine.hpp"
#include "app/sweep/shell_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace gyro {
namespace {

namespace fs = std::filesystem;

std::string option(const std::string& text) {
  return "#SBATCH " + text + "\n";
}

std::string option(const char* name, const std::string& value) {
  return value.empty() ? "" : option(std::string("--") + name + "=" + value);
}

/// A path as a file name pattern of sbatch, in which % begins a number to fill in.
std::string pattern(std::string path) {
  for (std::size_t at = 0; (at = path.find('%', at)) != std::string::npos; at += 2) path.insert(at, 1, '%');
  return path;
}

/// Name of the job: without characters that could end the line or an option.
std::string job_name(const fs::path& sweep) {
  std::string name = sweep.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !(std::isalnum(c) || c == '-' || c == '_'); }, '-');
  return name;
}

std::string options_of(const fs::path& directory, const CheckedSweep& sweep, std::size_t points) {
  const SlurmRequest& request = sweep.file.slurm;
  const std::string limit = request.at_once > 0 ? "%" + std::to_string(request.at_once) : "";
  std::string text = option("job-name", job_name(sweep.file.file)) +
                     option("array", "1-" + std::to_string(points) + limit) + option("nodes", "1") +
                     option("ntasks", "1") +
                     option("cpus-per-task", std::to_string(request.cpus > 0 ? request.cpus : sweep.file.threads)) +
                     option("signal", "B:USR1@" + std::to_string(request.signal)) + option("--requeue") +
                     option("open-mode", "append") +
                     option("output", shell_word(pattern((directory / "logs").string()) + "/slurm-%A_%a.txt")) +
                     option("partition", request.partition) + option("time", request.time) +
                     option("account", request.account) + option("mem", request.memory);
  for (const std::string& own : request.options) text += option(own);
  return text;
}

std::string task_of(std::size_t number, const CheckedPoint& point) {
  std::string settings;
  for (const std::string& setting : point.overrides)
    settings += (settings.empty() ? "" : " ") + shell_line({"--set", setting});
  return "  " + std::to_string(number) + ")\n    point=" + shell_word(point.name) + "\n    settings=(" + settings +
         ")\n    ;;\n";
}

/// The command without what differs from task to task: the settings and the directory of the point.
std::string command_of(const fs::path& program, const CheckedSweep& sweep) {
  const CheckedPoint any{.point = {}, .name = "point", .setting = {}, .overrides = {}, .resolved = {}, .inputs = {}};
  const std::vector<std::string> words = run_arguments("", sweep, any);
  const auto out = std::find(words.begin(), words.end(), "--out");
  return shell_word(program.string()) + " " + shell_line({words.begin(), out}) + " \"${settings[@]}\" --out \"$out\" " +
         shell_line({out + 2, words.end()});
}

constexpr const char* head = R"SH(#!/bin/bash
# A job array of gyrosim sweep: one task for each point that was not done when this file was written.
# The sweep has submitted it, unless it was called with --dry-run; `sbatch job.sh` submits it as well.
)SH";

constexpr const char* body = R"SH(
out=$directory/$point
checkpoint_time() { stat --format=%y "$out/checkpoint.h5" 2>/dev/null; }
before=$(checkpoint_time)

# SIGUSR1 comes before the time limit, SIGTERM from scancel. Both are for the run.
caught=no cancelled=no
trap 'caught=yes; kill -USR1 "$run" 2>/dev/null' USR1
trap 'caught=yes; cancelled=yes; kill -TERM "$run" 2>/dev/null' TERM
COMMAND \
  >>"$directory/logs/$point.txt" 2>&1 &
run=$!
wait "$run"; code=$?
while [ $caught = yes ]; do  # the signal has ended the wait
  caught=no
  wait "$run"; code=$?
done

echo "$(date --iso-8601=seconds) $point: exit code $code, restarts so far: ${SLURM_RESTART_COUNT:-0}"
if [ $code -eq 75 ] && [ $cancelled = no ]; then
  if [ "$(checkpoint_time)" = "$before" ]; then
    echo "$point: no checkpoint in this time; ask for a longer time limit"
  else
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
  fi
fi
exit $code
)SH";

std::string body_with(const std::string& command) {
  std::string text = body;
  constexpr std::string_view place = "COMMAND";
  return text.replace(text.find(place), place.size(), command);
}

}  // namespace

std::string slurm_script(const fs::path& program, const fs::path& directory, const CheckedSweep& sweep,
                         const std::vector<const CheckedPoint*>& points) {
  std::string text = head + options_of(directory, sweep, points.size());
  text += "\ndirectory=" + shell_word(directory.string()) + "\ncase $SLURM_ARRAY_TASK_ID in\n";
  for (std::size_t k = 0; k < points.size(); ++k) text += task_of(k + 1, *points[k]);
  text += "  *)\n    echo \"there is no task $SLURM_ARRAY_TASK_ID\" >&2\n    exit 2\n    ;;\nesac\n";
  return text + body_with(command_of(program, sweep));
}

}  // namespace gyro
