// SPDX-License-Identifier: GPL-3.0-or-later
// Liners as meshes: written from a profile by one command, used as walls by another case.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

using namespace gyro;

TEST_CASE("Liners written as STL and used as walls crush in the same way as the profile") {
  const Workplace place;
  std::filesystem::copy(GYRO_APP_CASES "/stl.yaml", place.path());
  REQUIRE(place.gyrosim("liners '" GYRO_APP_CASES "/crush.yaml' --out liners").code == 0);
  const Outcome of_profile = place.gyrosim("liners '" GYRO_APP_CASES "/crush.yaml' --out again --json");
  const Outcome of_meshes = place.gyrosim("liners stl.yaml --out set --json");
  INFO(of_meshes.err);
  REQUIRE(of_meshes.code == 0);
  const nlohmann::json p = nlohmann::json::parse(of_profile.out), m = nlohmann::json::parse(of_meshes.out);
  for (const char* length : {"closed_side_setting", "open_side_setting", "throw"})
    CHECK(m[length].get<double>() == Approx(p[length].get<double>()).margin(5e-5));
  CHECK(m["choke_height"].get<double>() == Approx(p["choke_height"].get<double>()).margin(1e-3));
  CHECK(m["volume"].get<double>() == Approx(p["volume"].get<double>()).epsilon(3e-3));
  CHECK(m["capacity_tph"].get<double>() == Approx(p["capacity_tph"].get<double>()).epsilon(3e-3));
  CHECK(m["sides"].size() == 24);
  CHECK(std::filesystem::exists(place.path() / "set/mantle.stl"));

  const Outcome unnamed =
      place.gyrosim("liners stl.yaml --out l --set walls.concave.motion='{linear: [0, 0, 1 mm/s]}'");
  INFO(unnamed.err);
  CHECK(unnamed.code == 2);
  CHECK(unnamed.err.find("fixed and called concave") != std::string::npos);

  const Outcome meshes = place.gyrosim("run stl.yaml --until '8 ms' --out meshes");
  INFO(meshes.err);
  REQUIRE(meshes.code == 0);
  REQUIRE(place.gyrosim("run '" GYRO_APP_CASES "/crush.yaml' --until '8 ms' --out profile").code == 0);

  const nlohmann::json a = summary_of(place.path() / "meshes"), b = summary_of(place.path() / "profile");
  CHECK(a["particles"] == b["particles"]);
  CHECK(a["bonds_initial"] == b["bonds_initial"]);
  // 360 flats a turn cut the arc by 5 um; a mantle at another setting would be off by tenths of a millimetre.
  CHECK(a["mean_crushing_power"].get<double>() == Approx(b["mean_crushing_power"].get<double>()).epsilon(0.1));
  CHECK(std::abs(a["energy_residual_fraction"].get<double>()) < 0.01);
  CHECK(a["mass_residual_fraction"] == 0);
}
