// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/report.hpp"

#include "core/base/errors.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>

namespace gyro::verify {
namespace {

std::regex expression(const std::string& text) {
  try {
    return std::regex(text, std::regex::ECMAScript | std::regex::icase);
  } catch (const std::regex_error& problem) {
    throw BadInput("--filter: '" + text + "' is not a regular expression (" + problem.what() +
                   "); give one in ECMAScript syntax, which is searched in group/case/quantity");
  }
}

/// Names of the checks of a verification; empty if the list has none.
std::vector<std::string> names_of(const CheckNames& names, const Verification& verification) {
  const auto found = names.find(verification.name);
  return found == names.end() ? std::vector<std::string>{} : found->second;
}

BadInput nothing_fits(std::span<const Verification> verifications, const std::string& filter, bool only_nightly) {
  if (only_nightly) return BadInput("--filter: only nightly checks match '" + filter + "'; add --nightly to run them");
  std::string groups, last;
  for (const Verification& v : verifications)
    if (v.group() != last) groups += " " + (last = v.group());
  return BadInput("--filter: no check matches '" + filter +
                  "'; give a part of a name group/case/quantity; the groups are" + groups);
}

/// The verifications that have a check whose name matches the filter. A verification without listed names is selected,
/// too, because only its run shows which names the list lacks. @throws BadInput if no verification matches
std::vector<const Verification*> selected(std::span<const Verification> verifications, const CheckNames& names,
                                          const ReportOptions& options) {
  const std::regex filter = expression(options.filter);
  std::vector<const Verification*> found;
  bool only_nightly = false;
  for (const Verification& v : verifications) {
    const std::vector<std::string> own = names_of(names, v);
    const bool fits =
        own.empty() || std::any_of(own.begin(), own.end(), [&](const auto& n) { return std::regex_search(n, filter); });
    if (!fits) continue;
    if (v.when == When::nightly && !options.nightly)
      only_nightly = true;
    else
      found.push_back(&v);
  }
  if (found.empty()) throw nothing_fits(verifications, options.filter, only_nightly);
  return found;
}

/// Names that are in the list but did not run, and names that ran but are not in the list.
std::vector<std::string> differing_names(const std::vector<std::string>& listed, const std::vector<Check>& checks) {
  std::set<std::string> ran;
  for (const Check& check : checks) ran.insert(check.name);
  const std::set<std::string> known(listed.begin(), listed.end());
  std::vector<std::string> differing;
  std::set_symmetric_difference(ran.begin(), ran.end(), known.begin(), known.end(), std::back_inserter(differing));
  return differing;
}

struct GroupTotal {
  std::string name;
  int checks = 0, failed = 0;
  double seconds = 0;
};

void print_head() {
  std::printf("%-4s %-52s %-9s %14s %14s %9s %9s  %s\n", "", "check", "precision", "measured", "reference", "error",
              "tolerance", "source");
}

void print(const Check& c) {
  std::printf("%-4s %-52s %-9s %14.8g %14.8g %9.2g %9.2g  %s\n", c.pass() ? "ok" : "FAIL", c.name.c_str(),
              c.precision.c_str(), c.measured, c.reference, c.error, c.tolerance, c.source.c_str());
  std::fflush(stdout);
}

void print(const std::vector<GroupTotal>& groups) {
  GroupTotal all{"all"};
  std::printf("\n%-12s %7s %7s %9s\n", "group", "checks", "failed", "seconds");
  const auto row = [](const GroupTotal& g) {
    std::printf("%-12s %7d %7d %9.1f\n", g.name.c_str(), g.checks, g.failed, g.seconds);
  };
  for (const GroupTotal& g : groups) {
    row(g);
    all.checks += g.checks;
    all.failed += g.failed;
    all.seconds += g.seconds;
  }
  row(all);
}

nlohmann::json to_json(const Check& c) {
  return {{"name", c.name},   {"precision", c.precision}, {"measured", c.measured}, {"reference", c.reference},
          {"error", c.error}, {"tolerance", c.tolerance}, {"pass", c.pass()},       {"source", c.source}};
}

nlohmann::json to_json(const GroupTotal& g) {
  return {{"name", g.name}, {"checks", g.checks}, {"failed", g.failed}, {"seconds", g.seconds}};
}

/// Prints each check as a line as soon as it has run, or all checks as JSON at the end. Adds up the totals of the
/// groups.
class Printer {
 public:
  explicit Printer(bool json) : json_(json) {
    if (!json_) print_head();
  }

  void add(const std::string& group, const std::vector<Check>& checks, double seconds) {
    if (groups_.empty() || groups_.back().name != group) groups_.push_back({group});
    groups_.back().seconds += seconds;
    for (const Check& check : checks) {
      ++groups_.back().checks;
      if (!check.pass()) ++groups_.back().failed;
      if (json_)
        checks_.push_back(to_json(check));
      else
        print(check);
    }
  }

  /// @return whether all checks passed
  bool finish() const {
    if (json_) {
      nlohmann::json totals = nlohmann::json::array();
      for (const GroupTotal& g : groups_) totals.push_back(to_json(g));
      std::cout << nlohmann::json{{"checks", checks_}, {"groups", totals}}.dump(2) << "\n";
    } else {
      print(groups_);
    }
    return std::all_of(groups_.begin(), groups_.end(), [](const GroupTotal& g) { return g.failed == 0; });
  }

 private:
  bool json_;
  nlohmann::json checks_ = nlohmann::json::array();
  std::vector<GroupTotal> groups_;
};

}  // namespace

bool report(std::span<const Verification> verifications, const CheckNames& names, const ReportOptions& options) {
  using Clock = std::chrono::steady_clock;
  const std::vector<const Verification*> chosen = selected(verifications, names, options);
  const std::regex filter = expression(options.filter);
  Printer printer(options.json);
  std::string differing;
  for (const Verification* verification : chosen) {
    const Clock::time_point begin = Clock::now();
    std::vector<Check> checks = run(*verification);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    for (const std::string& name : differing_names(names_of(names, *verification), checks)) differing += " " + name;
    std::erase_if(checks, [&](const Check& check) { return !std::regex_search(check.name, filter); });
    printer.add(verification->group(), checks, seconds);
  }
  const bool passed = printer.finish();
  if (!differing.empty())
    throw std::logic_error("app/verify/names.txt and the checks that ran differ in" + differing +
                           "; run scripts/verify_names.py to rewrite the list");
  return passed;
}

}  // namespace gyro::verify
