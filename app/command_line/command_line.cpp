// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.hpp"

#include "app/commands/commands.hpp"
#include "app/run/run_end.hpp"
#include "app/version.hpp"
#include "io/yaml/units.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace gyro {
namespace {

/// A time given on the command line: plain seconds or with a unit.
std::function<bool(const CLI::results_t&)> seconds_into(std::optional<double>& target, const std::string& name) {
  return [&target, name](const CLI::results_t& words) {
    const ParsedNumber parsed = parse_quantity(words.front(), Dimension::time);
    if (!parsed.value) throw CLI::ValidationError(name + ": " + parsed.problem);
    if (!(*parsed.value >= 0)) throw CLI::ValidationError(name + ": must be >= 0");
    target = parsed.value;
    return true;
  };
}

/// The end of a run: a time, or `steady`, perhaps with a relative standard error.
std::function<bool(const CLI::results_t&)> end_into(RunArguments& a) {
  return [&a](const CLI::results_t& words) {
    const ParsedRunEnd parsed = parse_run_end(words.front());
    if (!parsed.end) throw CLI::ValidationError("--until: " + parsed.problem);
    a.until = parsed.end->until;
    a.steady = parsed.end->steady;
    return true;
  };
}

/// Why a file system takes no such name; empty if it does. Names of files are added to a directory's.
std::string possible_name(const std::string& name) {
  constexpr std::size_t longest_part = 255, longest = 4000;  // bytes, of Linux; a path has 4096
  if (name.size() > longest) return "the name has " + std::to_string(name.size()) + " bytes; give at most 4000";
  for (const auto& part : std::filesystem::path(name))
    if (part.native().size() > longest_part)
      return "a part of the name has " + std::to_string(part.native().size()) + " bytes; give at most 255";
  return {};
}

void add_case(CLI::App& command, CaseArguments& arguments) {
  command.add_option("case", arguments.file, "case file")->required();
  command.add_option("--set", arguments.set, "override a key: key.path=value")->allow_extra_args(false);
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "threads on the CPU; default all cores")
      ->check(CLI::Range(1, 4096))
      ->envname("GYROSIM_THREADS");
}

void add_run(CLI::App& command, RunArguments& a) {
  add_case(command, a.input);
  command.add_option("--out", a.out, "directory of the results; default runs/<case>-NNN")->check(possible_name);
  command.add_option("--device", a.device, "auto, cpu or cuda")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}))
      ->envname("GYROSIM_DEVICE");
  add_threads(command, a.threads);
  command.add_flag("--resume", a.resume, "continue an interrupted run");
  command.add_flag("--overwrite", a.overwrite, "start again in a directory that holds a run");
  command
      .add_option("--until", end_into(a),
                  "end at this simulated time instead of time.duration; steady or steady=ERROR: before time.duration, "
                  "once throughput, crushing power and P80 are known to this relative standard error, default 5%")
      ->type_name("TIME");
  command
      .add_option("--max-walltime", seconds_into(a.max_walltime, "--max-walltime"),
                  "stop after this much wall-clock time")
      ->type_name("TIME");
  command.add_flag("--quiet", a.quiet, "no progress and no summary");
  command.add_flag(
      "--progress-json", a.json_progress,
      "progress as lines of JSON on standard error, for programs that start runs; with --quiet nothing else is there");
}

void add_sweep(CLI::App& command, SweepArguments& a) {
  command.add_option("SWEEP", a.file, "sweep file")->required();
  command.add_option("--engine", a.engine, "what runs the points: this machine (local) or a batch system (slurm)")
      ->check(CLI::IsMember({"local", "slurm"}));
  command.add_option("--out", a.out, "directory of the points and results; default runs/<sweep>")->check(possible_name);
  command.add_option("--jobs", a.jobs, "points side by side on this machine; default cores / threads of a point")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--retry", a.retry, "run points again that have failed or that a guard has stopped");
  CLI::Option* collect = command.add_flag("--collect", a.collect, "only write the results of what has run so far");
  command
      .add_flag("--dry-run", a.dry_run, "list the points and run nothing; with slurm, write job.sh without submitting")
      ->excludes(collect);
  command.add_flag("--quiet", a.quiet, "no progress and no table");
}

void add_bench_accuracy(CLI::App& command, BenchAccuracyArguments& a) {
  command.add_option("--scene", a.scene, "platen, wedge or crusher; default all");
  command.add_option("--knob", a.knob, "only the points of this knob");
  command.add_option("--threads", a.threads, "runs side by side, each on one thread")->check(CLI::Range(1, 4096));
  command.add_flag("--quick", a.quick, "few points and three seeds");
  command.add_option("--folder", a.folder, "scenes and reference.json; default those of the source folder");
  command.add_flag("--make-reference", a.make_reference, "compute the references and write reference.json");
  command.add_flag("--json", a.json, "one JSON document on standard output");
}

