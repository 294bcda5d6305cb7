// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/case.hpp"

#include "tests/catch.hpp"

#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace {

namespace fs = std::filesystem;

/// Loads a case that must have no problems; if it has, they are printed with the test.
gyro::Case load(const fs::path& file, const std::vector<std::string>& overrides = {}) {
  const gyro::CaseReport report = gyro::load_case(file, overrides);
  std::string all;
  for (const gyro::CaseProblem& problem : report.problems) all += to_string(problem) + "\n";
  INFO(all);
  REQUIRE(report.problems.empty());
  REQUIRE(report.loaded);
  return *report.loaded;
}

/// A file that is removed when the test ends.
struct TemporaryFile {
  fs::path path;
  explicit TemporaryFile(const std::string& text)
      : path(fs::temp_directory_path() / ("gyro-case-test-" + std::to_string(getpid()) + ".yaml")) {
    std::ofstream(path, std::ios::binary) << text;
  }
  ~TemporaryFile() { fs::remove(path); }
};

const std::string smallest =
    "time: {duration: 2 ms}\nmaterials:\n  rock: {density: 2600, shear_modulus: 1 GPa, poisson_ratio: 0.25}\n";

/// The cases that ship with the program. Files of sweeps are left out, because they are not complete cases.
std::vector<fs::path> shipped_cases() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(GYRO_CASES))
    if (entry.path().extension() == ".yaml" && entry.path().parent_path().filename() != "sweeps")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("Every shipped case loads, and its resolved form reads back to the same case") {
  const std::vector<fs::path> files = shipped_cases();
  REQUIRE(files.size() >= 5);
  for (const fs::path& file : files) {
    INFO(file.string());
    const gyro::Case first = load(file);
    const TemporaryFile resolved(resolved_yaml(first));
    const gyro::Case second = load(resolved.path);
    CHECK(resolved_yaml(second) == resolved_yaml(first));
    CHECK(second.walls.size() == first.walls.size());
    CHECK(second.identity.title == first.identity.title);
    CHECK(second.time.duration == first.time.duration);
  }
}

TEST_CASE("The case of the large machine has the numbers of its file, in SI") {
  const gyro::Case c = load(GYRO_CASES "/mkii-62-75/case.yaml");
  CHECK(c.identity.seed == 42);
  CHECK(!c.time.step);
  REQUIRE(c.materials.size() == 2);
  CHECK(c.materials[0].name == "rock");
  CHECK(c.materials[0].shear_modulus == 557e6);
  REQUIRE(c.bonds);
  CHECK(c.bonds->parameters.normal_stiffness == 1.67e12);
  CHECK(c.bonds->parameters.normal_modulus == 0);
  CHECK(c.bonds->parameters.damping == 0.05);
  CHECK(c.bonds->model == gyro::BondModel{gyro::BondFailure::constant});
  CHECK(std::get<gyro::RelativeBondRadius>(c.bonds->rule.radius).factor == 0.5);
  REQUIRE(c.bonds->scatter);
  CHECK(std::get<gyro::TruncatedNormal>(*c.bonds->scatter).upper == 1.6);
  REQUIRE(c.rocks);
  CHECK(std::get<gyro::ProceduralShapes>(c.rocks->shapes).count == 8);
  CHECK(std::get<gyro::PassingTable>(c.rocks->sizes).points.at(1).size == 0.5);
  CHECK(std::get<gyro::MonoFill>(c.rocks->fill).ratio == 6.0);
  REQUIRE(c.feed);
  CHECK(c.feed->initial == 2000);
  CHECK(c.feed->rate == Approx(3500 / 3.6).epsilon(1e-14));
  CHECK(c.walls.at(static_cast<std::size_t>(c.feed->above)).name == "concave");
  REQUIRE(c.crusher);
  CHECK(c.crusher->eccentricity == 0.0217);
  CHECK(c.crusher->liners.size() == 129);
  REQUIRE(c.walls.size() == 2);  // both from the profile
  CHECK(std::get<gyro::ProfileLiner>(c.walls[1].shape).mantle);
  CHECK(std::get<gyro::GyrationMotion>(c.walls[1].motion).pivot_height == 4.2);
  CHECK(std::holds_alternative<gyro::Fixed>(c.walls[0].motion));
  REQUIRE(c.drivetrain);
  CHECK(std::get<gyro::DroopMotor>(c.drivetrain->motor).synchronous_speed == Approx(20 * std::numbers::pi));
  CHECK(c.drivetrain->effective_inertia() == Approx(5000 + 3.75 * 3.75 * 50));
  // The contact properties of rock on steel, in both orders of the table.
  const std::vector<gyro::PairProperties> pairs = pair_table(c);
  CHECK(pairs.at(1).restitution == 0.25);
  CHECK(pairs.at(2).friction == 0.7);
}

