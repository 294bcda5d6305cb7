// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/points.hpp"

#include "app/sweep/point_names.hpp"
#include "tests/catch.hpp"

#include <set>

namespace {

using namespace gyro;

std::vector<SweepSetting> row(const std::vector<std::pair<std::string, std::string>>& values) {
  std::vector<SweepSetting> settings;
  for (const auto& [key, value] : values) settings.push_back({key, value});
  return settings;
}

/// A grid of two times two values, and two rows of keys that change together.
SweepFile sweep_of_three_axes() {
  SweepFile sweep;
  sweep.axes = {{row({{"a.x", "1"}}), row({{"a.x", "2"}})},
                {row({{"b.y", "3"}}), row({{"b.y", "4"}})},
                {row({{"c", "5"}, {"d", "6"}}), row({{"c", "7"}, {"d", "8"}})}};
  return sweep;
}

std::vector<std::string> names_of(const SweepFile& sweep) {
  std::vector<std::string> names;
  const std::vector<std::string> keys = short_names(varied_keys(sweep), sweep.names);
  for (const SweepPoint& point : expand(sweep))
    names.push_back(point_name(setting_name(keys, point), point.seed ? point.seed->seed : 1));
  return names;
}

}  // namespace

TEST_CASE("A sweep is every combination of its axes and seeds, and keys that change together stay together") {
  SweepFile sweep = sweep_of_three_axes();
  sweep.seeds = {{4}, {9}};
  CHECK(count_points(sweep, 100) == 16);
  CHECK(count_points(sweep, 10) == 11);
  const std::vector<std::string> names = names_of(sweep);
  REQUIRE(names.size() == 16);
  CHECK(names[0] == "x-1_y-3_c-5_d-6_seed-4");
  CHECK(names[1] == "x-1_y-3_c-5_d-6_seed-9");
  CHECK(names[2] == "x-1_y-3_c-7_d-8_seed-4");
  CHECK(names[15] == "x-2_y-4_c-7_d-8_seed-9");
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == 16);
}

TEST_CASE("Settings of all points come before those of a point, and its seed last") {
  SweepFile sweep = sweep_of_three_axes();
  sweep.set = row({{"time.duration", "1 s"}});
  sweep.seeds = {{4}};
  CHECK(overrides_of(settings_of(sweep, expand(sweep).front())) ==
        std::vector<std::string>{"time.duration=1 s", "a.x=1", "b.y=3", "c=5", "d=6", "case.seed=4"});
}

TEST_CASE("Names of points stay when values and seeds are added") {
  SweepFile sweep = sweep_of_three_axes();
  sweep.seeds = {{1}};
  const std::vector<std::string> before = names_of(sweep);
  sweep.axes[0].insert(sweep.axes[0].begin(), row({{"a.x", "0.5"}}));
  sweep.seeds = {{3}, {1}};
  const std::vector<std::string> after = names_of(sweep);
  for (const std::string& name : before) CHECK(std::count(after.begin(), after.end(), name) == 1);
}

TEST_CASE("A short name is the last part of a key, with the parts before it that tell it from others") {
  CHECK(short_names({"crusher.closed_side_setting", "bonds.radius.relative"}, {}) ==
        std::vector<std::string>{"closed_side_setting", "relative"});
  CHECK(short_names({"contacts.rock/rock.friction", "contacts.rock/steel.friction"}, {}) ==
        std::vector<std::string>{"rock-rock.friction", "rock-steel.friction"});
  CHECK(short_names({"crusher.closed_side_setting"}, {{"crusher.closed_side_setting", "css"}}) ==
        std::vector<std::string>{"css"});
}

TEST_CASE("Names of points are safe for shells and file systems, short, and differ for different values") {
  CHECK(value_in_name("90 mm") == "90mm");
  CHECK(value_in_name("-1.5e-3") == "-1.5e-3");
  CHECK(value_in_name("[0, 0, -9.81]") == "0+0+-9.81");
  std::set<std::string> names;
  const std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ.+-_";
  for (const std::string value :
       {"a/b", "a:b", "a\\b", "$(x)", "[1, 2]", "[1, 3]", "[[1], 3]", "..", "", "a*b", "ä", "{a: 1}"}) {
    const std::string name = value_in_name(value);
    INFO(value << " is " << name);
    CHECK(names.insert(name).second);
    CHECK(name.find_first_not_of(letters) == std::string::npos);
  }
  SweepPoint point;
  std::vector<std::string> keys;
  for (int k = 0; k < 50; ++k) {
    point.varied.push_back({"key", std::string(200, 'x')});
    keys.emplace_back("key");
  }
  const std::string name = setting_name(keys, point);
  CHECK(name.size() <= 100);
  point.varied.back().value += "y";
  CHECK(setting_name(keys, point) != name);
}
