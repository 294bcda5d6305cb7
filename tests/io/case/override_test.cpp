// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/case.hpp"
#include "io/schema/schema.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

namespace {

const std::string quickstart = GYRO_CASES "/quickstart.yaml";

/// All problems of a case with overrides, one per line.
std::string problems(const std::vector<std::string>& overrides) {
  std::string all;
  for (const gyro::CaseProblem& problem : gyro::load_case(quickstart, overrides).problems)
    all += to_string(problem) + "\n";
  return all;
}

gyro::Case load(const std::vector<std::string>& overrides) {
  INFO(problems(overrides));
  const gyro::CaseReport report = gyro::load_case(quickstart, overrides);
  REQUIRE(report.loaded);
  return *report.loaded;
}

}  // namespace

TEST_CASE("Overrides replace, add and remove keys") {
  CHECK(load({"time.duration=20 ms"}).time.duration == 0.02);
  CHECK(load({"time.duration=1", "time.duration=2"}).time.duration == 2);  // the last one counts
  CHECK(load({"contacts.rock/rock.friction=0.9"}).contacts.at(0).properties.friction == 0.9);
  CHECK(load({"gravity=[0, 0, -1.62]"}).gravity.z == -1.62);
  CHECK(load({"case.seed=7"}).identity.seed == 7);
  CHECK(load({"case.title='a = b: c'"}).identity.title == "a = b: c");
  CHECK(load({"coupling.interval=1 ms"}).coupling_interval == 1e-3);  // a section that the file does not have
  CHECK(load({"time.step=3 us"}).time.step == 3e-6);
  CHECK(!load({"drivetrain=null"}).drivetrain);
  CHECK(!load({"bonds.strength_scatter=null"}).bonds->scatter);
  CHECK(std::get<gyro::AbsoluteBondRadius>(load({"bonds.radius={absolute: 2 mm}"}).bonds->rule.radius).radius == 0.002);
}

TEST_CASE("Rocks and bonds can be given in forms that the quickstart does not use") {
  const gyro::Case range = load({"rocks.fill={sizes: [8 mm, 45 mm]}"});
  const auto& fill = std::get<gyro::RangeFill>(range.rocks->fill);
  CHECK(fill.smallest == 0.008);
  CHECK(fill.largest == 0.045);
  CHECK(fill.exponent == 0.8);
  CHECK(resolved_yaml(range).find("exponent: 0.8") != std::string::npos);
  CHECK(resolved_yaml(load({})).find("exponent") == std::string::npos);
  CHECK(std::get<gyro::RangeFill>(load({"rocks.fill={sizes: [8 mm, 45 mm], exponent: 0.5}"}).rocks->fill).exponent ==
        0.5);
  CHECK(std::get<gyro::ContactAreaBond>(load({"bonds.radius={area: 0.25}"}).bonds->rule.radius).factor == 0.25);
  const auto scatter = [](const std::string& text) { return *load({"bonds.strength_scatter=" + text}).bonds->scatter; };
  const auto weibull = std::get<gyro::WeibullStrength>(scatter("{distribution: weibull, modulus: 4}"));
  CHECK(weibull.modulus == 4);
  CHECK(weibull.mean == 1);
  const auto literal = std::get<gyro::TruncatedNormal>(scatter("{distribution: paper_literal, range: [0.2, 1.8]}"));
  CHECK(literal.deviation == 1);
  CHECK(literal.upper == 1.8);
  const auto rounded = std::get<gyro::ProceduralShapes>(
      load({"rocks.shapes={procedural: 3, angularity: 0.1, roughness: 0.05, flatness: [0.3, 0.5]}"}).rocks->shapes);
  CHECK(rounded.count == 3);
  CHECK(rounded.style.angularity == 0.1);
  CHECK(rounded.style.roughness == 0.05);
  CHECK(rounded.style.flatness.high == 0.5);
  CHECK(rounded.style.elongation.low == 0.65);
  const auto vendor =
      std::get<gyro::PassingTable>(load({"rocks.sizes={vendor: {feed_opening: 1 m, min: 20 mm}}"}).rocks->sizes);
  CHECK(vendor.points.at(2).size == Approx(0.6));
  CHECK(vendor.points.at(2).fraction == 0.8);
}

TEST_CASE("A floor of particle sizes and rigid rocks") {
  const auto fill = std::get<gyro::MonoFill>(load({"rocks.fill={ratio: 6, floor: 9 mm}"}).rocks->fill);
  CHECK(fill.floor == 0.009);
  CHECK(fill.ratio == 6);
  CHECK(std::get<gyro::MonoFill>(load({}).rocks->fill).floor == 0);
  CHECK_FALSE(load({}).numerics.rigid);
  const auto rigid = *load({"numerics.levels={rigid: rocks, bonded_above: 0.7}"}).numerics.rigid;
  CHECK(rigid.bonded_above == 0.7);
  CHECK(rigid.rigid_below == 0.2);
  CHECK(rigid.calm_time == 0.005);
  CHECK_THAT(problems({"bonds=null", "numerics.levels={rigid: rocks}"}),
             Catch::Matchers::Contains("needs the section bonds"));
  CHECK_FALSE(rigid.pieces);
  CHECK(load({"numerics.levels={rigid: pieces}"}).numerics.rigid->pieces);
}

