// SPDX-License-Identifier: GPL-3.0-or-later
// run --until steady: ends once throughput, power and P80 are known, at the same time for any threads and parts.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// Loose rock takes hardly any power, so that its error is large; throughput and P80 are known to some percent at once.
const std::string crusher = "run '" GYRO_APP_CASES "/steady.yaml' --set 'time.duration=20 s' --quiet ";

void require_same(const fs::path& a, const fs::path& b) {
  const auto one = all_results(a), other = all_results(b);
  REQUIRE(one.size() == other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(one[k].first);
    CHECK(one[k] == other[k]);
  }
  const nlohmann::json first = summary_of(a), second = summary_of(b);
  for (const auto& [key, value] : first.items()) {
    INFO(key);
    if (key != "wall_seconds" && key != "threads") CHECK(second[key] == value);
  }
}

}  // namespace

TEST_CASE("A run until steady ends when its figures are known, alike for two threads and in parts") {
  const Workplace place;
  const std::string run = crusher + "--until steady=30% ";
  const Outcome outcome = place.gyrosim(run + "--out whole");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json summary = summary_of(place.path() / "whole"), steady = summary["steady"];
  CHECK(summary["status"] == "done");
  CHECK_THAT(summary["reason"].get<std::string>(), Contains("known to 30 %: throughput ") && Contains("P80 "));
  const double end = summary["simulated_seconds"];
  CHECK(end < 15);
  CHECK(steady["gyrations"] >= 20);
  double worst = 0;
  for (const std::string figure : {"throughput_tph", "crushing_power", "p80"})
    worst = std::max(worst, steady[figure + "_error"].get<double>() / steady[figure].get<double>());
  CHECK(worst <= 0.30);
  CHECK(std::abs(steady["throughput_tph"].get<double>() - 3.6) < 4 * steady["throughput_tph_error"].get<double>());
  const std::string log = read_text(place.path() / "whole/log.txt");
  CHECK_THAT(log, Contains("standard errors: throughput ") && Contains("the run ends at 30 %"));

  REQUIRE(place.gyrosim(run + "--out two --threads 2").code == 0);
  require_same(place.path() / "whole", place.path() / "two");
  const std::string before = std::to_string(0.4 * end);
  REQUIRE(place.gyrosim(crusher + "--out parts --until " + before).code == 0);
  REQUIRE(place.gyrosim(run + "--out parts --resume --threads 2").code == 0);
  require_same(place.path() / "whole", place.path() / "parts");
  // Resumed with an error that is reached already, the run ends at once; with a smaller error it continues.
  REQUIRE(place.gyrosim(run + "--out parts --resume").code == 0);
  require_same(place.path() / "whole", place.path() / "parts");
  REQUIRE(place.gyrosim(crusher + "--until steady=26% --out parts --resume").code == 0);
  CHECK(summary_of(place.path() / "parts")["simulated_seconds"] > end);
}

TEST_CASE("A run until steady that is killed and resumed ends at the same time as a whole one") {
  const Workplace place;
  const std::string run = crusher + "--until steady=30% --set 'output.checkpoints=50 ms' ";
  REQUIRE(place.gyrosim(run + "--out whole").code == 0);
  int kills = 0, code = 137;
  for (; kills < 50 && code != 0; ++kills)
    code = place.gyrosim_with_signal(run + "--out parts --resume", "KILL", 0.4 + 0.4 * kills).code;
  CHECK(code == 0);
  CHECK(kills > 2);
  require_same(place.path() / "whole", place.path() / "parts");
}

TEST_CASE("time.duration remains the end of a run until steady, which then says what is missing") {
  const Workplace place;
  const std::string run = "run '" GYRO_APP_CASES "/steady.yaml' --quiet --out r --until steady ";
  const Outcome early = place.gyrosim(run + "--set 'time.duration=0.8 s'");
  CHECK(early.code == 0);
  CHECK_THAT(early.err, Contains("time.duration is over before the figures are known to 5 %: the run is too short"));
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "done");
  CHECK(summary["simulated_seconds"].get<double>() == Approx(0.8).epsilon(1e-3));
  CHECK_THAT(summary["reason"].get<std::string>(), Contains("time.duration is over"));
}

TEST_CASE("A run until steady is refused without a crusher, and with an error that is none") {
  const Workplace place;
  const Outcome box = place.gyrosim("run '" GYRO_CASES "/box.yaml' --until steady --out r");
  CHECK(box.code == 2);
  CHECK_THAT(box.err, Contains("box.yaml:") && Contains("the case has no crusher"));
  const Outcome still = place.gyrosim(crusher + "--until steady --set drivetrain=null --out r");
  CHECK(still.code == 2);
  CHECK_THAT(still.err, Contains("the case has no drivetrain"));
  for (const std::string end : {"steady=0", "steady=150%", "steady=", "steady5%", "steady=2s"}) {
    INFO(end);
    const Outcome wrong = place.gyrosim(crusher + "--until " + end + " --out r");
    CHECK(wrong.code == 2);
    CHECK_THAT(wrong.err, Contains("is not an end; give a time, steady, or steady=ERROR"));
  }
  CHECK_FALSE(fs::exists(place.path() / "r"));
}
