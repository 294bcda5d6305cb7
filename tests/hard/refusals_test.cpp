// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases that the program must refuse before the first step, or run to the end.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <fstream>

namespace {

using namespace gyro;
using nlohmann::json;

const std::string platen = "'" GYRO_APP_CASES "/platen.yaml'";

const std::string materials = R"(
materials:
  rock:  {density: 2600 kg/m3, shear_modulus: 557 MPa, poisson_ratio: 0.35}
  steel: {density: 7800 kg/m3, shear_modulus: 70 GPa, poisson_ratio: 0.30}
contacts:
  rock/rock:  {friction: 0.5, restitution: 0.2}
  rock/steel: {friction: 0.5, restitution: 0.25}
)";
const std::string bonds = R"(
bonds: {normal_stiffness: 300 GPa/m, shear_stiffness: 120 GPa/m, tensile_strength: 4.5 MPa, shear_strength: 3 MPa,
        radius: {relative: 0.5}}
)";
const std::string floor_wall = "walls: {floor: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}, material: steel}}\n";

/// A case of spheres from a file. @param rest  more of the case
void write_case(const Workplace& place, const std::string& rest, const std::string& particles) {
  place.write("p.csv", particles);
  place.write("c.yaml",
              "case: {title: hard}\ntime: {duration: 2 ms}\n" + materials + rest + "particles: {file: p.csv}\n");
}

Outcome refused(const Workplace& place, const std::string& arguments = "") {
  const std::vector<std::string> before = place.listing();
  const Outcome check = place.gyrosim("check c.yaml " + arguments),
                run = place.gyrosim("run c.yaml --out refused " + arguments);
  INFO(run.err);
  CHECK(check.code == 2);
  CHECK(run.code == 2);
  CHECK(place.listing() == before);
  return run;
}

json ran(const Workplace& place, const std::string& arguments = "") {
  const Outcome run = place.gyrosim("run c.yaml --out r --overwrite " + arguments);
  INFO(run.err);
  REQUIRE(run.code == 0);
  return summary_of(place.path() / "r");
}

}  // namespace

TEST_CASE("H1 H2 a step above safety x limit is refused with the number, at any damping", "[hard]") {
  const std::string damping = GENERATE(as<std::string>{}, "0", "0.05", "0.2", "0.5");
  const Workplace place;
  const std::string set = " --set bonds.damping=" + damping;
  const Outcome check = place.gyrosim("check " + platen + " --json" + set);
  REQUIRE(check.code == 0);
  const double limit = json::parse(check.out)["time_step_limit"];
  for (const double factor : {0.71, 0.9, 1.1, 2.0}) {
    const Outcome outcome =
        place.gyrosim("run " + platen + set + " --set time.step=" + std::to_string(factor * limit * 1e6) + "us");
    INFO(factor << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("stability limit of") != std::string::npos);
  }
  CHECK(place.listing().empty());
  const auto runs = [&](double factor, const std::string& more) {
    return place
        .gyrosim("run " + platen + set + more +
                 " --until '0.5 ms' --overwrite --out r --set time.step=" + std::to_string(factor * limit * 1e6) + "us")
        .code;
  };
  CHECK(runs(0.69, "") == 0);
  CHECK(runs(0.95, " --set time.safety=1") == 0);  // the user has asked for it
  CHECK(runs(1.05, " --set time.safety=1") == 2);
}

TEST_CASE("H11 a start state with overlaps is refused with the pair and the overlap", "[hard]") {
  const double ratio = GENERATE(0.01, 0.02, 0.05, 0.1, 0.3, 0.5, 1.5), small = GENERATE(1.0, 0.1);
  const Workplace place;
  // Radii 10 mm and `small` times that; the overlap is that share of the smaller one.
  const double r = 0.01, s = small * r, x = r + s - ratio * s;
  const std::string rows =
      "id,x,y,z,r\n4,0,0,0.1,0.01\n9," + std::to_string(x) + "e0,0,0.1," + std::to_string(s) + "\n11,0.1,0,0.5,0.01\n";
  write_case(place, floor_wall, rows);
  const Outcome outcome = refused(place);
  INFO(outcome.err);
  CHECK(outcome.err.find("particles 4 and 9 overlap by") != std::string::npos);
  CHECK(outcome.err.find("m/s") != std::string::npos);
}