TEST_CASE("A fidelity stands for levels of detail that a case does not give itself") {
  const auto floor_of = [](const gyro::Case& c) { return std::get<gyro::MonoFill>(c.rocks->fill).floor; };
  const gyro::Case reference = load({"numerics.fidelity=reference", "rocks.fill={ratio: 6}"}),
                   engineering = load({"numerics.fidelity=engineering", "rocks.fill={ratio: 6}"}),
                   survey = load({"numerics.fidelity=survey", "rocks.fill={ratio: 6}"});
  CHECK_FALSE(reference.numerics.rigid);
  CHECK(floor_of(reference) == 0);
  REQUIRE(engineering.numerics.rigid);
  CHECK(engineering.numerics.rigid->pieces);
  CHECK(engineering.numerics.rigid->bonded_above == 0.5);
  CHECK(floor_of(engineering) == 0);
  REQUIRE(survey.numerics.rigid);
  CHECK(floor_of(survey) == Approx(survey.crusher->closed_side_setting / 6));
  const gyro::Case own = load({"numerics.fidelity=survey", "rocks.fill={ratio: 6, floor: 9 mm}",
                               "numerics.levels={rigid: rocks, bonded_above: 0.3}"});
  CHECK(floor_of(own) == 0.009);
  CHECK_FALSE(own.numerics.rigid->pieces);
  CHECK(own.numerics.rigid->bonded_above == 0.3);
  CHECK(load({"numerics.fidelity=engineering", "numerics.levels=null"}).numerics.rigid);
  CHECK_FALSE(load({"numerics.fidelity=engineering", "numerics.levels={rigid: off}"}).numerics.rigid);
  CHECK(problems({"numerics.fidelity=engineering", "bonds=null"}).find("levels") == std::string::npos);
  CHECK(problems({"numerics.fidelity=fast"}).find("reference, engineering or survey") != std::string::npos);
}

TEST_CASE("Keys that exclude each other and values out of range are refused") {
  const auto refused = [](const std::string& override, const std::string& reason) {
    CAPTURE(override, problems({override}));
    CHECK(problems({override}).find(reason) != std::string::npos);
  };
  refused("rocks.fill={ratio: 6, exponent: 0.8}", "rocks.fill.exponent cannot be combined with rocks.fill.ratio");
  refused("rocks.shapes={procedural: 3, corners: 40}",
          "rocks.shapes.corners cannot be combined with rocks.shapes.procedural");
  refused("rocks.shapes={procedural: 3, roughness: 2}", "between 0 and 0.3");
  refused("rocks.fill={sizes: [8 mm, 45 mm], floor: 9 mm}",
          "rocks.fill.floor cannot be combined with rocks.fill.sizes");
  refused("rocks.fill={ratio: 6, floor: 0 mm}", "out of range");
  refused("numerics.levels={rigid: all}", "off, rocks or pieces");
  refused("numerics.levels={rigid: off, calm_time: 2 ms}", "calm_time");
  refused("numerics.levels={rigid: rocks, bonded_above: 0.2}", "rigid_below is not below bonded_above");
  refused("rocks.fill={sizes: [45 mm, 8 mm]}", "does not rise");
  refused("contacts.rock/rock={friction: 0.5, restitution: 0.2, rolling: spring_dashpot}",
          "give rolling_friction above 0");
  refused("output.sieves=[2 mm, 5 mm, 5 mm]", "output.sieves does not rise here");
  refused("output.sieves=[2 mm]", "give a list of at least two values, each larger than the one before");
  refused("output.fines={}",
          "output.fines gives none of its alternatives; give exactly one of: breakage, or gates_gau");
  refused("output.fines={breakage: {A: 60 %, b: 9 t/kWh}, gates_gaudin_schuhmann: {m: 1}}", "exclude each other");
  refused("output.fines={breakage: {A: 64.5, b: 9 t/kWh}}", "output.fines.breakage.A = 64.5 is out of range");
  refused("output.fines={breakage: {A: 64.5 %, b: 10.5}}", "output.fines.breakage.b = 10.5 is out of range");
  refused("output.fines={breakage: {A: 64.5 %, b: 10.5 kWh}}", "give a mass per energy in one of the units kg/J");
  refused("output.fines={breakage: {A: 64.5 %}}", "required key \"b\" is missing");
  refused("output.fines={breakage: {A: 64.5 %, b: 9 t/kWh, released_share: 0}}", "released_share = 0 is out of range");
  refused("output.fines={gates_gaudin_schuhmann: {m: 0}}", "output.fines.gates_gaudin_schuhmann.m = 0 is out of range");
  refused("rocks.fill={ratio: 1}", "between 2 and 50");
  refused("bonds.strength_scatter={distribution: weibull, modulus: 4, range: [0.4, 1.6]}", "range does not belong to");
  refused("bonds.strength_scatter={distribution: weibull}", "required key \"modulus\" is missing");
  refused("bonds.strength_scatter={distribution: truncated_normal, range: [0.4, 1.6]}", "\"deviation\" is missing");
  refused("bonds.strength_scatter={distribution: paper_literal, range: [1.2, 1.6]}", "is not inside the range");
  refused("rocks.sizes={vendor: {feed_opening: 1 m, min: 200 mm}}", "below 0.1 of feed_opening");
}

