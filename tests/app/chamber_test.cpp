// SPDX-License-Identifier: GPL-3.0-or-later
// Particles leave the chamber only through its ends, and none is too fast.
#include "app/assembly/assembly.hpp"
#include "app/simulation/device.hpp"
#include "core/scene/wall_motion.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace gyro;

/// Radius of a liner at a height, straight between the rows; less than 0 above and below them.
double radius_at(const std::vector<LinerRow>& rows, double LinerRow::*radius, double z) {
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (z < rows[k - 1].z || z > rows[k].z) continue;
    const double t = (z - rows[k - 1].z) / (rows[k].z - rows[k - 1].z);
    return (1 - t) * rows[k - 1].*radius + t * rows[k].*radius;
  }
  return -1;
}

/// Smallest distance of a particle's centre to the liners, in radii, and the largest speed.
struct Survey {
  double room = 1e300, speed = 0;
  std::size_t seen = 0;

  void look(const Assembly& assembly, const Dem& dem) {
    const std::vector<LinerRow>& rows = assembly.liners->rows;
    const WallPose mantle = dem.wall_poses()[static_cast<std::size_t>(gyrating_wall(assembly.setup.scene))];
    const ParticleSnapshot particles = dem.particles();
    for (std::size_t k = 0; k < particles.size(); ++k) {
      speed = std::max(speed, norm(particles.velocity[k]));
      const Vec3d x = particles.position[k], y = to_body(mantle, x);
      const double outer = radius_at(rows, &LinerRow::concave_radius, x.z),
                   inner = radius_at(rows, &LinerRow::mantle_radius, y.z);
      if (outer > 0) room = std::min(room, (outer - std::hypot(x.x, x.y)) / particles.radius[k]);
      if (inner > 0) room = std::min(room, (std::hypot(y.x, y.y) - inner) / particles.radius[k]);
      seen += outer > 0 && inner > 0;
    }
  }
};

Survey survey(const std::string& file, double duration) {
  const Case input = load_case(file).loaded.value();
  const Assembly assembly = assemble(input);
  const std::unique_ptr<Simulation> made =
      make_simulation(input, assembly.setup, make_dem(Device{}, assembly.setup.scene, Precision::mixed));
  Simulation& run = *made;
  Survey survey;
  survey.look(assembly, run.dem());
  for (int k = 1; run.time() < duration; ++k) {
    run.advance();
    if (k % 2 != 0) continue;
    run.inspect();
    survey.look(assembly, run.dem());
  }
  CHECK(run.mass_count().residual() == 0);
  return survey;
}

}  // namespace

// The level distance to a cone is never less than the distance to it, and contacts of this rock are pressed
// in by less than 0.3 R: a centre less than 0.6 R away from a liner has leaked.
TEST_CASE("Rock that is crushed stays between mantle and concave") {
  const Survey seen = survey(GYRO_APP_CASES "/crush.yaml", 0.06);
  CHECK(seen.seen > 10000);
  CHECK(seen.room > 0.6);
  CHECK(seen.room < 1.2);  // some particles touch the liners
  CHECK(seen.speed < 12);
}

TEST_CASE("The quickstart's rock stays between mantle and concave") {
  const Survey seen = survey(GYRO_CASES "/quickstart.yaml", 0.015);
  CHECK(seen.seen > 10000);
  CHECK(seen.room > 0.6);
  CHECK(seen.speed < 12);
}
