// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/commands/library_wait.hpp"
#include "app/output/steady_goal.hpp"
#include "app/run/case_run.hpp"
#include "app/run/stop_request.hpp"
#include "app/sweep/shell_text.hpp"
#include "core/base/errors.hpp"

#include <array>
#include <charconv>
#include <iostream>
#include <string>
#include <vector>

namespace gyro {
namespace {

/// The state to continue from, if the directory holds a run that can be continued.
std::optional<SavedState> state_to_resume(const Case& input, const RunDirectory& directory) {
  if (directory.state == RunDirectory::State::fresh) return {};
  if (directory.state == RunDirectory::State::finished || std::filesystem::exists(checkpoint_file(directory.path)))
    return read_checkpoint(directory.path, input);
  // It ended before its first checkpoint: nothing is lost when the same case starts again.
  require_same_case(directory.path, input);
  std::cerr << directory.path.string() << " holds no checkpoint yet; the run starts at its beginning\n";
  return {};
}

/// Whether a finished run has ended with figures as well known as is asked now.
bool is_known_already(const Case& input, const RunDirectory& directory, double error) {
  const SavedState saved = read_checkpoint(directory.path, input);
  GyrationReader gyrations;
  gyrations.restore(saved);
  const std::vector<GyrationMeans>& all = gyrations.record().gyrations;
  return !all.empty() && all.back().end == saved.get_one<double>("output/time") &&
         is_known(steady_progress(gyrations.record(), sieves_of(input)), error);
}

/// Whether the directory holds a run that is finished and need not be continued; says so.
bool nothing_to_do(const RunArguments& arguments, const Case& input, const RunDirectory& directory, double end) {
  if (directory.state != RunDirectory::State::finished) return false;
  double later = end - directory.simulated_seconds;
  if (arguments.resume && later >= 1e-6 * input.coupling_interval) {
    if (!arguments.steady ||
        !located(arguments.input, [&] { return is_known_already(input, directory, *arguments.steady); }))
      return false;
    later = 0;
  }
  located(arguments.input, [&] { require_same_case(directory.path, input); });
  std::cerr << directory.path.string() << " holds a run that is finished at t = " << directory.simulated_seconds
            << " s; " << (later > 0 && !arguments.resume ? "--resume continues it to the later end" : "nothing to do")
            << "\n";
  return true;
}

/// Refuses --until steady for a case whose gyrations and product nobody counts.
void require_crusher(const Case& input) {
  if (input.crusher && (input.drivetrain || input.drivetrain_fmu)) return;
  throw BadKey(input.crusher ? "drivetrain" : "crusher",
               std::string("--until steady waits for throughput, power and P80 of a crusher, and the case has no ") +
                   (input.crusher ? "drivetrain" : "crusher") + "; give --until a time, or leave it out");
}

/// Refuses a run that would write over the one that fills its chamber.
void require_other_directory(const Case& input, const std::optional<std::filesystem::path>& out) {
  std::error_code error;
  if (!out || !input.feed || input.feed->initial_from.empty()) return;
  if (std::filesystem::equivalent(*out, input.feed->initial_from.parent_path(), error))
    throw BadKey("feed.initial_from",
                 "feed.initial_from is the directory of this run, " + out->string() + "; give another --out");
}

int exit_code(RunStatus status) {
  return status == RunStatus::interrupted ? exit_interrupted : status == RunStatus::stopped ? exit_stopped : exit_done;
}

/// The command that continues a run, for a shell.
std::string continuing_command(const RunArguments& a, const std::filesystem::path& directory) {
  std::vector<std::string> words{"gyrosim", "run", a.input.file.string()};
  const auto add = [&](const char* option, const std::string& value) { words.insert(words.end(), {option, value}); };
  const auto number = [](double value) {  // the shortest text that is this number
    std::array<char, 32> text;
    return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
  };
  for (const std::string& setting : a.input.set) add("--set", setting);
  if (a.until) add("--until", number(*a.until));
  if (a.steady) add("--until", "steady=" + number(*a.steady));
  if (a.max_walltime) add("--max-walltime", number(*a.max_walltime));
  if (a.device != "auto") add("--device", a.device);
  if (a.threads > 0) add("--threads", std::to_string(a.threads));
  if (a.json_progress) words.emplace_back("--progress-json");
  add("--out", directory.string());
  words.emplace_back("--resume");
  return shell_line(words);
}

}  // namespace

int run_command(const RunArguments& arguments) {
  catch_stop_signals(exit_interrupted);
  const std::optional<Case> input = load_or_complain(arguments.input);
  if (!input) return exit_bad_input;
  located(arguments.input, [&] { require_other_directory(*input, arguments.out); });
  if (arguments.steady) located(arguments.input, [&] { require_crusher(*input); });
  RunOptions options;
  options.directory = {arguments.out, arguments.input.file.stem().string(), arguments.resume, arguments.overwrite, {}};
  options.directory.lock = lock_run_directory(arguments.out);
  options.until = arguments.until;
  options.end = arguments.until.value_or(input->time.duration);
  options.steady = arguments.steady;
  options.max_walltime = arguments.max_walltime;
  options.quiet = arguments.quiet;
  options.json_progress = arguments.json_progress;
  if (!arguments.quiet && !arguments.json_progress) options.library_progress = LibraryWait();
  const RunDirectory directory = find_run_directory(options.directory);
  if (nothing_to_do(arguments, *input, directory, options.end)) return exit_done;
  std::optional<CaseRun> run;
  located(arguments.input, [&] {
    const std::optional<SavedState> saved = state_to_resume(*input, directory);
    const bool cpu_only = input->numerics.rigid.has_value();
    options.device =
        choose_device(cpu_only && arguments.device == "auto" ? "cpu" : arguments.device, arguments.threads);
    if (cpu_only && options.device.cuda)
      throw BadKey("numerics.levels.rigid",
                   "rocks that move as rigid bodies are computed on the CPU only; use --device cpu, or rigid: off");
    run.emplace(*input, options, saved ? &*saved : nullptr);
  });
  const RunStatus status = run->run();
  if (status == RunStatus::interrupted && !arguments.quiet)
    std::cerr << "to continue: " << continuing_command(arguments, run->directory()) << "\n";
  return exit_code(status);
}

}  // namespace gyro