TEST_CASE("The law of fines is read with its units") {
  CHECK_FALSE(load({}).output.fines);
  const gyro::CaseOutput output = load({"output.fines={breakage: {A: 64.5 %, b: 10.5 t/kWh}}"}).output;
  const auto ore = std::get<gyro::BreakageFines>(*output.fines);
  CHECK(ore.A == 0.645);
  CHECK(ore.b == 10.5 / 3600);
  CHECK(ore.released_share == 1);
  const auto tail =
      std::get<gyro::SchuhmannFines>(*load({"output.fines={gates_gaudin_schuhmann: {m: 0.8}}"}).output.fines);
  CHECK(tail.m == 0.8);
}

TEST_CASE("Problems of overrides are reported with the number and column of the override") {
  CHECK(problems({"time.duration=1 s", "time.duration=5 kg"})
            .starts_with("--set:2:15: time.duration: \"5 kg\" is a mass; "));
  CHECK(problems({"time.duraton=5 s"})
            .starts_with("--set:1:1: unknown key \"duraton\" in time; did you mean \"duration\"?"));
  CHECK(problems({"time.duration"}).starts_with("--set:1:1: \"time.duration\" is not an override; write key.path="));
  CHECK(problems({"time.duration="}).starts_with("--set:1:1: "));
  CHECK(problems({"=3"}).starts_with("--set:1:1: "));
  CHECK(problems({"time..step=3"}).starts_with("--set:1:1: "));
  CHECK(problems({"gravity=[0, 0"}).starts_with("--set:1:9: not valid YAML"));
  CHECK(problems({"numerics.substeps=010"}).starts_with("--set:1:19: numerics.substeps: \"010\" has a leading zero"));
  CHECK(problems({"bonds.radius.absolute=2 mm"}).find("give exactly one of") != std::string::npos);
  CHECK(problems({"time=null"}).find(":1:1: required key \"time\" is missing; ") != std::string::npos);
  CHECK(problems({"bnods=null"}).starts_with("--set:1:1: unknown key \"bnods\"; did you mean \"bonds\"?"));
}

TEST_CASE("Problems of the file and of overrides are reported together, those of the file first") {
  const gyro::CaseReport report =
      gyro::load_case(GYRO_CASE_TESTS "/broken/misspelt-key.yaml", {"time.duration=5 kg", "case.seed=x"});
  REQUIRE(report.problems.size() == 3);
  CHECK(report.problems[0].file != "--set");
  CHECK(report.problems[1].line == 1);
  CHECK(report.problems[2].line == 2);
}

TEST_CASE("The failure criterion of bonds is read with its friction angle") {
  const gyro::Case constant = load({"bonds.failure=constant"});
  CHECK(constant.bonds->model.failure == gyro::BondFailure::constant);
  CHECK(constant.bonds->parameters.internal_friction == 0);
  const gyro::Case mohr = load({"bonds.failure=mohr_coulomb", "bonds.friction_angle=30 deg"});
  CHECK(mohr.bonds->model.failure == gyro::BondFailure::mohr_coulomb);
  CHECK(mohr.bonds->parameters.internal_friction == Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
  CHECK(mohr.bonds->parameters.shear_strength == constant.bonds->parameters.shear_strength);
  CHECK(load({"bonds.failure=mohr_coulomb", "bonds.friction_angle=0"}).bonds->parameters.internal_friction == 0);
  CHECK(problems({"bonds.failure=mohr_coulomb"}).find("required key \"friction_angle\" is missing in bonds") !=
        std::string::npos);
  CHECK(problems({"bonds.friction_angle=30 deg"}).find("it belongs to failure: mohr_coulomb") != std::string::npos);
}

TEST_CASE("Every number of the bond law has the name of its key, or is computed") {
  // Numbers with the name of a key are read without code of their own. These are computed from other keys.
  const std::vector<std::string> computed = {"normal_modulus", "shear_modulus", "internal_friction"};
  gyro::BondParameters numbers;
  gyro::BondParameters::for_each_field(
      [&](const char* name, double&) {
        INFO(name);
        const bool is_key = gyro::find_key("bonds." + std::string(name)) != nullptr;
        CHECK(is_key != (std::find(computed.begin(), computed.end(), name) != computed.end()));
      },
      numbers);
}
