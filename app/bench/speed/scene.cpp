// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/scene.hpp"

#include "core/base/errors.hpp"

namespace gyro::bench {

// The clock of S1 and S3 starts when the spheres have come together. F has as much rock as can be placed without
// contacts: 19.2 t of 25 t found room, and the last tonne takes most of the time.
std::span<const SpeedScene> speed_scenes() {
  static const std::vector<SpeedScene> scenes{
      {.name = "S1",
       .title = "loose spheres fall into a box",
       .file = "bench/s1.yaml",
       .make = loose_spheres,
       .recipe = {.seed = 20241, .particles = usual_particles},
       .warm_up = 2000,
       .timed = 1000},
      {.name = "S2",
       .title = "one bonded block between plates",
       .file = "bench/s2.yaml",
       .make = bonded_cylinder,
       .recipe = {.seed = 20242, .particles = usual_particles},
       .warm_up = 100,
       .timed = 400},
      {.name = "S2r",
       .title = "140 rocks of 136 particles between plates",
       .file = "bench/s2r.yaml",
       .make = bonded_rocks,
       .recipe = {.seed = 20244, .particles = 140 * 136},
       .warm_up = 100,
       .timed = 400},
      {.name = "S3",
       .title = "loose spheres between cones of triangles",
       .file = "bench/s3.yaml",
       .make = spheres_between_cones,
       .recipe = {.seed = 20243, .particles = usual_particles},
       .warm_up = 2000,
       .timed = 1000},
      {.name = "Q", .title = "quickstart", .file = "quickstart.yaml", .warm_up = 158, .timed = 60},
      {.name = "C", .title = "62-75 with 2 t", .file = "mkii-62-75/case.yaml", .warm_up = 1, .timed = 2},
      {.name = "F",
       .title = "62-75 full, 18 t",
       .file = "mkii-62-75/case.yaml",
       .overrides = {"feed.initial=18 t"},
       .warm_up = 1,
       .timed = 1,
       .asked_only = true},
  };
  return scenes;
}

SpeedScene scene_named(const std::string& name) {
  std::string known;
  for (const SpeedScene& scene : speed_scenes()) {
    if (scene.name == name) return scene;
    known += (known.empty() ? "" : ", ") + scene.name;
  }
  throw BadInput("--scene " + name + ": there is no such scene; use one of " + known);
}

}  // namespace gyro::bench
