// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/yaml/units.hpp"

#include "io/schema/schema.hpp"
#include "tests/catch.hpp"

#include <charconv>
#include <set>

using gyro::Dimension;
using gyro::parse_integer;
using gyro::parse_quantity;

namespace {

struct Example {
  const char* text;
  Dimension dimension;
  double si;
};

}  // namespace

TEST_CASE("Quantities are converted to SI") {
  // Factors by definition: inch 25.4 mm, pound 0.45359237 kg, hp 745.69987158227 W (BIPM/NIST SP 811).
  const Example example = GENERATE(values<Example>({
      {"12", Dimension::length, 12},
      {"120 mm", Dimension::length, 0.12},
      {"21.7 mm", Dimension::length, 0.0217},
      {"62 in", Dimension::length, 1.5748},
      {"1 ft", Dimension::length, 0.3048},
      {"3um", Dimension::length, 3e-6},
      {"2 t", Dimension::mass, 2000},
      {"3.5 kg", Dimension::mass, 3.5},
      {"1 lb", Dimension::mass, 0.45359237},
      {"0.5 us", Dimension::time, 0.5e-6},
      {"0.5 \u00b5s", Dimension::time, 0.5e-6},
      {"5 min", Dimension::time, 300},
      {"2 h", Dimension::time, 7200},
      {"180 deg", Dimension::angle, 3.14159265358979323846},
      {"160 rpm", Dimension::angular_speed, 16.755160819145563},
      {"1 rev/s", Dimension::angular_speed, 6.283185307179586},
      {"36 km/h", Dimension::speed, 10},
      {"100 mm/s", Dimension::speed, 0.1},
      {"-9.81 m/s2", Dimension::acceleration, -9.81},
      {"1 g0", Dimension::acceleration, 9.80665},
      {"7.1 MN", Dimension::force, 7.1e6},
      {"21 kN m", Dimension::torque, 21e3},
      {"21 kN*m", Dimension::torque, 21e3},
      {"21 kNm", Dimension::torque, 21e3},
      {"36 MPa", Dimension::pressure, 36e6},
      {"1 psi", Dimension::pressure, 6894.757293168361},
      {"1 bar", Dimension::pressure, 1e5},
      {"1670 GPa/m", Dimension::stiffness_per_area, 1.67e12},
      {"1670 GN/m3", Dimension::stiffness_per_area, 1.67e12},
      {"5 kN/m", Dimension::stiffness, 5e3},
      {"2600 kg/m3", Dimension::density, 2600},
      {"2.6 g/cm3", Dimension::density, 2600},
      {"2.6 t/m^3", Dimension::density, 2600},
      {"3500 t/h", Dimension::mass_flow, 3500 / 3.6},
      {"450 kW", Dimension::power, 450e3},
      {"1 hp", Dimension::power, 745.69987158227},
      {"1 kWh", Dimension::energy, 3.6e6},
      {"50 kg m2", Dimension::inertia, 50},
      {"50 kg m\u00b2", Dimension::inertia, 50},
      {"50 kg*m^2", Dimension::inertia, 50},
      {"3 m2", Dimension::area, 3},
      {"2 l", Dimension::volume, 2e-3},
      {"4 N m s/rad", Dimension::rotational_damping, 4},
      {"5 %", Dimension::number, 0.05},
      {"1e3", Dimension::number, 1e3},
      {"1e-3", Dimension::number, 1e-3},
      {"+.5E+2", Dimension::number, 50},
      {" 0 ", Dimension::number, 0},
      {"1.5e2 mm", Dimension::length, 0.15},
      {"0.0", Dimension::number, 0},
  }));
  CAPTURE(example.text);
  const gyro::ParsedNumber parsed = parse_quantity(example.text, example.dimension);
  REQUIRE(parsed.value);
  CHECK(*parsed.value == Approx(example.si).epsilon(1e-14).margin(0));
}

TEST_CASE("Decimal fractions of SI units are rounded once") {
  CHECK(*parse_quantity("21.7 mm", Dimension::length).value == 0.0217);
  CHECK(*parse_quantity("0.7 us", Dimension::time).value == 0.7e-6);
}

TEST_CASE("A text that is not a quantity of the dimension is refused with what to do") {
  const Example example = GENERATE(values<Example>({
      {"", Dimension::length, 0},         {"mm", Dimension::length, 0},    {"5 kg", Dimension::length, 0},
      {"5 mm", Dimension::number, 0},     {"5 xyz", Dimension::length, 0}, {"5 mm mm", Dimension::length, 0},
      {"5 MM", Dimension::length, 0},     {"nan", Dimension::number, 0},   {".nan", Dimension::number, 0},
      {"inf", Dimension::number, 0},      {"-.inf", Dimension::number, 0}, {"1e999", Dimension::number, 0},
      {"1e308 km", Dimension::length, 0}, {"010", Dimension::number, 0},   {"-010 mm", Dimension::length, 0},
      {"00", Dimension::number, 0},       {"0x10", Dimension::number, 0},  {"0o7", Dimension::number, 0},
      {"1_000", Dimension::number, 0},    {"1,000", Dimension::number, 0}, {"1 2", Dimension::number, 0},
      {"--1", Dimension::number, 0},      {"1e", Dimension::number, 0},    {".", Dimension::number, 0},
      {"true", Dimension::number, 0},     {"5 1", Dimension::length, 0},   {"5 rpm", Dimension::speed, 0},
  }));
  CAPTURE(example.text);
  const gyro::ParsedNumber parsed = parse_quantity(example.text, example.dimension);
  CHECK(!parsed.value);
  CHECK(parsed.problem.find("; ") != std::string::npos);
}

TEST_CASE("Whole numbers are read, and other texts are refused") {
  CHECK(*parse_integer("24").value == 24);
  CHECK(*parse_integer("1e6").value == 1e6);
  CHECK(*parse_integer("-3").value == -3);
  CHECK(*parse_integer("9007199254740991").value == 9007199254740991.0);
  for (const char* text : {"010", "0x18", "2.5", "24 m", "x", ""}) {
    CAPTURE(text);
    CHECK(!parse_integer(text).value);
  }
}

TEST_CASE("Units are unique and every dimension begins with its SI unit") {
  std::set<std::string_view> names;
  std::set<Dimension> seen;
  for (const gyro::Unit& unit : gyro::units()) {
    CAPTURE(unit.name);
    CHECK(names.insert(unit.name).second);
    if (seen.insert(unit.dimension).second) CHECK(unit.factor == 1);
  }
  CHECK(names.size() >= 60);
}

TEST_CASE("Numbers are written in a form that every YAML reader accepts, and read back to the bit") {
  CHECK(gyro::number_text(1e-9) == "1.0e-09");
  CHECK(gyro::number_text(1.67e12) == "1.67e+12");
  CHECK(gyro::number_text(2600) == "2600");
  for (const double x :
       {0.1, 1.0 / 3, 972.2222222222223, 5e-324, 1.7976931348623157e308, 16.755160819145562, 0.0, -2.5e-7}) {
    const std::string text = gyro::number_text(x);
    CAPTURE(text);
    CHECK(*parse_quantity(text, Dimension::number).value == x);
    // PyYAML reads a number with an exponent as text unless it has a point and a sign in the exponent.
    const std::size_t e = text.find('e');
    if (e != std::string::npos) {
      CHECK(text.substr(0, e).find('.') != std::string::npos);
      CHECK((text[e + 1] == '-' || text[e + 1] == '+'));
    }
  }
}
