// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/checked_points.hpp"

#include "app/sweep/point_names.hpp"
#include "io/case/parts.hpp"
#include "io/files/digest.hpp"
#include "io/schema/schema.hpp"

#include <map>
#include <set>
#include <tuple>

namespace gyro {
namespace {

/// Collects the problems of all points, each once.
class PointProblems {
 public:
  explicit PointProblems(const SweepFile& sweep) : sweep_(sweep), problems_(sweep.file.string()) {}

  /// @param overrides  of which the problem's line counts, as --set would
  void add(const CaseProblem& problem, const std::vector<SweepSetting>& settings,
           const std::vector<std::string>& overrides) {
    if (!seen_.emplace(place_of(problem, settings), problem.message).second) return;
    const auto number = static_cast<std::size_t>(problem.line - 1);
    if (problem.file != "--set") {
      problems_.add_in_file(problem.file, problem.line, problem.column, problem.message);
    } else if (number < settings.size()) {
      const std::size_t equals = overrides[number].find('=');
      const bool of_value = problem.column > static_cast<int>(equals) + 1;
      problems_.add(of_value ? settings[number].value_mark : settings[number].key_mark, problem.message);
    }
  }
  void add(const Mark& mark, const std::string& message) { problems_.add(mark, message); }
  std::vector<CaseProblem> sorted() const { return problems_.sorted(); }

 private:
  /// File, line and column; of an override those of its value in the sweep file.
  std::tuple<std::string, int, int> place_of(const CaseProblem& problem,
                                             const std::vector<SweepSetting>& settings) const {
    const auto number = static_cast<std::size_t>(problem.line - 1);
    if (problem.file != "--set" || number >= settings.size()) return {problem.file, problem.line, problem.column};
    return {"", settings[number].value_mark.line, settings[number].value_mark.column};
  }

  const SweepFile& sweep_;
  CaseProblems problems_;
  std::set<std::pair<std::tuple<std::string, int, int>, std::string>> seen_;
};

const Mark& mark_of(const SweepFile& sweep, const SweepPoint& point) {
  return !point.varied.empty() ? point.varied.back().value_mark : point.seed ? point.seed->mark : sweep.case_mark;
}

CheckedPoint checked(const CheckedSweep& sweep, const SweepPoint& point, const Case& loaded,
                     std::vector<std::string> overrides) {
  CheckedPoint good;
  good.point = point;
  good.seed = loaded.identity.seed;
  good.setting = setting_name(sweep.names, point);
  good.name = point_name(good.setting, good.seed);
  good.overrides = std::move(overrides);
  good.resolved = loaded.resolved;
  good.inputs = loaded.inputs.empty() ? "" : digest_of(loaded.inputs).substr(0, 16);
  good.end = sweep.until.until.value_or(loaded.time.duration);
  return good;
}

/// Reports points whose cases or names are those of an earlier point.
void refuse_equal_points(const CheckedSweep& sweep, PointProblems& problems) {
  std::map<std::string, std::string> cases, names;
  for (const CheckedPoint& point : sweep.points) {
    const Mark& mark = mark_of(sweep.file, point.point);
    const auto [same, new_case] = cases.try_emplace(digest_of(point.resolved), point.name);
    const auto [known, new_name] = names.try_emplace(point.name, point.name);
    if (!new_name)
      problems.add(mark, "two points have the name " + point.name + "; give `names` that tell their keys apart");
    else if (!new_case)
      problems.add(mark, "the points " + same->second + " and " + point.name +
                             " have the same case; remove the value that changes nothing");
  }
}

}  // namespace

CheckedSweep check_points(const SweepFile& sweep) {
  CheckedSweep result{.file = sweep};
  if (!sweep.until.empty()) result.until = parse_run_end(sweep.until).end.value();
  result.names = short_names(varied_keys(sweep), sweep.names);
  PointProblems problems(sweep);
  for (const SweepPoint& point : expand(sweep)) {
    const std::vector<SweepSetting> settings = settings_of(sweep, point);
    std::vector<std::string> overrides = overrides_of(settings);
    const CaseReport report = load_case(sweep.case_file, overrides);
    for (const CaseProblem& problem : report.problems) problems.add(problem, settings, overrides);
    if (report.loaded) result.points.push_back(checked(result, point, *report.loaded, std::move(overrides)));
  }
  refuse_equal_points(result, problems);
  result.problems = problems.sorted();
  return result;
}

std::string resolved_value(const std::string& resolved, const std::string& key) {
  const YamlDocument document = parse_yaml(resolved);
  const YamlNode* node = &document.root;
  for (const std::string_view part : split(key, '.')) {
    const YamlEntry* entry = node->find(part);
    if (entry == nullptr) return {};
    node = &entry->value;
  }
  return node->kind == YamlNode::Kind::scalar ? node->text : "";
}

}  // namespace gyro
