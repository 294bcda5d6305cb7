// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that exceed memory or ids are refused within about a second, before rock is placed or a directory made.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <chrono>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

const std::string quickstart = "'" GYRO_CASES "/quickstart.yaml'";
const std::string no_passing = " --set rocks.sizes.passing=null";

/// The shortest time of a few calls, because other programs may use the machine.
struct Timed {
  Outcome outcome;
  double seconds = 1e300;
};
Timed timed(const Workplace& place, const std::string& arguments, double enough) {
  Timed best;
  for (int attempt = 0; attempt < 3 && best.seconds > enough; ++attempt) {
    const auto begin = std::chrono::steady_clock::now();
    best.outcome = place.gyrosim(arguments);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    best.seconds = std::min(best.seconds, passed.count());
  }
  return best;
}

void check_refused(const Workplace& place, const std::string& options, const std::string& reason) {
  INFO(options);
  for (const std::string command : {"check ", "run --out made "}) {
    const Timed call = timed(place, command + quickstart + options, 5);
    CHECK(call.outcome.code == 2);
    CHECK_THAT(call.outcome.err, Contains(reason));
    CHECK(call.seconds < 5);
  }
  CHECK(!std::filesystem::exists(place.path() / "made"));
}

}  // namespace

TEST_CASE("The whole grading of a plant and sizes in metres are refused with the count") {
  const Workplace place;
  place.write("plant.csv", "size_mm,passing_percent\n0.05,0\n0.075,5\n10,40\n60,100\n");
  place.write("metres.csv", "size_mm,passing_percent\n0.03,0\n0.06,100\n");
  const std::string sieves = no_passing + " --set rocks.sizes.sieves=\"$PWD\"/";
  check_refused(place, sieves + "plant.csv", "particles and");
  check_refused(place, sieves + "metres.csv", "(rocks of 0.03");
  check_refused(place, " --set feed.initial=1e300", "more than 2e9 particles");
  check_refused(place, " --set feed.initial=null --set feed.initial_top=null --set feed.rate='1e9 t/h'",
                "the feed adds more than");
}

TEST_CASE("Absurd times are refused with the count of steps") {
  const Workplace place;
  check_refused(place, " --set time.duration='1e300 s'", "steps, more than 1e15");
  check_refused(place, " --set output=null --set coupling.interval='1e6 s'", "more than 1e9 steps");
}

TEST_CASE("check counts a million rocks without placing all of them") {
  const Workplace place;
  place.write(
      "case.yaml",
      "time: {duration: 1 ms}\n"
      "materials:\n  rock: {density: 2600, shear_modulus: 1e8, poisson_ratio: 0.3}\n"
      "contacts:\n  rock/rock: {friction: 0.5, restitution: 0.5}\n"
      "walls: {floor: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}, material: rock}}\n"
      "bonds: {modulus: 1e8, stiffness_ratio: 2, tensile_strength: 1e6, shear_strength: 1e6, radius: {relative: "
      "0.5}}\n"
      "rocks: {shapes: {procedural: 1}, sizes: {passing: [[30 mm, 0], [31 mm, 1]]}, fill: {ratio: 3}, samples: 1}\n"
      "feed: {rocks: 200000, at: [0, 0, 1]}\n");
  const Timed call = timed(place, "check case.yaml --json", 20);
  INFO(call.outcome.err);
  REQUIRE(call.outcome.code == 0);
  const nlohmann::json found = nlohmann::json::parse(call.outcome.out);
  CHECK(found["placed"] == false);
  CHECK(found["particles"].get<double>() > 1e6);
  CHECK(call.seconds < 20);
  CHECK(nlohmann::json::parse(place.gyrosim("check case.yaml --json --set feed.rocks=2").out)["placed"] == true);
}

