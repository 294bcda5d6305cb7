// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "app/verify/check.hpp"
#include "core/base/errors.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <regex>

namespace gyro {
namespace {

using verify::Check;

std::regex expression(const std::string& text) {
  try {
    return std::regex(text, std::regex::ECMAScript | std::regex::icase);
  } catch (const std::regex_error& problem) {
    throw BadInput("--filter: '" + text + "' is no regular expression (" + problem.what() +
                   "); accepted is one as in ECMAScript, searched in group/case/quantity");
  }
}

/// Cases run whole. A filter that names groups, as in `bond/`, runs the cases of these groups only.
bool may_hold(const std::string& filter, const std::string& case_name) {
  bool names_groups = false;
  for (const verify::Case& other : verify::all_cases()) {
    const std::string group = other.name.substr(0, other.name.find('/') + 1);
    if (filter.find(group) == std::string::npos) continue;
    if (case_name.rfind(group, 0) == 0) return true;
    names_groups = true;
  }
  return !names_groups;
}

void print_head() {
  std::printf("%-4s %-52s %-6s %14s %14s %9s %9s  %s\n", "", "check", "loads", "measured", "reference", "error",
              "tolerance", "source");
}

void print(const Check& c) {
  std::printf("%-4s %-52s %-6s %14.8g %14.8g %9.2g %9.2g  %s\n", c.pass() ? "ok" : "FAIL", c.name.c_str(),
              c.precision.c_str(), c.measured, c.reference, c.error, c.tolerance, c.source.c_str());
  std::fflush(stdout);
}

nlohmann::json to_json(const Check& c) {
  return {{"name", c.name},   {"precision", c.precision}, {"measured", c.measured}, {"reference", c.reference},
          {"error", c.error}, {"tolerance", c.tolerance}, {"pass", c.pass()},       {"source", c.source}};
}

}  // namespace

int verify_command(const VerifyArguments& arguments) {
  const std::regex wanted = expression(arguments.filter);
  const auto begin = std::chrono::steady_clock::now();
  nlohmann::json all = nlohmann::json::array();
  int count = 0, failed = 0;
  if (!arguments.json) print_head();
  for (const verify::Case& verification : verify::all_cases()) {
    const bool skipped = verification.when == verify::Case::When::nightly && !arguments.nightly;
    if (skipped || !may_hold(arguments.filter, verification.name)) continue;
    for (const Check& check : verify::run(verification)) {
      if (!std::regex_search(check.name, wanted)) continue;
      ++count;
      if (!check.pass()) ++failed;
      if (arguments.json)
        all.push_back(to_json(check));
      else
        print(check);
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (arguments.json)
    std::cout << nlohmann::json{{"checks", all}, {"seconds", seconds.count()}}.dump(2) << "\n";
  else
    std::printf("%d checks, %d failed, %.1f s\n", count, failed, seconds.count());
  if (count == 0) throw BadInput("--filter: no check is called '" + arguments.filter + "'; `gyrosim verify` lists all");
  return failed > 0 ? exit_check_failed : exit_done;
}

}  // namespace gyro
