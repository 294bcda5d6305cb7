// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of FMUs: which FMUs are accepted, and how their variables are found.
#include "core/base/errors.hpp"
#include "io/fmu/drive_fmu.hpp"
#include "tests/catch.hpp"
#include "tests/io/fmu/foreign.hpp"
#include "tests/io/run/scratch.hpp"

namespace {

using namespace gyro;
using Catch::Matchers::Contains;

}  // namespace

TEST_CASE("A description is read with the units of variables and of their declared types") {
  const ScratchDirectory place;
  const auto file = place.path() / "foreign.fmu";
  write_foreign_fmu(file);
  const ModelDescription model = read_fmu(file);
  CHECK(model.guid == "foreign-1");
  CHECK(model.identifier == "flywheel");
  CHECK(model.generation_tool == "another program");
  CHECK(model.variable_step);
  CHECK(!model.state);
  const FmuLink speed = link_to(model, FmuQuantity::eccentric_speed, "shaft.w");
  CHECK(speed.factor == Approx(0.10471975511965977).epsilon(1e-15));
  CHECK(speed.reference == 1);
  CHECK(link_to(model, FmuQuantity::mantle_torque, "T_load").factor == 1);
  CHECK(link_to(model, FmuQuantity::mantle_torque, "-T_load").factor == -1);
  CHECK(start_of(model, "J", 0.2).type == VariableType::real);
  CHECK(start_of(model, "sacks", 2).type == VariableType::integer);
}

TEST_CASE("A file that is not an FMI 2.0 co-simulation FMU for this platform is refused with the reason") {
  const auto [part, by, reason] = GENERATE(table<std::string, std::string, std::string>({
      {"fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"", "is of FMI 3.0; FMI 2.0 is needed"},
      {"CoSimulation modelIdentifier", "ModelExchange modelIdentifier", "no CoSimulation"},
      {"guid=\"foreign-1\"", "guid=\"\"", "without guid"},
      {"modelIdentifier=\"flywheel\"", "modelIdentifier=\"other\"",
       "has no binaries/linux64/other.so but binaries for linux64"},
      {"modelIdentifier=\"flywheel\"", "modelIdentifier=\"../flywheel\"", "with a slash"},
      {"valueReference=\"1\"", "", "without valueReference"},
      {"</ModelVariables>", "", "is not XML"},
      {"fmiModelDescription", "somethingElse", "not XML"},
  }));
  const ScratchDirectory place;
  const auto file = place.path() / "foreign.fmu";
  write_foreign_fmu(file, replaced(foreign_description(), part, by));
  CHECK_THROWS_WITH(read_fmu(file), Contains(reason) && Contains("foreign.fmu: "));
  CHECK_THROWS_AS(read_fmu(file), BadInput);
}

TEST_CASE("An FMU with binaries for other platforms only is refused and the platforms are named") {
  const ScratchDirectory place;
  const auto file = place.path() / "foreign.fmu";
  write_foreign_fmu(file, foreign_description(), "binaries/win64/flywheel.dll");
  CHECK_THROWS_WITH(read_fmu(file), Contains("but binaries for win64; an FMU with binaries for linux64"));
}

TEST_CASE("Missing variables and those of a wrong kind or unit are refused with a list of possible ones") {
  const ModelDescription model = read_model_description(foreign_description());
  const auto problem = [&](FmuQuantity quantity, const char* name) {
    try {
      link_to(model, quantity, name);
    } catch (const BadInput& bad) {
      return std::string(bad.what());
    }
    return std::string("accepted");
  };
  using enum FmuQuantity;
  CHECK_THAT(problem(mantle_torque, "T_laod"),
             Contains("did you mean \"T_load\"?") && Contains("inputs of the FMU are T_load"));
  CHECK_THAT(problem(eccentric_speed, "w"), Contains("outputs of the FMU are shaft.w, tau, weight, odd"));
  CHECK_THAT(problem(mantle_torque, "tau"), Contains("is not a real input (Real, output)"));
  CHECK_THAT(problem(motor_torque, "T_load"), Contains("is not a real output"));
  CHECK_THAT(problem(motor_torque, "weight"), Contains("is in \"kg\", which is not a unit of motor_torque"));
  CHECK_THAT(problem(motor_torque, "odd"), Contains("\"furlong\", which its description does not define"));
  CHECK_THROWS_WITH(start_of(model, "j", 1), Contains("parameters of the FMU are J, fail_at, blind_at, sacks"));
  CHECK_THROWS_WITH(start_of(model, "sacks", 1.5), Contains("a whole number"));
  CHECK_THROWS_WITH(start_of(model, "T_load", 1), Contains("has no parameter"));
}
