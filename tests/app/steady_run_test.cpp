// SPDX-License-Identifier: GPL-3.0-or-later
// A run that becomes steady: what its summary says of that, against what is known of the run.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

const std::string steady = "'" GYRO_APP_CASES "/steady.yaml' --out r ";

/// Mean of the hold-up in /series from a time on.
double mean_holdup(const std::filesystem::path& run, double from) {
  const std::vector<double> time = result_of(run, "series/time"), holdup = result_of(run, "series/holdup_mass");
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] > from) sum += holdup[k], ++count;
  return sum / count;
}

}  // namespace

TEST_CASE("A crusher that lets through what is fed becomes steady, with its figures and their standard errors") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("run " + steady);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json summary = summary_of(place.path() / "r"), found = summary["steady"];
  REQUIRE(found.is_object());
  CHECK(summary["not_steady"].is_null());
  CHECK(summary["choked"] == false);
  const double from = found["from"], gyrations = found["gyrations"], period = 60 / 452.5;
  CHECK(from > 0.2);  // the first rocks fall for as long
  CHECK(gyrations >= 10);
  CHECK(gyrations * period == Approx(4 - from).margin(2 * period));
  const double throughput = found["throughput_tph"], error = found["throughput_tph_error"];
  CHECK(std::abs(throughput - 3.6) < 4 * error);  // the feed
  CHECK((error > 0.01 && error < 0.4));
  for (const std::string figure :
       {"crushing_power", "motor_power", "specific_energy_kwh_per_t", "p80", "p50", "product_below_css"}) {
    INFO(figure);
    CHECK(found[figure] > 0);
    CHECK(found[figure + "_error"] > 0);
    CHECK(found[figure + "_error"] < found[figure]);
  }
  CHECK(found["specific_energy_kwh_per_t"].get<double>() ==
        Approx(found["crushing_power"].get<double>() / 1000 / throughput).epsilon(0.02));
  CHECK(found["residence_time"].get<double>() * throughput / 3.6 ==
        Approx(mean_holdup(place.path() / "r", from)).epsilon(0.05));
  CHECK(summary["bonds_initial"] == 0);  // the case has none, though its rocks were made with bonds
  CHECK_THAT(outcome.out, Contains("  steady            since ") && Contains(" +- ") && !Contains("start-up"));
  CHECK(place.gyrosim("report r").out == outcome.out);
}

TEST_CASE("A steady run has P80 and P50 with fines and their errors, in one part or in two") {
  const Workplace place;
  // Weak bonds, so that most rocks break into single particles.
  const std::string run = "run " GYRO_APP_CASES
                          "/steady.yaml --set materials.rock.shear_modulus=30MPa --set time.safety=0.35 --set "
                          "'bonds={normal_stiffness: 300 GPa/m, shear_stiffness: 120 GPa/m, tensile_strength: 1 MPa, "
                          "shear_strength: 0.7 MPa, radius: {relative: 0.5}}' "
                          "--set 'output.fines={gates_gaudin_schuhmann: {m: 0.8}}' --out ";
  REQUIRE(place.gyrosim(run + "whole --until '1.8 s'").code == 0);
  const nlohmann::json found = summary_of(place.path() / "whole")["steady"];
  REQUIRE(found.is_object());
  for (const std::string figure : {"p80", "p50"}) {
    CHECK(found[figure + "_with_fines"] < found[figure]);
    CHECK(found[figure + "_with_fines"] >
          0.42 * found[figure].get<double>());  // median of a tail of m = 0.8 / its size
    CHECK(found[figure + "_with_fines_error"] > 0);
    CHECK(found[figure + "_with_fines_error"] < 0.2 * found[figure].get<double>());
  }
  REQUIRE(place.gyrosim(run + "parts --until '0.9 s'").code == 0);
  REQUIRE(place.gyrosim(run + "parts --until '1.8 s' --resume").code == 0);
  CHECK(summary_of(place.path() / "parts")["steady"] == found);
}

TEST_CASE("The same crusher is not steady while it fills") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("run " + steady + "--until '0.8 s'");
  REQUIRE(outcome.code == 0);
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["steady"].is_null());
  CHECK_THAT(summary["not_steady"].get<std::string>(), Contains("the run is too short"));
  CHECK_THAT(outcome.out, Contains("start-up"));
}
