// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/sweep_file.hpp"

#include "app/run/run_end.hpp"
#include "app/sweep/axes_reader.hpp"
#include "app/sweep/point_names.hpp"
#include "app/sweep/points.hpp"
#include "app/sweep/value_text.hpp"
#include "io/files/read_file.hpp"
#include "io/schema/values.hpp"

#include <algorithm>
#include <cctype>

namespace gyro {
namespace {

namespace fs = std::filesystem;
using Kind = YamlNode::Kind;

constexpr std::size_t largest_file = 16 << 20;  // [bytes]; keeps a wrong file out of memory
constexpr std::int64_t largest_seed = std::int64_t{1} << 53;

/// Reads the keys at the top of a sweep file.
class SweepReader {
 public:
  SweepReader(SweepFile& sweep, CaseProblems& problems) : sweep_(sweep), reader_(problems) {}

  void read(const YamlNode& root) {
    reader_.refuse_unknown(root,
                           {"case", "set", "seeds", "vary", "together", "latin_hypercube", "names", "until",
                            "max_walltime", "threads", "slurm"},
                           "");
    read_case(root);
    read_set(root);
    read_seeds(root);
    sweep_.axes = read_axes(root, reader_);
    read_names(root);
    read_run_options(root);
    read_slurm(root);
    refuse_keys_twice();
    refuse_names_twice();
    refuse_too_many(root.mark);
  }

 private:
  void read_case(const YamlNode& root) {
    constexpr std::string_view form = "the path of a case file, relative to this file";
    const std::string path = reader_.text(root, "case", form);
    if (const YamlEntry* entry = root.find("case"))
      sweep_.case_mark = entry->value.mark;
    else
      reader_.problem(root.mark, "required key \"case\" is missing; give " + std::string(form));
    if (path.empty()) return;
    sweep_.case_file = (sweep_.file.parent_path() / path).lexically_normal();
    std::error_code error;
    if (!fs::exists(sweep_.case_file, error))
      reader_.problem(sweep_.case_mark,
                      "case: there is no file " + sweep_.case_file.string() + "; give " + std::string(form));
  }

  void read_set(const YamlNode& root) {
    constexpr std::string_view form = "a map of keys to values, as `time.duration: 0.5 s`";
    const YamlEntry* set = reader_.given(root, "set", form);
    if (set == nullptr || !reader_.has_kind(*set, Kind::map, form)) return;
    for (const YamlEntry& entry : set->value.entries)
      if (reader_.case_key(entry.key, entry.mark))
        sweep_.set.push_back({entry.key, value_text(entry.value), entry.mark, entry.value.mark});
  }

  void read_seeds(const YamlNode& root) {
    const YamlEntry* seeds = reader_.given(root, "seeds", "their number, or a list of seeds");
    if (seeds == nullptr) return;
    if (seeds->value.kind != Kind::list) {
      const auto count = reader_.integer(seeds->value, "seeds", 1, max_points);
      for (std::int64_t k = 1; count && k <= *count; ++k)
        sweep_.seeds.push_back({static_cast<std::uint64_t>(k), seeds->value.mark});
      return;
    }
    if (seeds->value.items.empty()) reader_.problem(seeds->value.mark, "seeds is empty; give at least one seed");
    for (const YamlNode& item : seeds->value.items) {
      const auto seed = reader_.integer(item, "seeds", 0, largest_seed);
      if (!seed) continue;
      const auto same = [&](const SweepSeed& other) { return other.seed == static_cast<std::uint64_t>(*seed); };
      if (std::any_of(sweep_.seeds.begin(), sweep_.seeds.end(), same))
        reader_.problem(item.mark, "seeds has " + item.text + " twice; give each seed once");
      else
        sweep_.seeds.push_back({static_cast<std::uint64_t>(*seed), item.mark});
    }
  }

  void read_names(const YamlNode& root) {
    constexpr std::string_view form = "a map of keys to short names, as `crusher.closed_side_setting: css`";
    const YamlEntry* names = reader_.given(root, "names", form);
    if (names == nullptr || !reader_.has_kind(*names, Kind::map, form)) return;
    const std::vector<std::string> keys = varied_keys(sweep_);
    for (const YamlEntry& entry : names->value.entries) {
      const std::string& name = entry.value.text;
      const auto good = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '-'; };
      if (std::find(keys.begin(), keys.end(), entry.key) == keys.end())
        reader_.problem(entry.mark, "names: " + entry.key + " does not vary; name only keys that vary");
      if (name.empty() || name.size() > 30 || !std::isalpha(static_cast<unsigned char>(name[0])) ||
          !std::all_of(name.begin(), name.end(), good))
        reader_.problem(entry.value.mark,
                        "names: a short name begins with a letter and has at most 30 letters, digits, _ . and -");
      else
        sweep_.names[entry.key] = name;
    }
  }

