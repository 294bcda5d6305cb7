// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/results.hpp"

#include "app/sweep/results_files.hpp"
#include "app/sweep/results_text.hpp"
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

PointResult point(const std::string& css, std::uint64_t seed, PointState state, double power, double p80) {
  return {.name = "css-" + css + "_seed-" + std::to_string(seed),
          .setting = "css-" + css,
          .values = {css},
          .si = {css == "90mm" ? "0.09" : "0.12"},
          .seed = seed,
          .state = state,
          .figures = {power, p80}};
}

/// Two settings: three points done, and one that a guard has stopped.
SweepResults some_results() {
  SweepResults results;
  results.keys = {{"contacts.a/b.css", "css", "m", "gap"}};
  results.figures = {{"mean_crushing_power", "W", "power"}, {"p80", "m", "size"}};
  results.points = {point("90mm", 1, PointState::done, 1000, 0.1), point("90mm", 2, PointState::done, 2000, 0.3),
                    point("120mm", 1, PointState::done, 500, missing),
                    point("120mm", 2, PointState::stopped, 9000, 0.2)};
  return results;
}

}  // namespace

TEST_CASE("Mean and standard error of independent values are s / sqrt(n)") {
  const Estimate estimate = mean_of({1, 2, 3, 4});
  CHECK(estimate.value == Approx(2.5));
  CHECK(estimate.error == Approx(std::sqrt(5.0 / 3.0 / 4.0)));
  CHECK(std::isnan(mean_of({1}).error));
  CHECK(std::isnan(mean_of({}).value));
}

TEST_CASE("Settings are compared by the points that are done") {
  const std::vector<SettingResult> settings = by_setting(some_results());
  REQUIRE(settings.size() == 2);
  CHECK(settings[0].setting == "css-90mm");
  CHECK(settings[0].seeds == std::vector<std::uint64_t>{1, 2});
  CHECK(settings[0].figures[0].value == Approx(1500));
  CHECK(settings[0].figures[0].error == Approx(500));
  CHECK(settings[1].points == 2);
  CHECK(settings[1].seeds == std::vector<std::uint64_t>{1});
  CHECK(settings[1].figures[0].value == Approx(500));
  CHECK(std::isnan(settings[1].figures[1].value));
  const std::string text = results_text(some_results());
  CHECK_THAT(text, Contains("of whole runs") && Contains("css") && Contains("1.50 +- 0.50") && Contains("1/2"));
}

TEST_CASE("The results of a sweep are a row a point in results.csv, and have units in results.h5") {
  const SweepResults results = some_results();
  CHECK(results_csv(results) ==
        "name,contacts.a/b.css,seed,status,mean_crushing_power,p80\n"
        "css-90mm_seed-1,0.09,1,done,1000,0.1\n"
        "css-90mm_seed-2,0.09,2,done,2000,0.3\n"
        "css-120mm_seed-1,0.12,1,done,500,\n"
        "css-120mm_seed-2,0.12,2,stopped,9000,0.2\n");
  const Workplace place;
  write_results_h5(results, place.path() / "results.h5");
  CHECK(place.listing() == std::vector<std::string>{"results.h5"});
  const hdf5::File file = hdf5::File::open_closed(place.path() / "results.h5");
  CHECK(file.string_attribute("/points/p80", "units") == "m");
  CHECK(file.string_attribute("/points/p80", "description") == "size");
  CHECK(file.dataset("/points/contacts.a-b.css").read() == std::vector<double>{0.09, 0.09, 0.12, 0.12});
  CHECK(file.read_strings("/points/status").back() == "stopped");
  CHECK(file.dataset("/settings/done").read() == std::vector<double>{2, 1});
  CHECK(file.dataset("/settings/mean/mean_crushing_power").read() == std::vector<double>{1500, 500});
  CHECK(file.dataset("/settings/standard_error/mean_crushing_power").read().front() == Approx(500));
}

TEST_CASE("Cells of a CSV file are quoted where they need it") {
  CHECK(csv_line({"a", "b,c", "d\"e", ""}) == "a,\"b,c\",\"d\"\"e\",\n");
}
