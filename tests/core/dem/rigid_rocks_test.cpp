// SPDX-License-Identifier: GPL-3.0-or-later
// Rocks that move as rigid bodies while their bonds are loaded little.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/rocks/load_table.hpp"
#include "core/state/bodies.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"
#include "tests/catch.hpp"
#include "tests/gpu/same_bits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace gyro;
using namespace gyro::fixtures;
using namespace gyro::test;

namespace {

/// A table of a rock in which a vertical force on any particle shears every bond alike. @param per_newton  stress ratio
/// of every bond [1/N]
LoadTable even_table(const NewRock& rock, float per_newton) {
  LoadTable table(static_cast<Index>(rock.particles.size()), static_cast<Index>(rock.bonds.size()));
  for (Index i = 0; i < table.particles; ++i)
    for (Index b = 0; b < table.bonds; ++b)  // shear by the force along z
      table.row(i).force()[b] = table.row(i).response(2, 1)[b] = per_newton;
  return table;
}

/// The same rows for rocks and pieces without a table.
std::function<std::unique_ptr<LoadResponse>(const NewRock&)> even_response(float per_newton) {
  struct Even final : LoadResponse {
    LoadTable table;
    void fill(Index particle, const LoadRow<float>& to) const override {
      const LoadRow<const float> row = table.row(particle);
      std::copy_n(row.numbers, load_row_width * table.bonds, to.numbers);
    }
  };
  return [per_newton](const NewRock& rock) {
    auto response = std::make_unique<Even>();
    response->table = even_table(rock, per_newton);
    return response;
  };
}

std::shared_ptr<const std::vector<LoadTable>> one_table(const LoadTable& table) {
  return std::make_shared<const std::vector<LoadTable>>(1, table);
}

/// An elastic floor without friction; rocks have four sub-steps.
Scene on_floor(const LoadTable& table, double damping = 0) {
  BondParameters bonds = paper_bonds();
  bonds.damping = damping;
  Scene scene = bonded_scene(2e-6, bonds);
  scene.pairs.assign(4, {0, 1, 0});
  scene.gravity = {0, 0, -9.81};
  scene.walls = {floor_plane()};
  scene.substeps = 4;
  scene.rigid = RigidLevel{.look_interval = 2e-5, .tables = one_table(table)};
  return scene;
}

/// A long block that falls on an edge.
NewRock slab(double speed) {
  NewRock rock = placed(block(0, {4, 2, 1}), 0, 0, {0, 0, 0.06}, rotation_about({0.6, 0.8, 0}, 0.5));
  for (NewParticle& p : rock.particles) p.velocity = {0, 0, -speed};
  rock.load_table = 0;
  return rock;
}

struct Motion6 {
  Vec3d momentum, angular;  ///< angular about the centre of mass
};
Motion6 motion_of(const ParticleSnapshot& p) {
  Motion6 m{{0, 0, 0}, {0, 0, 0}};
  Vec3d middle{0, 0, 0};
  double mass = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    mass += p.mass[k], middle += p.mass[k] * p.position[k], m.momentum += p.mass[k] * p.velocity[k];
  middle = (1 / mass) * middle;
  for (std::size_t k = 0; k < p.size(); ++k)
    m.angular += p.mass[k] * cross(p.position[k] - middle, p.velocity[k] - (1 / mass) * m.momentum) +
                 0.4 * p.mass[k] * p.radius[k] * p.radius[k] * p.angular_velocity[k];
  return m;
}

double largest_change_of_shape(const ParticleSnapshot& p, const NewRock& rock) {
  double worst = 0;
  for (std::size_t k = 1; k < p.size(); ++k)
    worst = std::max(worst, std::abs(norm(p.position[k] - p.position[0]) -
                                     norm(rock.particles[k].position - rock.particles[0].position)));
  return worst;
}

}  // namespace