void add_bench_speed(CLI::App& command, BenchSpeedArguments& a) {
  const auto list = [&command](const char* name, auto& target, const char* text) {
    return command.add_option(name, target, text)->allow_extra_args(false);
  };
  list("--scene", a.scenes, "S1, S2, S2r, S3, Q, C or F; give it again for more; default all but F");
  list("--threads", a.threads, "threads of a run; default 1 and 2")->check(CLI::Range(1, 4096));
  list("--precision", a.precisions, "mixed or double; default both")->check(CLI::IsMember({"mixed", "double"}));
  list("--set", a.set, "override a key of all cases: key.path=value");
  command.add_option("--repeat", a.repeat, "runs of each setting, in turn; medians and spread")
      ->check(CLI::Range(1, 1000));
  command.add_option("--seed", a.seed, "of the start states of S1 to S3");
  command.add_option("--particles", a.particles, "of S1 to S3, about; 20,000 by default")
      ->check(CLI::Range(1000, 5000000));
  command.add_option("--warm-up", a.warm_up, "steps before the clock starts")->check(CLI::Range(0, 1000000000));
  command.add_option("--steps", a.timed, "steps that are timed")->check(CLI::Range(1, 1000000000));
  command.add_option("--states", a.states, "folder that keeps the start states, for other programs and later calls")
      ->check(possible_name);
  command.add_flag("--ceiling", a.ceiling, "cost of a bond in cache beside its arithmetic; no scenes but those named");
  command.add_flag("--growth", a.growth, "cost of S2r by its size, from 1000 particles on; no scenes but those named");
  command.add_flag("--states-only", a.states_only, "write the start states and measure nothing");
  command.add_flag("--json", a.json, "one JSON document on standard output");
}

/// What is wrong with a command line, and where its options are listed.
std::string usage_problem(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> chosen = app->get_subcommands();
  std::string text = error.what();
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  const std::vector<std::string> unknown = chosen.empty() ? app->remaining() : chosen.front()->remaining();
  if (!unknown.empty()) text = "there is no `" + unknown.front() + "`";
  if (!chosen.empty()) return text + "; `gyrosim " + chosen.front()->get_name() + " --help` lists the options\n";
  text += "; the commands are";
  for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
    text += " " + command->get_name();
  return text + "\n";
}

/// The arguments of all commands.
struct Arguments {
  RunArguments run;
  SweepArguments sweep;
  CaseArguments check, library, liners, fmu;
  std::optional<std::filesystem::path> library_out, fmu_out;
  std::filesystem::path liners_out;
  ReportArguments report;
  ExportArguments exported;
  VerifyArguments verify;
  BenchAccuracyArguments accuracy;
  BenchSpeedArguments speed;
  DescribeArguments describe;
  std::string name = "quickstart";
  bool info_json = false;
  std::function<int()> chosen;  ///< the command that the command line names
};

void add_commands_of_cases(CLI::App& app, Arguments& a) {
  CLI::App* c = app.add_subcommand("run", "run a case");
  add_run(*c, a.run);
  c->callback([&a] { a.chosen = [&a] { return run_command(a.run); }; });

  c = app.add_subcommand("sweep", "run a case with several values of its keys, and compare the results");
  add_sweep(*c, a.sweep);
  c->callback([&a] { a.chosen = [&a] { return sweep_command(a.sweep); }; });

  c = app.add_subcommand("check", "validate a case; print its time step, counts and expected wall time");
  add_case(*c, a.check);
  add_threads(*c, a.check.threads);
  c->add_flag("--json", a.check.json, "one JSON document on standard output");
  c->callback([&a] { a.chosen = [&a] { return check_command(a.check); }; });

  c = app.add_subcommand("library", "build the meta-particle library of a case");
  add_case(*c, a.library);
  add_threads(*c, a.library.threads);
  c->add_option("--out", a.library_out, "directory")->check(possible_name);
  c->add_flag("--json", a.library.json, "one JSON document on standard output");
  c->callback([&a] { a.chosen = [&a] { return library_command(a.library, a.library_out); }; });

  c = app.add_subcommand("liners", "measure the chamber of profile or meshes, write the set liners as STL");
  add_case(*c, a.liners);
  c->add_option("--out", a.liners_out, "directory")->required()->check(possible_name);
  c->add_flag("--json", a.liners.json, "one JSON document on standard output");
  c->callback([&a] { a.chosen = [&a] { return liners_command(a.liners, a.liners_out); }; });
}