TEST_CASE("The shipped profiles have the dimensions of the machine") {
  const gyro::Case large = load(GYRO_CASES "/mkii-62-75/case.yaml"), small = load(GYRO_CASES "/quickstart.yaml");
  const std::vector<gyro::LinerRow>&a = large.crusher->liners, &b = small.crusher->liners;
  // Mantle 1905 mm, setting + eccentricity at the discharge plane, feed opening 1575 mm.
  CHECK(a.front().mantle_radius == 0.9525);
  CHECK(a.front().concave_radius - a.front().mantle_radius == Approx(0.120 + 0.0217).epsilon(1e-6));
  CHECK(a.back().z == 3.2);
  CHECK(a.back().concave_radius - a.back().mantle_radius == Approx(1.575).epsilon(1e-6));
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    CHECK(std::abs(b[k].concave_radius - a[k].concave_radius / 8) <= 0.6e-6);  // both are written to the micrometre
}

// Stresses / 8 and stiffnesses per area / 1 by Froude's rule, and all of them x 2.
TEST_CASE("The quickstart's rock is twice as strong and as stiff as that of the large machine at 1:8") {
  const gyro::Case large = load(GYRO_CASES "/mkii-62-75/case.yaml"), small = load(GYRO_CASES "/quickstart.yaml");
  const gyro::BondParameters &a = large.bonds->parameters, &b = small.bonds->parameters;
  CHECK(b.normal_stiffness == Approx(2 * a.normal_stiffness));
  CHECK(b.shear_stiffness == Approx(2 * a.shear_stiffness).epsilon(2e-3));  // 667 GPa/m there is rounded
  CHECK(b.tensile_strength == Approx(a.tensile_strength / 4));
  CHECK(b.shear_strength == Approx(a.shear_strength / 4));
  REQUIRE(large.materials[0].name == "rock");
  REQUIRE(small.materials[0].name == "rock");
  CHECK(small.materials[0].shear_modulus == Approx(large.materials[0].shear_modulus / 4).epsilon(2e-3));
}

TEST_CASE("A key that a case leaves out is absent or has its documented default") {
  const TemporaryFile file(smallest);
  const gyro::Case c = load(file.path);
  CHECK(c.identity.seed == 1);
  CHECK(c.identity.title == file.path.stem().string());
  CHECK(c.time.safety == 0.7);
  CHECK(c.coupling_interval == 0.5e-3);
  CHECK(c.gravity.z == -9.81);
  CHECK(c.numerics.precision == gyro::Precision::mixed);
  CHECK(c.output.series == 1e-3);
  CHECK(c.output.snapshots == 20e-3);
  CHECK(c.output.checkpoints == 300);
  CHECK(c.output.vtp);
  CHECK(!c.output.hdf5);
  CHECK((!c.bonds && !c.rocks && !c.feed && !c.crusher && !c.drivetrain && !c.particles));
  CHECK(c.walls.empty());
}

TEST_CASE("A case with a byte-order mark and Windows line ends is read") {
  std::string text = "\xEF\xBB\xBF" + smallest;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  const TemporaryFile file(text);
  CHECK(load(file.path).time.duration == 2e-3);
}