TEST_CASE("A rigid rock falls, hits the floor on an edge and tumbles without loss", "[dem][levels]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double speed = 1;
  const NewRock rock = slab(speed);
  std::vector<double> residual;
  for (const double dt : {8e-6, 4e-6}) {
    Scene scene = on_floor(even_table(rock, 0));
    scene.dt = dt;
    Stage stage(scene, precision);
    stage.insert({rock});
    double worst = 0;
    bool hit = false;
    while (stage.time() < 0.12) {
      stage.advance(50);
      const EnergyTerms e = stage.dem().energy();
      hit = hit || e.contact_elastic > 0;
      worst = std::max(worst, std::abs(e.residual()));
      CHECK(e.bond_elastic < 1e-9 * e.kinetic);
    }
    CHECK(hit);
    CHECK(stage.dem().counts().rigid_particles == 8);
    const ParticleSnapshot p = stage.dem().particles();
    CHECK(largest_change_of_shape(p, rock) < 1e-12);
    CHECK(norm(p.angular_velocity[0]) > 5);
    residual.push_back(worst);
  }
  const double kinetic = 0.5 * 8 * mass_of(rock.particles[0]) * speed * speed;
  CAPTURE(residual[0], residual[1], kinetic);
  CHECK(residual[0] < 5e-3 * kinetic);
  CHECK(residual[1] < 0.5 * residual[0]);
}

TEST_CASE("An overloaded rock becomes particles with bonds and moves on with its momentum", "[dem][levels]") {
  const NewRock rock = slab(0.5);
  // Bonds are evaluated from the first look on in which a contact presses with more than 1 N.
  const Scene scene = on_floor(even_table(rock, 0.5f));
  Stage stage(scene, Precision::double_), bonded(on_floor(even_table(rock, 0)), Precision::double_);
  NewRock always = rock;
  always.load_table = none;
  stage.insert({rock});
  bonded.insert({always});
  bool freed = false;
  for (int w = 0; w < 300; ++w) {
    const Vec3d before = stage.dem().momentum();
    stage.advance(50);
    bonded.advance(50);
    const double length = 50 * stage.dt();
    const Vec3d impulse = length * (8 * mass_of(rock.particles[0]) * scene.gravity - stage.dem().wall_loads()[0].force);
    CHECK(norm(stage.dem().momentum() - before - impulse) < 1e-9);
    freed = freed || stage.dem().counts().rigid_particles == 0;
  }
  REQUIRE(freed);
  // Without damping what is lost shows in the residual alone.
  const EnergyTerms e = stage.dem().energy();
  CHECK(std::abs(e.residual()) < 5e-3 * e.kinetic);
  CHECK(e.switched == 0);
  // Same rock, other instants of contact forces: it leaves the floor as the bonded one does.
  const Motion6 a = motion_of(stage.dem().particles()), b = motion_of(bonded.dem().particles());
  CHECK(norm(a.momentum - b.momentum) < 0.03 * norm(b.momentum));
  CHECK(norm(a.angular - b.angular) < 0.05 * norm(b.angular));
}