void add_commands_of_runs(CLI::App& app, Arguments& a) {
  CLI::App* c = app.add_subcommand("report", "print the summary of runs again, or write a page with all their results");
  c->add_option("RUNDIR", a.report.runs, "directories of runs; several are compared")->required();
  c->add_option("--out", a.report.out, "one HTML page with figures and plots, which needs no other file: FILE.html")
      ->check(possible_name);
  c->callback([&a] { a.chosen = [&a] { return report_command(a.report); }; });

  CLI::App* forms = app.add_subcommand("export", "write results in another form")->require_subcommand(1);
  c = forms->add_subcommand("fmu", "the drivetrain as an FMI 2.0 co-simulation FMU");
  c->add_option("CASE", a.fmu.file, "case file, or directory of a run")->required();
  c->add_option("--set", a.fmu.set, "override a key: key.path=value")->allow_extra_args(false);
  c->add_option("--out", a.fmu_out, "file; default CASE.fmu in the working directory")->check(possible_name);
  c->callback([&a] { a.chosen = [&a] { return export_fmu_command(a.fmu, a.fmu_out); }; });
  c = forms->add_subcommand("csv", "a table of a run as CSV");
  c->add_option("RUNDIR", a.exported.run, "directory of a run")->required();
  c->add_option("--table", a.exported.table,
                "series, ledger, breakage, fragments, product, holdup or performance; default series");
  c->add_option("--out", a.exported.out, "file; default standard output")->check(possible_name);
  c->callback([&a] { a.chosen = [&a] { return export_command(a.exported); }; });
}

void add_other_commands(CLI::App& app, Arguments& a) {
  CLI::App* c = app.add_subcommand("describe", "documentation of the case file's keys and of all outputs");
  c->add_option("key", a.describe.key, "a key or a section of a case, default all; or outputs");
  c->add_flag("--json-schema", a.describe.json_schema, "the keys as JSON Schema for editors");
  c->add_flag("--json", a.describe.json, "the outputs as one JSON document");
  c->add_flag("--markdown", a.describe.markdown, "the outputs as a page");
  c->callback([&a] { a.chosen = [&a] { return describe_command(a.describe); }; });

  c = app.add_subcommand("verify", "compare the engine with theory, one line per check");
  c->add_option("--filter", a.verify.filter, "regular expression searched in group/case/quantity");
  c->add_flag("--nightly", a.verify.nightly, "the long cases as well");
  c->add_flag("--json", a.verify.json, "one JSON document on standard output");
  c->callback([&a] { a.chosen = [&a] { return verify_command(a.verify); }; });

  CLI::App* benches =
      app.add_subcommand("bench", "measure speed, and what numerical choices cost and how accurate they are")
          ->require_subcommand(1);
  c = benches->add_subcommand("speed", "how fast named scenes are, where their time goes, and their memory");
  add_bench_speed(*c, a.speed);
  c->callback([&a] { a.chosen = [&a] { return bench_speed_command(a.speed); }; });
  c = benches->add_subcommand("accuracy", "work against error: cost and error of numerical choices on three scenes");
  add_bench_accuracy(*c, a.accuracy);
  c->callback([&a] { a.chosen = [&a] { return bench_accuracy_command(a.accuracy); }; });

  c = app.add_subcommand("init", "print a commented case to start from");
  c->add_option("--template", a.name, "quickstart, primary or compression");
  c->callback([&a] { a.chosen = [&a] { return init_command(a.name); }; });

  c = app.add_subcommand("info", "version, build and machine");
  c->add_flag("--json", a.info_json, "one JSON document on standard output");
  c->callback([&a] { a.chosen = [&a] { return info_command(a.info_json); }; });
}

/// The whole command line; `arguments` must outlive it.
std::unique_ptr<CLI::App> make_app(Arguments& arguments) {
  auto app = std::make_unique<CLI::App>("gyrosim: rock breakage in gyratory crushers");
  app->set_version_flag("--version", std::string("gyrosim ") + version::number + " (" + version::git + ")");
  app->require_subcommand(1);
  app->failure_message(usage_problem);
  add_commands_of_cases(*app, arguments);
  add_commands_of_runs(*app, arguments);
  add_other_commands(*app, arguments);
  return app;
}

/// The words between the braces of a type such as "TEXT:{auto,cpu,cuda}"; none where there are no braces.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  const std::string type = option.get_type_name();
  text.positional = option.get_positional();
  text.name = text.positional ? option.get_name(true) : "--" + option.get_lnames().front();
  text.description = option.get_description();
  text.takes_value = option.get_items_expected_max() > 0;
  if (text.takes_value && !text.positional) text.value = type.substr(0, type.find(':'));
  text.choices = choices_of(type);
  return text;
}

CommandText text_of(const CLI::App& app) {
  CommandText text;
  text.name = app.get_name();
  text.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) text.options.push_back(text_of(*option));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text.commands.push_back(text_of(*command));
  return text;
}

}  // namespace

CommandLine parse_command_line(int argc, char** argv) {
  const auto arguments = std::make_shared<Arguments>();
  const std::unique_ptr<CLI::App> app = make_app(*arguments);
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return {nullptr, app->exit(e) == 0 ? exit_done : exit_bad_input};
  }
  return {[arguments] { return arguments->chosen(); }, exit_done};
}

CommandText command_line_text() {
  Arguments arguments;
  return text_of(*make_app(arguments));
}

}  // namespace gyro