TEST_CASE("A start state is sorted by id, its bonds refer to its rows, and bonded particles form rocks") {
  const std::string data = GYRO_CASE_TESTS "/data/";
  const TemporaryFile file(
      smallest +
      "contacts: {rock/rock: {friction: 0.5, restitution: 0.5}}\n"
      "bonds: {modulus: 5 GPa, stiffness_ratio: 2.5, tensile_strength: 1 MPa, shear_strength: 1 MPa, "
      "radius: {absolute: 2 mm}}\n"
      "particles: {file: " +
      data + "spheres.csv, bonds: " + data + "bonds.csv}\n");
  const gyro::Case c = load(file.path);
  REQUIRE(c.particles);
  const auto& p = c.particles->particles;
  REQUIRE(p.size() == 3);
  CHECK(p[0].id == 1);
  CHECK(p[2].id == 3);
  CHECK(p[2].velocity.z == -1);
  CHECK((p[0].rock == 0 && p[1].rock == 0 && p[2].rock == 1));
  REQUIRE(c.particles->bonds.size() == 1);
  CHECK((c.particles->bonds[0].i == 0 && c.particles->bonds[0].j == 1));
  CHECK(c.particles->bonds[0].length == Approx(0.02).epsilon(1e-12));  // the distance, because no length is given
  CHECK(c.bonds->parameters.normal_modulus == 5e9);
  CHECK(c.bonds->parameters.shear_modulus == 2e9);
  CHECK(c.bonds->parameters.normal_stiffness == 0);
  CHECK(std::get<gyro::AbsoluteBondRadius>(c.bonds->rule.radius).radius == 0.002);
}

TEST_CASE("A start state is read with angular velocities, rocks and probes") {
  const std::string data = GYRO_CASE_TESTS "/data/";
  const TemporaryFile file(smallest +
                           "contacts: {rock/rock: {friction: 0.5, restitution: 0.5}}\n"
                           "particles: {file: " +
                           data + "spinning.csv}\noutput: {probes: [1, 0]}\n");
  const gyro::Case c = load(file.path);
  REQUIRE(c.particles);
  CHECK(norm(c.particles->particles[0].velocity - gyro::Vec3d{1, 2, 3}) == 0);
  CHECK(norm(c.particles->particles[0].angular_velocity - gyro::Vec3d{4, 5, 6}) == 0);
  CHECK(c.particles->particles[1].angular_velocity.z == -7);
  CHECK(c.output.probes == std::vector<std::uint32_t>{1, 0});
  CHECK(c.resolved.find("probes: [1, 0]") != std::string::npos);
}

TEST_CASE("Walls are read with unit normals and with every motion") {
  const std::string walls =
      "walls:\n"
      "  a: {plane: {point: [0, 0, 1], normal: [0, 3, 4]}, material: rock}\n"
      "  b: {plane: {point: [0, 0, 1], normal: [0, 0, 1]}, material: rock, motion: {linear: [0, 0, -10 cm/s]}}\n"
      "  c: {plane: {point: [0, 0, 1], normal: [0, 0, 1]}, material: rock, "
      "motion: {rotation: {axis: [0, 0, 2], point: [0, 0, 0], speed: 60 rpm}}}\n"
      "  d: {plane: {point: [0, 0, 1], normal: [0, 0, 1]}, material: rock, motion: {circular: {radius: 1 cm, period: "
      "50 ms}}}\n";
  const TemporaryFile file(smallest + walls);
  const gyro::Case c = load(file.path);
  CHECK(std::get<gyro::PlaneShape>(c.walls[0].shape).normal.y == Approx(0.6));
  CHECK(std::get<gyro::LinearMotion>(c.walls[1].motion).velocity.z == -0.1);
  CHECK(std::get<gyro::RotationMotion>(c.walls[2].motion).speed == Approx(2 * std::numbers::pi));
  CHECK(std::get<gyro::RotationMotion>(c.walls[2].motion).axis.z == 1);
  CHECK(std::get<gyro::CircularMotion>(c.walls[3].motion).period == 0.05);
}

