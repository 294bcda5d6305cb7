// SPDX-License-Identifier: GPL-3.0-or-later
// Which rigid rocks are overloaded, in any orientation.
#include "core/kernels/stress_bound.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <vector>

using namespace gyro;

namespace {

/// A rock of two particles and one bond. In the frame of its table, a force along x on the second particle is tension,
/// one along y shear, and a moment about z bending.
struct TwoParticles {
  LoadTable table{2, 1};
  std::vector<Block> blocks{Block{}};
  std::vector<Body> bodies{Body{}};
  std::vector<float> strength{1};
  std::vector<Load> load{2};
  std::vector<Motion> motion{2};
  std::int32_t overloaded = 0;

  TwoParticles() {
    for (const Index particle : {0, 1}) *table.row(particle).force() = 0.02f, *table.row(particle).moment() = 0.5f;
    *table.row(1).response(0, 0) = 0.01f;  // tension by a force along x
    *table.row(1).response(1, 1) = 0.02f;  // shear by a force along y
    *table.row(1).response(5, 3) = 0.5f;   // bending by a moment about z
    blocks[0].first_particle = 0, blocks[0].end_particle = 2;
    blocks[0].table = 0, blocks[0].table_bonds = 1, blocks[0].rigid = 1;
    bodies[0].orientation = bodies[0].frame = {1, 0, 0, 0};
    for (Motion& m : motion) m = {{0, 0, 0}, 2};
    load.assign(2, Load{});
  }
  bool is_overloaded(double allowed, const Vec3d& gravity = {0, 0, 0}) {
    blocks[0].overloaded = overloaded = 0;
    ParticleView p{};
    p.load = load.data();
    p.motion = motion.data();
    const float* const rows[] = {table.row(0).numbers, table.row(1).numbers};
    const StressBound<float> bound{.rows = rows,
                                   .blocks = blocks.data(),
                                   .bodies = bodies.data(),
                                   .strength = strength.data(),
                                   .allowed = allowed,
                                   .overloaded = &overloaded};
    bound.look(p, gravity, 0);
    CHECK(blocks[0].overloaded == overloaded);
    return overloaded == 1;
  }
};

}  // namespace

TEST_CASE("Tension, shear and bending overload a bond, compression and weight do not", "[levels]") {
  TwoParticles rock;
  rock.load[1].force = {40, 0, 0};  // ratio 0.4
  CHECK(rock.is_overloaded(0.39));
  CHECK_FALSE(rock.is_overloaded(0.41));
  rock.load[1].force = {-40, 0, 0};
  CHECK_FALSE(rock.is_overloaded(0.01));
  rock.load[1].force = {-40, 10, 0};  // shear 0.2
  CHECK(rock.is_overloaded(0.19));
  CHECK_FALSE(rock.is_overloaded(0.21));
  rock.load[1].torque = {0, 0, 2};  // bending 1 less compression 0.4
  CHECK(rock.is_overloaded(0.59));
  CHECK_FALSE(rock.is_overloaded(0.61));
  rock.strength[0] = 2;
  CHECK_FALSE(rock.is_overloaded(0.31));
  CHECK(rock.is_overloaded(0.29));
  rock = TwoParticles();
  const Vec3d gravity{100, 0, 0};
  for (Load& load : rock.load) load.force = 2.0 * gravity;
  CHECK_FALSE(rock.is_overloaded(1e-6, gravity));
}

TEST_CASE("Loads are turned into the frame of the table", "[levels]") {
  TwoParticles rock;
  const Quatd frame = rotation_about({0.6, 0, 0.8}, 1.1), since = rotation_about({0, 0.8, -0.6}, -0.7);
  rock.bodies[0].frame = frame;
  rock.bodies[0].orientation = since;
  rock.load[1].force = rotate(since, rotate(frame, Vec3d{40, 0, 0}));
  CHECK(rock.is_overloaded(0.39));
  CHECK_FALSE(rock.is_overloaded(0.41));
  rock.load[1].force = rotate(since, rotate(frame, Vec3d{-40, 0, 0}));
  CHECK_FALSE(rock.is_overloaded(0.01));
}

TEST_CASE("Many bonds are looked at in groups, the last of which is not full", "[levels]") {
  TwoParticles rock;
  constexpr std::size_t bonds = 37;
  rock.table = LoadTable(2, bonds);
  rock.blocks[0].table_bonds = bonds;
  std::fill_n(rock.table.row(1).force(), bonds, 0.02f);
  rock.strength.assign(bonds, 1);
  const std::size_t loaded = GENERATE(0, 15, 16, 36);
  rock.table.row(1).response(0, 0)[loaded] = 0.01f;
  rock.load[1].force = {40, 0, 0};
  CHECK(rock.is_overloaded(0.39));
  CHECK_FALSE(rock.is_overloaded(0.41));
  rock.strength[loaded] = 4;
  CHECK_FALSE(rock.is_overloaded(0.11));
}
