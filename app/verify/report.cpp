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
    throw BadInput("--filter: '" + text + "' is no regular expression (" + problem.what() +
                   "); use the ECMAScript syntax; it is searched in group/case/quantity");
  }
}

std::string group_of(const Case& verification) {
  return verification.name.substr(0, verification.name.find('/'));
}

bool any_matches(const std::vector<std::string>& names, const std::regex& wanted) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& n) { return std::regex_search(n, wanted); });
}

/// None if nobody listed the case.
std::vector<std::string> lines_of(const Lines& lines, const Case& verification) {
  const auto found = lines.find(verification.name);
  return found == lines.end() ? std::vector<std::string>{} : found->second;
}

/// The cases that print a line of that name. One that is not listed runs, and is found out.
std::vector<const Case*> chosen(std::span<const Case> cases, const Lines& lines, const VerifyArguments& arguments) {
  const std::regex wanted = expression(arguments.filter);
  std::vector<const Case*> found;
  bool only_nightly = false;
  for (const Case& c : cases) {
    const std::vector<std::string> names = lines_of(lines, c);
    if (!names.empty() && !any_matches(names, wanted)) continue;
    if (c.when == Case::When::nightly && !arguments.nightly)
      only_nightly = true;
    else
      found.push_back(&c);
  }
  if (!found.empty()) return found;
  std::string groups, last;
  for (const Case& c : cases)
    if (group_of(c) != last) groups += " " + (last = group_of(c));
  throw BadInput("--filter: " + (only_nightly
                                     ? "only long checks are called '" + arguments.filter + "'; --nightly runs them"
                                     : "no check is called '" + arguments.filter +
                                           "'; give a part of group/case/quantity, " + "the groups are" + groups));
}

/// @throws std::logic_error unless a case printed the lines that it is listed with
void require_listed(const std::string& name, const std::vector<std::string>& lines, const std::vector<Check>& checks) {
  std::set<std::string> printed;
  for (const Check& check : checks) printed.insert(check.name);
  const std::set<std::string> listed(lines.begin(), lines.end());
  std::vector<std::string> differ;
  std::set_symmetric_difference(printed.begin(), printed.end(), listed.begin(), listed.end(),
                                std::back_inserter(differ));
  if (differ.empty()) return;
  std::string names;
  for (const std::string& one : differ) names += " " + one;
  throw std::logic_error("app/verify/lines.txt and the lines of " + name + " differ:" + names);
}

/// What became of a group.
struct GroupTotal {
  std::string name;
  int checks = 0, failed = 0;
  double seconds = 0;
};

void print_head() {
  std::printf("%-4s %-52s %-6s %14s %14s %9s %9s  %s\n", "", "check", "loads", "measured", "reference", "error",
              "tolerance", "source");
}

void print(const Check& c) {
  std::printf("%-4s %-52s %-6s %14.8g %14.8g %9.2g %9.2g  %s\n", c.pass() ? "ok" : "FAIL", c.name.c_str(),
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

}  // namespace

int report(std::span<const Case> cases, const Lines& lines, const VerifyArguments& arguments) {
  using Clock = std::chrono::steady_clock;
  const std::vector<const Case*> selected = chosen(cases, lines, arguments);
  const std::regex wanted = expression(arguments.filter);
  nlohmann::json checks = nlohmann::json::array();
  std::vector<GroupTotal> groups;
  int failed = 0;
  if (!arguments.json) print_head();
  for (const Case* one : selected) {
    const Case& verification = *one;
    if (groups.empty() || groups.back().name != group_of(verification)) groups.push_back({group_of(verification)});
    GroupTotal& group = groups.back();
    const Clock::time_point begin = Clock::now();
    const std::vector<Check> all = run(verification);
    require_listed(verification.name, lines_of(lines, verification), all);
    for (const Check& check : all) {
      if (!std::regex_search(check.name, wanted)) continue;
      ++group.checks;
      if (!check.pass()) ++group.failed;
      if (arguments.json)
        checks.push_back(to_json(check));
      else
        print(check);
    }
    group.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }
  for (const GroupTotal& g : groups) failed += g.failed;
  if (arguments.json) {
    nlohmann::json totals = nlohmann::json::array();
    for (const GroupTotal& g : groups) totals.push_back(to_json(g));
    std::cout << nlohmann::json{{"checks", checks}, {"groups", totals}}.dump(2) << "\n";
  } else {
    print(groups);
  }
  return failed > 0 ? exit_check_failed : exit_done;
}

}  // namespace gyro::verify
