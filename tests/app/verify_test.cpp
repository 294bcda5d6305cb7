// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of `gyrosim verify`: what passes, what fails, what is printed.
#include "app/verify/report.hpp"
#include "core/base/errors.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <regex>
#include <set>

using namespace gyro;
using VerifyCase = verify::Case;
using verify::Recorder;

TEST_CASE("A check passes within its tolerance and never with what is no number") {
  Recorder out("group/case", Loads::double_), mixed("group/case", Loads::single);
  for (Recorder* r : {&out, &mixed}) {
    r->relative("near", 1.01, 1, {0.005, 0.02}, "test");
    r->absolute("far", 1.01, 1, {0.02, 0.005}, "test");
    r->within("inside", 3, 2, 4, "test");
    r->within("outside", 4.1, 2, 4, "test");
    r->relative("nan", std::nan(""), 1, {1, 1}, "test");
  }
  const auto passes = [](const Recorder& r) {
    std::vector<bool> all;
    for (const verify::Check& c : r.checks()) all.push_back(c.pass());
    return all;
  };
  CHECK(passes(out) == std::vector<bool>{false, true, true, false, false});
  CHECK(passes(mixed) == std::vector<bool>{true, false, true, false, false});
  CHECK(out.checks()[0].name == "group/case/near");
  CHECK(out.checks()[0].precision == "double");
  CHECK(mixed.checks()[0].precision == "mixed");
}

TEST_CASE("A failing check gives exit code 3, a bad filter is bad input") {
  const std::vector<VerifyCase> cases{{"right/one",
                                       [](Recorder& r) {
                                         r.relative("value", 1, 1, {1e-9, 1e-9}, "test");
                                       },
                                       VerifyCase::Precisions::one},
                                      {"wrong/one",
                                       [](Recorder& r) {
                                         r.relative("value", 2, 1, {1e-9, 1e-9}, "test");
                                       },
                                       VerifyCase::Precisions::one},
                                      {"slow/one",
                                       [](Recorder& r) {
                                         r.relative("value", 2, 1, {1e-9, 1e-9}, "test");
                                       },
                                       VerifyCase::Precisions::one, VerifyCase::When::nightly}};
  const auto code = [&](const std::string& filter, bool nightly = false) {
    return verify::report(cases, {.filter = filter, .nightly = nightly});
  };
  CHECK(code("") == exit_check_failed);
  CHECK(code("right/") == exit_done);
  CHECK(code("RIGHT.one") == exit_done);
  CHECK(code("right/|wrong/") == exit_check_failed);
  CHECK_THROWS_AS(code("slow/"), BadInput);
  CHECK(code("slow/", true) == exit_check_failed);
  CHECK_THROWS_AS(code("nothing"), BadInput);
  CHECK_THROWS_AS(code("("), BadInput);
}

TEST_CASE("Names of cases are group/case, the groups are those that are documented, and follow one another") {
  const std::set<std::string> known{"hertz",     "restitution", "oblique",  "spin",      "rolling",
                                    "slip",      "mesh",        "bond",     "beam",      "wave",
                                    "modulus",   "flight",      "energy",   "generic",   "objectivity",
                                    "fragments", "strength",    "coupling", "drivetrain"};
  std::set<std::string> names, groups;
  std::string last;
  for (const VerifyCase& c : verify::all_cases()) {
    INFO(c.name);
    CHECK(std::regex_match(c.name, std::regex("[a-z]+/[a-z0-9-]+")));
    CHECK(names.insert(c.name).second);
    const std::string group = c.name.substr(0, c.name.find('/'));
    CHECK(known.count(group) == 1);
    if (group != last) CHECK(groups.insert(group).second);
    last = group;
  }
}

TEST_CASE("verify --json prints one document and nothing else") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("verify --json --filter hertz/glass");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  const nlohmann::json all = nlohmann::json::parse(outcome.out);
  REQUIRE(all.at("checks").size() >= 4);
  for (const nlohmann::json& c : all["checks"]) {
    for (const char* text : {"name", "precision", "source"}) CHECK(c.at(text).is_string());
    for (const char* number : {"measured", "reference", "error", "tolerance"}) CHECK(c.at(number).is_number());
    CHECK(c.at("pass").is_boolean());
    CHECK(std::regex_match(c["name"].get<std::string>(), std::regex("hertz/glass/[a-z0-9-]+")));
  }
  CHECK(place.listing().empty());
  CHECK(place.gyrosim("verify --json --filter hertz/glass").code == 0);
  const Outcome none = place.gyrosim("verify --json --filter no/such");
  CHECK(none.code == 2);
  CHECK(none.out.empty());
}