TEST_CASE("check estimates the time of a large batch from the rock that its trial has seen") {
  const Workplace place;
  const std::string batch = " --set feed.initial=null --set feed.initial_top=null --set feed.start='0.1 s'";
  const auto found = [&](const std::string& mass) {
    const Outcome outcome = place.gyrosim("check " + quickstart + batch + " --json --set feed.mass='" + mass + "'");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return nlohmann::json::parse(outcome.out);
  };
  const nlohmann::json small = found("60 kg"), large = found("600 kg");
  CHECK(small["placed"] == true);
  CHECK(large["placed"] == false);
  const double ratio = large["estimated_seconds"].get<double>() / small["estimated_seconds"].get<double>();
  CHECK(ratio > 2);  // 10 on a quiet machine
  CHECK(ratio < 50);
}

TEST_CASE("check tries a run on the threads that it is given") {
  const Workplace place;
  const std::string thread_count =
      "& most=0; for k in $(seq 40); do n=$(ls /proc/$!/task 2>/dev/null | wc -l); "
      "[ $n -gt $most ] && most=$n; sleep 0.1; done; wait $! && echo $most";
  for (const std::string threads : {"1", "3"})
    CHECK(place.shell("$GYROSIM check '" GYRO_CASES "/box.yaml' --threads " + threads + " >checked " + thread_count)
              .out == threads + "\n");
}

TEST_CASE("Absurd lengths, tiny restitutions and impossible names are refused with the reason") {
  const Workplace place;
  place.write("profile.csv", "z_m,mantle_radius_m,concave_radius_m\n0,0.1,1e9\n0.4,0.05,1e9\n");
  check_refused(place, " --set crusher.profile=\"$PWD\"/profile.csv", "more than 100 m");
  check_refused(place, " --set crusher.pivot_height='1e9 m'", "is more than 1 km; check the unit");
  check_refused(place, " --set contacts.rock/rock.restitution=3e-13", "must be between 0.001 and 1");
  const std::string longest(300, 'x');
  for (const std::string command : {"run ", "liners ", "library "}) {
    const Outcome named = place.gyrosim(command + quickstart + " --out " + longest);
    CHECK(named.code == 2);
    CHECK_THAT(named.err, Contains("a part of the name has 300 bytes; give at most 255"));
  }
  CHECK(place.gyrosim("run " + quickstart + " --out " + std::string(5000, '/')).code == 2);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool much_address_space = true;  // sanitizers reserve terabytes
#else
constexpr bool much_address_space = false;
#endif

TEST_CASE("A case that exceeds ulimit -v is refused with this limit") {
  const Workplace place;
  const Outcome unlimited = place.gyrosim("check '" GYRO_CASES "/box.yaml' --json");
  REQUIRE(unlimited.code == 0);
  const nlohmann::json free = nlohmann::json::parse(unlimited.out)["bytes_free"];
  if (much_address_space || (free.is_number() && free < 1.5e9)) {
    WARN("not tested: a sanitizer, or less than 1.5 GB of free memory, which would be the smaller limit");
    return;
  }
  const Outcome outcome =
      place.shell("ulimit -v 1000000; $GYROSIM check " + quickstart + " --set feed.initial='400 t'");
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.err, Contains("ulimit -v"));
}

TEST_CASE("check says the most memory that a feed by rate can need, with the bonds of what is fed") {
  const Workplace place;
  const std::string call = "check " + quickstart + " --set feed.rate='1 kg/s' --set time.duration='1000 s'";
  const Outcome outcome = place.gyrosim(call + " --json");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json found = nlohmann::json::parse(outcome.out);
  CHECK(found["bytes_free"] > 0);
  const double start = found["particles"], fed = found["particles_at_end"].get<double>() - start;
  const double bytes_at_start = found["bytes_at_start"], bytes_fed = found["bytes"].get<double>() - bytes_at_start;
  CHECK(fed > 1e5);
  CHECK(bytes_fed / fed == Approx(bytes_at_start / start).epsilon(0.05));
  CHECK_THAT(place.gyrosim(call).out, Contains(" if all the feed finds room and nothing is discharged, "));
}
