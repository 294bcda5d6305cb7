// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/report.hpp"

#include "core/base/errors.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <regex>

namespace gyro::verify {
namespace {

std::regex expression(const std::string& text) {
  try {
    return std::regex(text, std::regex::ECMAScript | std::regex::icase);
  } catch (const std::regex_error& problem) {
    throw BadInput("--filter: '" + text + "' is no regular expression (" + problem.what() +
                   "); accepted is one as in ECMAScript, searched in group/case/quantity");
  }
}

std::string group_of(const Case& verification) {
  return verification.name.substr(0, verification.name.find('/'));
}

/// Cases run whole. A filter that names groups, as in `bond/`, runs the cases of these groups only.
bool may_hold(const std::string& filter, const Case& verification, std::span<const Case> all) {
  bool names_groups = false;
  for (const Case& other : all) {
    const std::string group = group_of(other);
    if (filter.find(group + "/") == std::string::npos) continue;
    if (group_of(verification) == group) return true;
    names_groups = true;
  }
  return !names_groups;
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

int report(std::span<const Case> cases, const VerifyArguments& arguments) {
  using Clock = std::chrono::steady_clock;
  const std::regex wanted = expression(arguments.filter);
  nlohmann::json checks = nlohmann::json::array();
  std::vector<GroupTotal> groups;
  int count = 0, failed = 0;
  if (!arguments.json) print_head();
  for (const Case& verification : cases) {
    const bool skipped = verification.when == Case::When::nightly && !arguments.nightly;
    if (skipped || !may_hold(arguments.filter, verification, cases)) continue;
    if (groups.empty() || groups.back().name != group_of(verification)) groups.push_back({group_of(verification)});
    GroupTotal& group = groups.back();
    const Clock::time_point begin = Clock::now();
    for (const Check& check : run(verification)) {
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
  for (const GroupTotal& g : groups) {
    count += g.checks;
    failed += g.failed;
  }
  if (count == 0) throw BadInput("--filter: no check is called '" + arguments.filter + "'; `gyrosim verify` lists all");
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