TEST_CASE("H11 touching, bonded and settled particles are accepted", "[hard]") {
  const Workplace place;
  write_case(place, floor_wall, "id,x,y,z,r\n1,0,0,0.01,0.01\n2,0.02,0,0.01,0.01\n3,0.04,0,0.0099999,0.01\n");
  CHECK(ran(place)["particles"] == 3);
  place.write("b.csv", "i,j\n1,2\n2,3\n");
  place.write("p.csv", "id,x,y,z,r\n1,0,0,0.01,0.01\n2,0.018,0,0.01,0.01\n3,0.036,0,0.01,0.01\n");
  place.write("c.yaml", "case: {title: hard}\ntime: {duration: 2 ms}\n" + materials + bonds + floor_wall +
                            "particles: {file: p.csv, bonds: b.csv}\n");
  const json summary = ran(place);
  CHECK(summary["bonds_initial"] == 2);
  CHECK(summary["bonds_broken"] == 0);
  // The same rock, one of its pairs without its bond.
  place.write("b.csv", "i,j\n1,2\n");
  CHECK(refused(place).err.find("particles 2 and 3 overlap") != std::string::npos);
}

TEST_CASE("H34 rock that starts in, behind or through a wall is refused", "[hard]") {
  const auto [position, word] = GENERATE(table<std::string, std::string>({
      {"0,0,0.0095", "overlaps wall floor"},
      {"0,0,0.001", "overlaps wall floor"},
      {"0,0,-0.001", "behind wall floor"},
      {"0,0,-0.02", "behind wall floor"},
      {"0,0,-50", "behind wall floor"},
      {"0.195,0,0.5", "overlaps wall plate"},
      {"0.2,0,0.5", "overlaps wall plate"},
      {"0.2085,0,0.5", "overlaps wall plate"},
  }));
  const Workplace place;
  place.write("s.stl",
              "solid s\nfacet\nouter loop\nvertex 0.2 -1 0\nvertex 0.2 1 0\nvertex 0.2 1 2\nendloop\nendfacet\n"
              "facet\nouter loop\nvertex 0.2 -1 0\nvertex 0.2 1 2\nvertex 0.2 -1 2\nendloop\nendfacet\nendsolid s\n");
  write_case(place,
             "walls:\n  floor: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}, material: steel}\n"
             "  plate: {stl: s.stl, material: steel}\n",
             "id,x,y,z,r\n5," + position + ",0.01\n");
  const Outcome outcome = refused(place);
  INFO(outcome.err);
  CHECK(outcome.err.find("particle 5") != std::string::npos);
  CHECK(outcome.err.find(word) != std::string::npos);
}

TEST_CASE("H34 H10 rock behind a liner is refused", "[hard]") {
  const std::string position = GENERATE(as<std::string>{}, "0.05,0,0.1", "0.16,0,0.1", "0.134,0,0.05");
  const Workplace place;
  write_case(place,
             "crusher: {profile: '" GYRO_CASES
             "/quickstart-profile.csv', closed_side_setting: 15 mm, "
             "eccentricity: 2.7125 mm, pivot_height: 525 mm}\n",
             "id,x,y,z,r\n5," + position + ",0.005\n");
  const Outcome outcome = refused(place);
  INFO(outcome.err);
  CHECK(outcome.err.find("particle 5") != std::string::npos);
}

TEST_CASE("H21 damaged meshes are refused, or repaired with a message", "[hard]") {
  const Workplace place;
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c + "\nendloop\nendfacet\n";
  };
  const std::string good = facet("-1 -1 0", "1 -1 0", "1 1 0") + facet("-1 -1 0", "1 1 0", "-1 1 0");
  write_case(place, "walls: {floor: {stl: s.stl, material: steel}}\n",
             "id,x,y,z,r,vx,vy,vz\n5,0.3,0.1,0.0101,0.01,1,0,-1\n");
  const auto with = [&](const std::string& more) { place.write("s.stl", "solid s\n" + good + more + "endsolid s\n"); };
  for (const std::string bad : {"nan", "inf", "1e999", "0x1"}) {
    with(facet("0 0 " + bad, "1 0 1", "0 1 1"));
    CHECK(refused(place).err.find("s.stl") != std::string::npos);
  }
  place.write("s.stl", "solid s\n" + good.substr(0, good.size() / 2));
  CHECK(refused(place).err.find("truncated") != std::string::npos);
  place.write("s.stl", "solid s\n" + facet("0 0 0", "0 0 0", "1 1 1") + "endsolid s\n");
  CHECK(refused(place).err.find("no triangle has an area") != std::string::npos);

  const std::string step = "--set time.step=1us";  // an impact within 1e-4 of its energy
  with("");
  ran(place, step);
  const std::vector<double> clean = result_of(place.path() / "r", "series/wall_force_floor");
  // Repeats, one of them turned over, a flat one, a T-junction and a sliver of 1:1e6.
  with(facet("-1 -1 0", "1 -1 0", "1 1 0") + facet("1 1 0", "-1 -1 0", "-1 1 0") + facet("0 0 0", "0 0 0", "1 1 0") +
       facet("-1 -1 0", "0 -1 0", "0.2 0.1 0") + facet("-0.9 0.1 0", "0.9 0.1 0", "0.9 0.1000018 0"));
  ran(place, step);
  const std::vector<double> mended = result_of(place.path() / "r", "series/wall_force_floor");
  const std::string log = read_text(place.path() / "r/log.txt");
  CHECK(log.find("1 triangle without area dropped") != std::string::npos);
  CHECK(log.find("2 repeated triangles dropped") != std::string::npos);
  REQUIRE(mended.size() == clean.size());
  double largest = 0, error = 0;
  for (std::size_t k = 0; k < clean.size(); ++k) {
    largest = std::max(largest, std::abs(clean[k]));
    error = std::max(error, std::abs(clean[k] - mended[k]));
  }
  REQUIRE(largest > 1);
  CHECK(error < 1e-6 * largest);
}