TEST_CASE("A rock that comes to rest inside becomes rigid again: momentum stays, energy is booked", "[dem][levels]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  NewRock rock = slab(0);
  add_rigid_motion(rock, {0.3, 0, 0}, {20, 30, -40});
  rock.particles[3].velocity += Vec3d{0.2, 0.1, 0};  // bonds swing, and their damping takes it
  Scene scene = on_floor(even_table(rock, 0), 0.2);
  scene.gravity = {0, 0, 0};
  scene.rigid->rigid_below = 0.05;
  scene.rigid->calm_time = 1e-3;
  Stage stage(scene, precision);
  stage.insert({rock});
  REQUIRE(stage.dem().counts().rigid_particles == 0);  // it rotates
  Motion6 before = motion_of(stage.dem().particles());
  double energy_before = 0;
  for (int w = 0; w < 100 && stage.dem().counts().rigid_particles == 0; ++w) {
    before = motion_of(stage.dem().particles());
    energy_before = stage.dem().energy().kinetic + stage.dem().energy().bond_elastic;
    stage.advance(50);
  }
  REQUIRE(stage.dem().counts().rigid_particles == 8);
  CHECK(stage.time() > 1e-3);
  const Motion6 after = motion_of(stage.dem().particles());
  CHECK(norm(after.momentum - before.momentum) < 1e-12 * norm(before.momentum));
  CHECK(norm(after.angular - before.angular) < 1e-9 * norm(before.angular));
  const EnergyTerms e = stage.dem().energy();
  CHECK(e.bond_elastic < 1e-12 * e.kinetic);
  CHECK(e.switched == Approx(energy_before - e.kinetic).margin(1e-9 * e.kinetic));
  CHECK(e.switched > 0);
  CHECK(e.switched < 0.01 * e.kinetic);
  CHECK(largest_change_of_shape(stage.dem().particles(), placed(block(0, {4, 2, 1}), 0, 0, {0, 0, 0})) < 1e-12);
}

namespace {

/// Rocks that break, become rigid and are taken out: breaking_scene() with a table for its rocks.
/// @param pieces  may become rigid as well
Scene changing_scene(bool pieces) {
  Scene scene = breaking_scene();
  scene.bonds->tensile_strength *= 20;
  scene.bonds->shear_strength *= 20;
  const NewRock rock = lattice(0, 4, {0.01, 0.004});
  scene.rigid = RigidLevel{.bonded_above = 0.5,
                           .rigid_below = 0.3,
                           .calm_time = 1e-4,
                           .look_interval = 4e-6,
                           .tables = one_table(even_table(rock, 2e-3f))};
  if (pieces) scene.rigid->response_of = rigid_pieces(*scene.bonds).response_of;
  return scene;
}

std::vector<NewRock> with_tables(std::vector<NewRock> rocks) {
  for (NewRock& rock : rocks) {
    if (rock.bonds.empty()) continue;
    rock.load_table = 0;
    if (rock.id % 2 == 1)  // breaks
      for (NewBond& bond : rock.bonds) bond.strength = 0.05;
  }
  return rocks;
}

/// Runs the scene in windows, each in the next of the solvers; a single one is never restored.
std::vector<SavedState> changed_on(const std::vector<int>& threads, bool pieces) {
  std::vector<std::unique_ptr<Dem>> solvers;
  for (const int n : threads) solvers.push_back(make_cpu_dem(changing_scene(pieces), Precision::mixed, n));
  std::vector<SavedState> states;
  std::int64_t step = 0;
  for (std::size_t w = 0; w < 60; ++w) {
    Dem& dem = *solvers[w % solvers.size()];
    if (w > 0 && solvers.size() > 1) dem.restore(states.back());
    if (w == 0) dem.insert(with_tables(falling_rocks(0, 0, 0.045)));
    if (w == 20) dem.insert(with_tables(falling_rocks(2, 1000, 0.16)));
    if (w == 40) {
      const ParticleSnapshot s = dem.particles();
      std::vector<ParticleId> leaving;
      for (std::size_t k = 0; k < s.size(); ++k)
        if (s.position[static_cast<std::size_t>(s.fragment[k])].z < 0.03) leaving.push_back(s.id[k]);
      dem.remove(leaving);
    }
    run(dem, breaking_dt, step, 150, 150);
    states.push_back(dem.save());
  }
  return states;
}

int rigid_rocks(const SavedState& state) {
  int count = 0;
  for (const Block& b : state.get<Block>("blocks")) count += b.rigid;
  return count;
}

/// Those that are pieces of broken rocks.
int rigid_pieces(const SavedState& state) {
  int count = 0;
  for (const Block& b : state.get<Block>("blocks")) count += b.rigid && b.table == none;
  return count;
}

}  // namespace