  void read_run_options(const YamlNode& root) {
    sweep_.until = reader_.text(root, "until", "a time, steady or steady=ERROR");
    if (const ParsedRunEnd end = parse_run_end(sweep_.until); !sweep_.until.empty() && !end.end)
      reader_.problem(root.find("until")->value.mark, "until: " + end.problem);
    sweep_.max_walltime = reader_.text(root, "max_walltime", "a time, such as 10 h");
    if (!sweep_.max_walltime.empty()) {
      const ParsedNumber time = parse_quantity(sweep_.max_walltime, Dimension::time);
      if (!time.value || !(*time.value > 0))
        reader_.problem(root.find("max_walltime")->value.mark,
                        "max_walltime: " + (time.value ? std::string("must be > 0") : time.problem));
    }
    if (const YamlEntry* threads = reader_.given(root, "threads", "a whole number"))
      sweep_.threads = static_cast<int>(reader_.integer(threads->value, "threads", 1, 4096).value_or(1));
  }

  void read_slurm(const YamlNode& root) {
    constexpr std::string_view form = "a map of partition, time, cpus, account, memory, signal, at_once and options";
    const YamlEntry* slurm = reader_.given(root, "slurm", form);
    if (slurm == nullptr || !reader_.has_kind(*slurm, Kind::map, form)) return;
    const YamlNode& map = slurm->value;
    reader_.refuse_unknown(map, {"partition", "time", "cpus", "account", "memory", "signal", "at_once", "options"},
                           " in slurm");
    SlurmRequest& request = sweep_.slurm;
    request.partition = reader_.text(map, "partition", "the name of a partition");
    request.time = reader_.text(map, "time", "a time as sbatch takes it, such as \"12:00:00\"");
    request.account = reader_.text(map, "account", "the name of an account");
    request.memory = reader_.text(map, "memory", "the memory of a point as sbatch takes it, such as 4G");
    if (const YamlEntry* cpus = reader_.given(map, "cpus", "a whole number"))
      request.cpus = static_cast<int>(reader_.integer(cpus->value, "cpus", 1, 4096).value_or(0));
    if (const YamlEntry* signal = reader_.given(map, "signal", "seconds before the time limit"))
      request.signal = static_cast<int>(reader_.integer(signal->value, "signal", 1, 65535).value_or(1));
    if (const YamlEntry* at_once = reader_.given(map, "at_once", "a number of points"))
      request.at_once = static_cast<int>(reader_.integer(at_once->value, "at_once", 1, max_points).value_or(1));
    read_slurm_options(map);
  }

  void read_slurm_options(const YamlNode& map) {
    constexpr std::string_view options_form = "a list of options of sbatch, as [\"--gres=gpu:1\"]";
    const YamlEntry* options = reader_.given(map, "options", options_form);
    if (options == nullptr || !reader_.has_kind(*options, Kind::list, options_form)) return;
    for (const YamlNode& item : options->value.items) {
      if (item.kind != Kind::scalar || !item.text.starts_with("-") || item.text.find('\n') != std::string::npos)
        reader_.problem(item.mark, "options: this is not an option; give " + std::string(options_form));
      else if (item.text.starts_with("-a") || item.text.starts_with("--array"))
        reader_.problem(item.mark, "options: the sweep numbers its tasks itself; `at_once` limits them");
      else
        sweep_.slurm.options.push_back(item.text);
    }
  }

  void refuse_keys_twice() {
    std::map<std::string, int> lines;
    const auto note = [&](const SweepSetting& setting) {
      const auto [known, is_new] = lines.try_emplace(setting.key, setting.key_mark.line);
      if (!is_new)
        reader_.problem(setting.key_mark,
                        setting.key + " is given in line " + std::to_string(known->second) + " already; give it once");
    };
    for (const SweepSetting& setting : sweep_.set) note(setting);
    for (const SweepAxis& axis : sweep_.axes)
      for (const SweepSetting& setting : axis.front()) note(setting);
  }

  void refuse_names_twice() {
    const std::vector<std::string> keys = varied_keys(sweep_), names = short_names(keys, sweep_.names);
    for (std::size_t k = 1; k < names.size(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (names[j] == names[k] && keys[j] != keys[k])
          reader_.problem({}, keys[j] + " and " + keys[k] + " have the same short name " + in_quotes(names[k]) +
                                  "; give others with `names`");
  }

  void refuse_too_many(const Mark& mark) {
    if (count_points(sweep_, max_points) > max_points)
      reader_.problem(mark, "the sweep has more than 100,000 points; vary fewer keys");
  }

  SweepFile& sweep_;
  MapReader reader_;
};

std::string text_of(const fs::path& file, CaseProblems& problems) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return problems.add({}, "there is no such file; give the path of a sweep file"), "";
  if (fs::is_directory(status)) return problems.add({}, "is a directory; give the path of a sweep file"), "";
  try {
    return read_file(file, largest_file);
  } catch (const UnreadableFile& unreadable) {
    return problems.add({}, unreadable.problem), "";
  }
}

}  // namespace

SweepReport load_sweep(const fs::path& file) {
  CaseProblems problems(file.string());
  SweepFile sweep;
  sweep.file = file;
  const std::string text = text_of(file, problems);
  if (problems.empty()) {
    const YamlDocument document = parse_yaml(text);
    for (const MarkedProblem& problem : document.problems) problems.add(problem.mark, problem.message);
    if (document.root.kind == Kind::map)
      SweepReader(sweep, problems).read(document.root);
    else if (problems.empty())
      problems.add({}, "is not a sweep file; begin with `case: PATH`");
  }
  SweepReport report;
  report.problems = problems.sorted();
  if (report.problems.empty()) report.loaded = std::move(sweep);
  return report;
}

}  // namespace gyro
