// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/progress.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace gyro;
using Catch::Matchers::Contains;
using Form = ProgressStyle::Form;

namespace {

/// Progress of a run at constant speed with a clock that the test sets. @returns the text that was shown
std::string run_shown(ProgressStyle style, double duration, double wall_seconds, int updates) {
  std::ostringstream out;
  double now = 100;
  Progress progress({}, duration, style, out, [&] { return now; });
  ProgressState state;
  for (int k = 1; k <= updates; ++k) {
    const double share = static_cast<double>(k) / updates;
    now = 100 + wall_seconds * share;
    state.time = duration * share;
    state.particle_steps = static_cast<std::int64_t>(1e9 * share);
    state.particles = 1234;
    progress.update(state);
  }
  progress.finish(state);
  return out.str();
}

std::ptrdiff_t lines_in(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

TEST_CASE("Plain lines are shown every 2 percent or 10 seconds, without control characters") {
  const std::string minutes = run_shown({Form::lines}, 2.0, 100, 10000);
  CHECK(lines_in(minutes) >= 48);
  CHECK(lines_in(minutes) <= 51);
  CHECK_THAT(minutes, !Contains("\033") && !Contains("\r"));
  CHECK_THAT(minutes, Contains("10 M particle-steps/s, 1234 particles"));
  CHECK(lines_in(run_shown({Form::lines}, 2.0, 3, 10000)) <= 4);         // few lines for a short run
  CHECK(lines_in(run_shown({Form::lines}, 2.0, 43200, 1000000)) < 400);  // and for a run of 12 hours
  CHECK(run_shown({Form::silent}, 2.0, 100, 1000).empty());
}

TEST_CASE("The time left of a resumed run is computed from the speed of this process") {
  std::ostringstream out;
  double now = 0;
  // The run is resumed at half of its time: the percentage is of the whole run, the rates are those of this process.
  Progress progress({.time = 1, .particle_steps = 7'000'000'000}, 2, {Form::lines}, out, [&] { return now; });
  now = 50;
  progress.update({.time = 1.25, .particle_steps = 7'050'000'000, .particles = 10});
  CHECK_THAT(out.str(), Contains("62.5 %") && Contains("2 min 30 s left") && Contains("1 M particle-steps/s"));
}

TEST_CASE("The time left follows a change of speed") {
  std::ostringstream out;
  double now = 0;
  Progress progress({}, 10, {Form::lines}, out, [&] { return now; });
  ProgressState state;
  while (state.time < 5) {
    now += 1;
    state.time += 0.1;
    progress.update(state);
  }
  while (state.time < 6) {  // ten times slower: 400 s are left at the end
    now += 1;
    state.time += 0.01;
    progress.update(state);
  }
  const std::string text = out.str();
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  CHECK_THAT(last, Contains("6 min"));
}

TEST_CASE("A live line rewrites itself and fits the terminal") {
  for (const bool colour : {false, true}) {
    const std::string text = run_shown({Form::live, colour, 60}, 2.0, 100, 1000);
    CHECK(lines_in(text) == 1);
    CHECK((text.find("\033[36m") != std::string::npos) == colour);
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, '\r');) {
      // Counts characters, not bytes, without the control sequences of colours.
      int width = 0;
      for (std::size_t k = 0; k < part.size(); ++k) {
        if (part[k] == '\033') {
          k = part.find_first_of("mK", k);
        } else if ((part[k] & 0xC0) != 0x80 && part[k] != '\n') {
          ++width;
        }
      }
      CHECK(width < 60);
    }
  }
}

TEST_CASE("Progress shows only quantities that the scene has") {
  const auto last = [](const ProgressState& state) {
    std::ostringstream out;
    double now = 0;
    Progress progress({}, 1, {Form::lines}, out, [&] { return now; });
    now = 20;
    progress.update(state);
    return out.str();
  };
  const std::string plain = last({.time = 0.5});
  CHECK_THAT(plain, !Contains("bonds") && !Contains("rpm") && !Contains("kW"));
  const std::string full =
      last({.time = 0.5, .bonds_broken = 12, .eccentric_speed = 16.7552, .crushing_power = 123456});
  CHECK_THAT(full, Contains("12 bonds broken, 160.0 rpm, 123.5 kW"));
}

TEST_CASE("Progress is plain and without colour unless standard error is a terminal") {
  // Under ctest standard error is not a terminal; if it is one, the form is live.
  const ProgressStyle style = ProgressStyle::for_stderr(false);
  CHECK((style.form == Form::live || !style.colour));
  CHECK(ProgressStyle::for_stderr(true).form == Form::silent);
  ::setenv("NO_COLOR", "1", 1);
  CHECK_FALSE(ProgressStyle::for_stderr(false).colour);
  ::unsetenv("NO_COLOR");
}

TEST_CASE("Progress for programs is one JSON object a line, with null for what is unknown or not in the scene") {
  std::istringstream lines(run_shown({Form::json}, 2.0, 100, 1000));
  std::vector<nlohmann::json> objects;
  for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
  REQUIRE(objects.size() > 40);
  CHECK(objects[20]["end"] == 2.0);
  CHECK(objects[20]["fraction"].get<double>() == Approx(objects[20]["time"].get<double>() / 2));
  CHECK(objects[20]["seconds_left"].get<double>() + objects[20]["wall_seconds"].get<double>() == Approx(100));
  CHECK(objects[20]["particles"] == 1234);
  CHECK(objects[20]["bonds_broken"].is_null());
  CHECK(objects[20]["crushing_power"].is_null());
  CHECK(objects.back()["fraction"] == 1.0);
  CHECK(objects.back()["seconds_left"] == 0.0);
}

TEST_CASE("Durations and counts are printed in a readable form") {
  CHECK(format_duration(0.44) == "0.4 s");
  CHECK(format_duration(9.96) == "10 s");
  CHECK(format_duration(59.7) == "1 min 00 s");
  CHECK(format_duration(725) == "12 min 05 s");
  CHECK(format_duration(12000) == "3 h 20 min");
  CHECK(format_duration(4 * 86400 + 6 * 3600) == "4 d 06 h");
  CHECK(format_duration(-1) == "?");
  CHECK(format_duration(std::numeric_limits<double>::infinity()) == "?");
  CHECK(format_count(0) == "0");
  CHECK(format_count(999.7) == "1 k");
  CHECK(format_count(12345678) == "12.3 M");
}
