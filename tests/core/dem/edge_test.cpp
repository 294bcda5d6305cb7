// SPDX-License-Identifier: GPL-3.0-or-later
// Extreme scenes: empty, one sphere, spheres far away, of many sizes, not finite.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <limits>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// Largest error of the forces of one step against all pairs, relative to the largest force.
double error_of_forces(const Dem& dem, const Material& m) {
  const ParticleSnapshot s = dem.particles();
  const double youngs = youngs_of_pair(m);
  std::vector<Vec3d> force(s.size(), Vec3d{0, 0, 0});
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = i + 1; j < s.size(); ++j) {
      const Vec3d span = s.position[j] - s.position[i];
      const double overlap = s.radius[i] + s.radius[j] - norm(span);
      if (overlap <= 0) continue;
      const double r = s.radius[i] * s.radius[j] / (s.radius[i] + s.radius[j]);
      const Vec3d f = (4.0 / 3 * youngs * std::sqrt(r) * std::pow(overlap, 1.5) / norm(span)) * span;
      force[i] -= f;
      force[j] += f;
    }
  double error = 0, largest = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    error = std::max(error, norm(force[k] - s.force[k]));
    largest = std::max(largest, norm(force[k]));
  }
  REQUIRE(largest > 0);
  return error / largest;
}

/// Error of the forces after a first step of a scene of loose spheres.
double error_of_first_step(const Scene& scene, const std::vector<NewRock>& spheres) {
  const auto dem = make_cpu_dem(scene, Precision::double_, 1);
  dem->insert(spheres);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 1);
  return error_of_forces(*dem, scene.materials[0]);
}

}  // namespace

TEST_CASE("Every contact is found between sizes of 1:60", "[dem][search]") {
  Scene scene = plain_scene(1e-9);
  scene.neighbour_skin = GENERATE(0.0, 0.01);
  std::vector<NewRock> spheres;
  for (ParticleId k = 0; k < 900; ++k) {
    const double radius = k < 6 ? 0.25 : 0.0042 * std::pow(20, 0.5 + 0.5 * random_number(k, 8));
    const Vec3d at = random_vector(k, 0);
    spheres.push_back(sphere(k, k < 6 ? 0.8 * at : at, {0, 0, 0}, radius, 2600));
  }
  CHECK(error_of_first_step(scene, spheres) < 1e-9);
}

TEST_CASE("A sphere a kilometre away does not hide contacts", "[dem][search]") {
  const Scene scene = plain_scene(1e-9);
  std::vector<NewRock> spheres = cloud({{10, 10, 10}, 0.02, 0.0099, 0});
  for (NewRock& s : spheres) s.particles[0].radius = 0.0102;
  spheres.push_back(sphere(5000, {1000, -700, 400}, {0, 0, 0}, 0.01, 2600));
  CHECK(error_of_first_step(scene, spheres) < 1e-9);
}

TEST_CASE("Empty scenes and single spheres run", "[dem][edge]") {
  const bool with_bonds = GENERATE(true, false);
  Scene scene = plain_scene(1e-5);
  scene.gravity = {0, 0, -10};
  if (with_bonds) scene.bonds = paper_bonds();
  if (with_bonds) scene.walls = box({1, 1, 1});
  const auto dem = make_cpu_dem(scene, Precision::mixed, 2);
  std::int64_t step = 0;
  CHECK(dem->energy().residual() == 0);
  run(*dem, scene.dt, step, 100);
  CHECK(dem->counts().particles == 0);
  CHECK(dem->particles().size() == 0);
  CHECK(dem->bonds().size() == 0);
  CHECK(dem->extremes().finite);
  dem->insert({});
  dem->remove({});
  const std::vector<NewRock> one{sphere(7, {0, 0, 0}, {1, 0, 0}, 0.01, 2600)};
  dem->insert(one);
  run(*dem, scene.dt, step, 100);
  const ParticleSnapshot s = dem->particles();
  REQUIRE(s.size() == 1);
  CHECK(s.position[0].x == Approx(1e-3).epsilon(1e-12));
  CHECK(s.position[0].z == Approx(-0.5 * 10 * 1e-6).epsilon(1e-12));
  CHECK(s.velocity[0].z == Approx(-1e-2).epsilon(1e-12));
  const std::vector<ParticleId> leaving{7};
  dem->remove(leaving);
  run(*dem, scene.dt, step, 10);
  CHECK(dem->counts().particles == 0);
  CHECK(std::abs(dem->energy().residual()) < 1e-15);
}

TEST_CASE("A sphere that is not finite is reported and does not touch the others", "[dem][edge]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double bad = GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  Scene scene = plain_scene(1e-5);
  scene.walls = box({0.1, 0.1, 0.1});
  std::vector<NewRock> spheres = cloud({{4, 4, 4}, 0.03, 0.012, 0.5});
  spheres[37].particles[0].velocity.y = bad;
  const auto dem = make_cpu_dem(scene, precision, 1);
  CHECK(dem->extremes().finite);
  dem->insert(spheres);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 300);
  const Extremes x = dem->extremes();
  CHECK_FALSE(x.finite);
  CHECK(x.culprit == 37);
  const ParticleSnapshot s = dem->particles();
  for (std::size_t k = 0; k < s.size(); ++k)
    if (k != 37) CHECK(std::isfinite(norm2(s.position[k]) + norm2(s.velocity[k]) + norm2(s.angular_velocity[k])));
}

TEST_CASE("Spheres that touch to the last bit have no overlap and no energy", "[dem][edge]") {
  // (3, 4, 5): the squared distance rounds below the squared sum of the radii, the distance does not.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = plain_scene(1e-6);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> two{sphere(0, {0, 0, 0}, {0, 0, 0}, 0.005, 2600),
                                 sphere(1, {0.006, 0.008, 0}, {0, 0, 0}, 0.005, 2600)};
  dem->insert(two);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 10);
  CHECK(dem->energy().residual() == 0);
  CHECK(dem->energy().friction == 0);
  CHECK(norm(dem->particles().velocity[0]) == 0);
}
