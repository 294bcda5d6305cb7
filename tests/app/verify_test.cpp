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
  Recorder out("group/case", Precision::double_), mixed("group/case", Precision::mixed);
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

namespace {

VerifyCase one_precision(const std::string& name, void (*run)(Recorder&), VerifyCase::When when) {
  return {name, run, VerifyCase::Precisions::one, when};
}

}  // namespace

TEST_CASE("A failing check gives exit code 3, a bad filter is bad input") {
  const auto right = [](Recorder& r) { r.relative("value", 1, 1, {1e-9, 1e-9}, "test"); };
  const auto wrong = [](Recorder& r) {
    r.relative("value", 2, 1, {1e-9, 1e-9}, "test");
    r.relative("other", 1, 1, {1e-9, 1e-9}, "test");
  };
  using When = VerifyCase::When;
  const std::vector<VerifyCase> cases{one_precision("right/one", right, When::always),
                                      one_precision("wrong/one", wrong, When::always),
                                      one_precision("slow/one", wrong, When::nightly)};
  const verify::Lines lines{{"right/one", {"right/one/value"}},
                            {"wrong/one", {"wrong/one/value", "wrong/one/other"}},
                            {"slow/one", {"slow/one/value", "slow/one/other"}}};
  const auto code = [&](const std::string& filter, bool nightly = false) {
    return verify::report(cases, lines, {.filter = filter, .nightly = nightly});
  };
  CHECK(code("") == exit_check_failed);
  CHECK(code("right/") == exit_done);
  CHECK(code("RIGHT.one") == exit_done);
  CHECK(code("right/|wrong/") == exit_check_failed);
  CHECK(code("wrong/one/other") == exit_done);  // a line of its own
  CHECK(code("g/.*value$") == exit_check_failed);
  CHECK_THROWS_AS(code("slow/"), BadInput);
  CHECK(code("slow/", true) == exit_check_failed);
  CHECK_THROWS_AS(code("nothing"), BadInput);
  CHECK_THROWS_AS(code("("), BadInput);
}

TEST_CASE("A filter that finds nothing is refused before anything runs, with the groups") {
  const auto never = [](Recorder&) { FAIL("ran"); };
  const std::vector<VerifyCase> cases{one_precision("group/case", never, VerifyCase::When::always),
                                      one_precision("other/long", never, VerifyCase::When::nightly)};
  const verify::Lines lines{{"group/case", {"group/case/value"}}, {"other/long", {"other/long/value"}}};
  using Catch::Matchers::Message;
  CHECK_THROWS_MATCHES(verify::report(cases, lines, {.filter = "no/such"}), BadInput,
                       Message("--filter: no check is called 'no/such'; give a part of group/case/quantity, "
                               "the groups are group other"));
  CHECK_THROWS_MATCHES(verify::report(cases, lines, {.filter = "other"}), BadInput,
                       Message("--filter: only long checks are called 'other'; --nightly runs them"));
}

TEST_CASE("A case that prints other lines than lines.txt has is an error of the program") {
  const auto value = [](Recorder& r) { r.relative("value", 1, 1, {1, 1}, "test"); };
  const std::vector<VerifyCase> cases{one_precision("group/case", value, VerifyCase::When::always)};
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{}, {"group/case/name"}, {"group/case/value", "group/case/more"}})
    CHECK_THROWS_AS(verify::report(cases, {{"group/case", names}}, {}), std::logic_error);
  CHECK_THROWS_AS(verify::report(cases, {}, {}), std::logic_error);
  CHECK(verify::report(cases, {{"group/case", {"group/case/value"}}}, {}) == exit_done);
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
  for (const auto& [name, lines] : verify::all_lines()) {
    INFO(name);
    CHECK(names.count(name) == 1);
    CHECK(std::set<std::string>(lines.begin(), lines.end()).size() == lines.size());
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
  CHECK(none.err.find("the groups are hertz restitution") != std::string::npos);
  const nlohmann::json line = nlohmann::json::parse(place.gyrosim("verify --json --filter hertz/glass/force").out);
  CHECK(line.at("checks").size() == 2);  // in both precisions
  CHECK(line.at("groups").size() == 1);
}