TEST_CASE("H26 scenes without particles, or with one, run", "[hard]") {
  const Workplace place;
  const std::string rest = GENERATE_COPY(as<std::string>{}, "", floor_wall, bonds, bonds + floor_wall);
  write_case(place, rest, "id,x,y,z,r\n1,0,0,0.02,0.01\n");
  json summary = ran(place);
  CHECK(summary["particles"] == 1);
  CHECK(summary["energy_residual_fraction"].get<double>() < 1e-6);
  CHECK(place.gyrosim("check c.yaml").code == 0);
  place.write("p.csv", "id,x,y,z,r\n");
  const Outcome none = place.gyrosim("run c.yaml --out none");
  INFO(none.err);
  CHECK((none.code == 0 || none.code == 2));
  if (none.code == 0) CHECK(summary_of(place.path() / "none")["particles"] == 0);
}

TEST_CASE("H26 one triangle is a wall", "[hard]") {
  const Workplace place;
  place.write("s.stl",
              "solid s\nfacet\nouter loop\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  write_case(place, "walls: {floor: {stl: s.stl, material: steel}}\n",
             "id,x,y,z,r,vx,vy,vz\n1,0,0,0.0101,0.01,0,0,-1\n2,5,5,0.0101,0.01,0,0,-1\n");
  CHECK(ran(place)["particles"] == 2);
  const std::vector<double> force = result_of(place.path() / "r", "series/wall_force_floor");
  double lowest = 0;
  for (const double f : force) lowest = std::min(lowest, f);
  CHECK(lowest < -1);
}

TEST_CASE("H27 spheres at one point are refused immediately, and an outlier at 1 km is allowed", "[hard]") {
  const Workplace place;
  std::string rows = "id,x,y,z,r\n";
  for (int k = 0; k < 20000; ++k) rows += std::to_string(k) + ",0.1,0.2,0.3,0.01\n";
  write_case(place, floor_wall, rows);
  CHECK(refused(place).err.find("particles 0 and 1 overlap") != std::string::npos);
  place.write("p.csv", "id,x,y,z,r\n1,0,0,0.02,0.01\n2,1000,-1000,1000,0.01\n3,0.03,0,0.02,0.01\n");
  CHECK(ran(place)["particles"] == 3);
}

TEST_CASE("H6 a belt too fast for the given step is refused, and the automatic step is short enough for it", "[hard]") {
  const Workplace place;
  place.write("s.stl",
              "solid s\nfacet\nouter loop\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  const auto belt = [&](const std::string& motion) {
    write_case(place, "walls: {belt: {stl: s.stl, material: steel, motion: " + motion + "}}\n",
               "id,x,y,z,r\n1,0,0,0.02,0.01\n");
  };
  belt("{linear: [0, 1000 m/s, 0]}");
  CHECK(refused(place, "--set time.step=3us").err.find("motion of wall belt") != std::string::npos);
  const Outcome check = place.gyrosim("check c.yaml --json");
  REQUIRE(check.code == 0);
  CHECK(json::parse(check.out)["time_step"].get<double>() <= 0.2 * 0.01 / 1000);
  CHECK(json::parse(check.out)["limited_by"] == "motion of wall belt");
  belt("{linear: [0, 3 m/s, 0]}");
  CHECK(ran(place, "--set time.step=3us")["time_step"].get<double>() == Approx(3e-6).epsilon(0.01));
}