TEST_CASE("Rocks change their level at the same steps on any number of threads and after a restart", "[dem][levels]") {
  const bool pieces = GENERATE(false, true);
  const std::vector<SavedState> one = changed_on({1}, pieces), many = changed_on({2, 7, 1}, pieces);
  int freed = 0, stiffened = 0, max_pieces = 0;
  for (std::size_t w = 0; w < one.size(); ++w) {
    CAPTURE(w);
    CHECK(same_bytes(one[w].get<Sphere>("particles/position"), many[w].get<Sphere>("particles/position")));
    CHECK(same_bytes(one[w].get<Load>("particles/load"), many[w].get<Load>("particles/load")));
    CHECK(same_bytes(one[w].get<Body>("rigid/bodies"), many[w].get<Body>("rigid/bodies")));
    CHECK(one[w].get_one<EnergyTerms>("dem/energies").switched ==
          many[w].get_one<EnergyTerms>("dem/energies").switched);
    CHECK(one[w].get_one<EnergyTerms>("dem/energies").wall_work ==
          many[w].get_one<EnergyTerms>("dem/energies").wall_work);
    CHECK(rigid_rocks(one[w]) == rigid_rocks(many[w]));
    max_pieces = std::max(max_pieces, rigid_pieces(one[w]));
    if (w == 0 || w == 20 || w == 40) continue;  // rocks come and go
    freed += std::max(0, rigid_rocks(one[w - 1]) - rigid_rocks(one[w]));
    stiffened += std::max(0, rigid_rocks(one[w]) - rigid_rocks(one[w - 1]));
  }
  CHECK(freed > 1);
  CHECK(stiffened > 0);
  CHECK((max_pieces > 0) == pieces);
}

namespace {

/// A block of 4 x 2 x 1 particles, in free space, whose halves fly apart at +-0.5 m/s and rotate.
NewRock halves() {
  NewRock rock = placed(block(0, {4, 2, 1}), 0, 0, {0, 0, 0.06}, rotation_about({0.6, 0.8, 0}, 0.5));
  const NewRock in_place = block(0, {4, 2, 1});
  double middle = 0;
  for (const NewParticle& p : in_place.particles)
    middle += p.position.x / static_cast<double>(in_place.particles.size());
  const Vec3d along = rotate(rotation_about({0.6, 0.8, 0}, 0.5), Vec3d{1, 0, 0});
  const auto side = [&](Index n) { return in_place.particles[static_cast<std::size_t>(n)].position.x > middle; };
  for (NewBond& b : rock.bonds)
    if (side(b.i) != side(b.j)) b.strength = 1e-3;
  add_rigid_motion(rock, {0.1, 0, 0}, {4, 5, -3});
  for (std::size_t n = 0; n < rock.particles.size(); ++n)
    rock.particles[n].velocity += (side(static_cast<Index>(n)) ? 0.5 : -0.5) * along;
  rock.load_table = 0;
  return rock;
}

}  // namespace

TEST_CASE("The pieces of a broken rock become rigid, hit walls and go on with their momentum", "[dem][levels]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const NewRock rock = halves();
  Scene scene = on_floor(even_table(rock, 0), 0.2);
  scene.gravity = {0, 0, 0};
  scene.rigid->calm_time = 1e-3;
  scene.rigid->response_of = even_response(0);
  Stage stage(scene, precision);
  stage.insert({rock});
  const Motion6 start = motion_of(stage.dem().particles());
  Motion6 before = start;
  for (int w = 0; w < 200 && stage.dem().counts().rigid_particles < 8; ++w) {
    before = motion_of(stage.dem().particles());
    stage.advance(50);
    if (stage.time() > 0.02) break;
  }
  REQUIRE(stage.dem().counts().rigid_particles == 8);
  const Motion6 rigid = motion_of(stage.dem().particles());
  CHECK(norm(rigid.momentum - before.momentum) < 1e-12 * norm(start.momentum));
  CHECK(norm(rigid.angular - before.angular) < 1e-9 * norm(start.angular));
  const EnergyTerms at_rest = stage.dem().energy();
  CHECK(std::abs(at_rest.switched) < 0.01 * at_rest.kinetic);
  // One of them hits the floor; damping of contacts is zero.
  bool hit = false;
  for (int w = 0; w < 1200; ++w) {
    const Vec3d momentum = stage.dem().momentum();
    stage.advance(50);
    const Vec3d from_floor = -50 * stage.dt() * stage.dem().wall_loads()[0].force;
    hit = hit || norm(from_floor) > 0;
    CHECK(norm(stage.dem().momentum() - momentum - from_floor) < 1e-12);
  }
  CHECK(hit);
  CHECK(stage.dem().counts().rigid_particles == 8);
  CHECK(std::abs(stage.dem().energy().residual() - at_rest.residual()) < 5e-3 * at_rest.kinetic);
}

