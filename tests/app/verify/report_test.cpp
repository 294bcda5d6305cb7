// SPDX-License-Identifier: GPL-3.0-or-later
// The report of `gyrosim verify`: which checks run, pass and are printed.
#include "app/verify/report.hpp"
#include "core/base/errors.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <regex>
#include <set>

using namespace gyro;
using verify::Precisions;
using verify::Recorder;
using verify::Verification;
using verify::When;

TEST_CASE("A check passes within its tolerance, and never if its error is not a number") {
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

Verification in_double(const std::string& name, void (*run)(Recorder&), When when = When::always) {
  return {name, run, Precisions::double_only, when};
}

}  // namespace

TEST_CASE("A report says whether the checks that match its filter have passed") {
  const auto right = [](Recorder& r) { r.relative("value", 1, 1, {1e-9, 1e-9}, "test"); };
  const auto wrong = [](Recorder& r) {
    r.relative("value", 2, 1, {1e-9, 1e-9}, "test");
    r.relative("other", 1, 1, {1e-9, 1e-9}, "test");
  };
  const std::vector<Verification> all{in_double("right/one", right), in_double("wrong/one", wrong),
                                      in_double("slow/one", wrong, When::nightly)};
  const verify::CheckNames names{{"right/one", {"right/one/value"}},
                                 {"wrong/one", {"wrong/one/value", "wrong/one/other"}},
                                 {"slow/one", {"slow/one/value", "slow/one/other"}}};
  const auto passed = [&](const std::string& filter, bool nightly = false) {
    return verify::report(all, names, {.filter = filter, .nightly = nightly});
  };
  CHECK_FALSE(passed(""));
  CHECK(passed("right/"));
  CHECK(passed("RIGHT.one"));
  CHECK_FALSE(passed("right/|wrong/"));
  CHECK(passed("wrong/one/other"));  // one check of its case
  CHECK_FALSE(passed("g/.*value$"));
  CHECK_THROWS_AS(passed("slow/"), BadInput);
  CHECK_FALSE(passed("slow/", true));
  CHECK_THROWS_AS(passed("nothing"), BadInput);
  CHECK_THROWS_AS(passed("("), BadInput);
}

TEST_CASE("A filter that matches no check is refused with the list of groups before any check runs") {
  const auto never = [](Recorder&) { FAIL("ran"); };
  const std::vector<Verification> all{in_double("group/case", never), in_double("other/long", never, When::nightly)};
  const verify::CheckNames names{{"group/case", {"group/case/value"}}, {"other/long", {"other/long/value"}}};
  using Catch::Matchers::Message;
  CHECK_THROWS_MATCHES(verify::report(all, names, {.filter = "no/such"}), BadInput,
                       Message("--filter: no check matches 'no/such'; give a part of a name group/case/quantity; "
                               "the groups are group other"));
  CHECK_THROWS_MATCHES(verify::report(all, names, {.filter = "other"}), BadInput,
                       Message("--filter: only nightly checks match 'other'; add --nightly to run them"));
}

TEST_CASE("Checks whose names are not those in names.txt are an error of the program") {
  const auto value = [](Recorder& r) { r.relative("value", 1, 1, {1, 1}, "test"); };
  const std::vector<Verification> all{in_double("group/case", value)};
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{}, {"group/case/name"}, {"group/case/value", "group/case/more"}})
    CHECK_THROWS_AS(verify::report(all, {{"group/case", names}}, {}), std::logic_error);
  CHECK_THROWS_AS(verify::report(all, {}, {}), std::logic_error);
  CHECK(verify::report(all, {{"group/case", {"group/case/value"}}}, {}));
}

TEST_CASE("Verifications are called group/case, those of a group follow one another, and names.txt has their checks") {
  std::set<std::string> names, groups;
  std::string last;
  for (const Verification& v : verify::all_verifications()) {
    INFO(v.name);
    CHECK(std::regex_match(v.name, std::regex("[a-z]+(-[a-z]+)*/[a-z0-9-]+")));
    CHECK(names.insert(v.name).second);
    if (v.group() != last) CHECK(groups.insert(v.group()).second);
    last = v.group();
  }
  const verify::CheckNames listed = verify::check_names();
  CHECK(listed.size() == names.size());
  for (const auto& [name, checks] : listed) {
    INFO(name);
    CHECK(names.count(name) == 1);
    CHECK(std::set<std::string>(checks.begin(), checks.end()).size() == checks.size());
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
  CHECK(none.err.find("the groups are hertz hysteretic restitution") != std::string::npos);
  const nlohmann::json one = nlohmann::json::parse(place.gyrosim("verify --json --filter hertz/glass/force").out);
  CHECK(one.at("checks").size() == 2);  // in both precisions
  CHECK(one.at("groups").size() == 1);
}