TEST_CASE("Motor models and size distributions are read") {
  const fs::path large = GYRO_CASES "/mkii-62-75/case.yaml";
  const gyro::Case induction =
      load(large, {"drivetrain.motor={model: induction, rated_power: 450 kW, synchronous_speed: 600 "
                   "rpm, rated_slip: 0.0167, breakdown_ratio: 2.5}"});
  CHECK(std::get<gyro::InductionMotor>(induction.drivetrain->motor).rated_power == 450e3);
  const gyro::Case constant = load(large, {"drivetrain.motor={model: constant_speed, speed: 600 rpm}"});
  CHECK(std::get<gyro::ConstantSpeedMotor>(constant.drivetrain->motor).speed == Approx(62.8318530718));
  const gyro::Case curve = load(large, {"drivetrain.motor={model: curve, file: " GYRO_CASE_TESTS "/data/motor.csv}"});
  CHECK(std::get<gyro::CurveMotor>(curve.drivetrain->motor).torques.front() == 15e3);

  const gyro::Case rosin = load(large, {"rocks.sizes={rosin_rammler: {x63: 200 mm, m: 0.9, min: 50 mm, max: 500 mm}}"});
  CHECK(std::get<gyro::RosinRammler>(rosin.rocks->sizes).smallest == 0.05);
  const gyro::Case gates = load(large, {"rocks.sizes={gates_gaudin_schuhmann: {xmax: 500 mm, m: 0.8, min: 50 mm}}"});
  CHECK(std::get<gyro::GatesGaudinSchuhmann>(gates.rocks->sizes).exponent == 0.8);
  const gyro::Case sieves = load(large, {"rocks.sizes={sieves: " GYRO_CASE_TESTS "/data/sieves.csv}"});
  CHECK(std::get<gyro::PassingTable>(sieves.rocks->sizes).points.at(1).size == 0.1);
  CHECK(std::get<gyro::PassingTable>(sieves.rocks->sizes).points.at(1).fraction == 0.25);
}

TEST_CASE("A drivetrain with all its sections is read") {
  const gyro::Case made =
      load(GYRO_CASES "/mkii-62-75/no-load.yaml",
           {"drivetrain.motor=null",
            "drivetrain.motor={model: nema, design: C, rated_power: 450 kW, synchronous_speed: 600 rpm, "
            "voltage_file: " GYRO_CASE_TESTS "/broken/ramp.csv}",
            "drivetrain.mantle_inertia=8 t m2", "drivetrain.coupling_spring={stiffness: 400 kN m, damping: 200}",
            "drivetrain.bearings={bushing_depth: 5.4 m, inner: {friction: 0.006, radius: 330 mm}, "
            "spider: {friction: 0.01, radius: 0.25 m, idle_force: 50 kN}}",
            "drivetrain.protection={overload_time: 60 s, under_speed: 0.5, under_speed_delay: 3 s, "
            "restart_delay: 10 s, restart_sense: reversed}"});
  const gyro::DrivetrainParameters& drive = *made.drivetrain;
  const auto& motor = std::get<gyro::DoubleCageMotor>(drive.motor);
  CHECK(motor.torque(0) == Approx(2.25 * motor.rated_torque()));
  CHECK(drive.voltage.at(0) == 0.4);
  CHECK(drive.voltage.at(2.5) == Approx(0.7));
  CHECK(drive.voltage.at(50) == 1);
  CHECK(drive.mantle_inertia == 8000);
  CHECK(drive.spring.stiffness == 4e5);
  CHECK(drive.spring.damping == 200);
  CHECK(drive.bearings.depth == 5.4);
  CHECK(drive.bearings.inner.radius == Approx(0.33));
  CHECK(drive.bearings.outer.friction == 0);
  CHECK(drive.bearings.spider.idle_force == 50e3);
  CHECK(drive.bearings.tilt_sine == Approx(0.0217 / 4.2));
  CHECK(drive.protection.overload_time == 60);
  CHECK(drive.protection.overload_ratio == 1.05);
  CHECK(drive.protection.instantaneous_ratio == 0);
  CHECK(drive.protection.restart_reversed);
}