TEST_CASE("A rock without a table, or whose bonds are loaded where it arrives, is never rigid", "[dem][levels]") {
  NewRock without = slab(0), loaded = placed(slab(0), 1, 100, {1, 0, 1});
  without.load_table = none;
  loaded.load_table = 0;
  loaded.bonds[0].length *= 1.0001;
  Stage stage(on_floor(even_table(loaded, 0), 0.2), Precision::mixed);
  stage.insert({without, loaded});
  for (int w = 0; w < 200; ++w) stage.advance(50);
  CHECK(stage.dem().counts().rigid_particles == 0);
}

TEST_CASE("A bonded pair and a straight chain become rigid as any other rock", "[dem][levels]") {
  NewRock rock = placed(chain(0, GENERATE(1, 2)), 0, 0, {0, 0, 1}, rotation_about({0, 0.6, 0.8}, 0.7));
  add_rigid_motion(rock, {0, 0, 0}, {3, 2, 1});
  rock.particles[0].velocity += Vec3d{0, 0.01, 0};
  rock.load_table = 0;
  Scene scene = on_floor(even_table(rock, 0), 0.3);
  scene.gravity = {0, 0, 0};
  scene.rigid->calm_time = 5e-4;
  Stage stage(scene, Precision::double_);
  stage.insert({rock});
  for (int w = 0; w < 200 && stage.dem().counts().rigid_particles == 0; ++w) stage.advance(50);
  REQUIRE(stage.dem().counts().rigid_particles > 0);
  const Motion6 before = motion_of(stage.dem().particles());
  for (int w = 0; w < 50; ++w) stage.advance(50);
  const Motion6 after = motion_of(stage.dem().particles());
  CHECK(norm(after.momentum - before.momentum) < 1e-12);
  CHECK(norm(after.angular - before.angular) < 1e-9 * norm(before.angular));
  CHECK(std::abs(stage.dem().energy().residual()) < 1e-6 * stage.dem().energy().kinetic);
}

TEST_CASE("A rock without a table that arrives turned breaks under the same loads as one with a table",
          "[dem][levels]") {
  // A chain bears more along its axis than across it.
  const NewRock straight = chain(0, 3);
  const Quatd turn = rotation_about({0, 0.8, 0.6}, 1.3);
  const auto freed_at = [&](bool with_table) {
    Scene scene = on_floor(load_table(shape_of(straight), paper_bonds()), 0.1);
    scene.rigid->response_of = rigid_pieces(*scene.bonds).response_of;
    NewRock rock = placed(straight, 0, 0, {0, 0, 0.1}, turn);
    rock.orientation = turn;
    rock.load_table = with_table ? 0 : none;
    for (NewParticle& p : rock.particles) p.velocity = {0, 0, -1};
    Stage stage(scene, Precision::double_);
    stage.insert({rock});
    CHECK(stage.dem().counts().rigid_particles == 4);
    while (stage.dem().counts().rigid_particles == 4 && stage.time() < 0.2) stage.advance(10);
    return stage.time();
  };
  const double with_table = freed_at(true);
  REQUIRE(with_table < 0.19);
  CHECK(freed_at(false) == with_table);
}
