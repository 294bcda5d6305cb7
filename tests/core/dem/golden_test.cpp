// SPDX-License-Identifier: GPL-3.0-or-later
// Golden hashes: every bit of some small scenes, the same for any number of threads, instruction set and build.
//
// A hash that changes shows that some bit of the results has changed. If that is unintended, find the mistake. If
// it is intended (a law, an order of summation), copy the numbers that the failing test prints, and write a line in
// CHANGELOG.md that says what changed in results and why.
//
// The scenes use no function whose last bit depends on the maths library (sin, exp, hypot): no rotating wall, profiles
// along the axes and, in double precision, no restitution below 1, whose damping constant is found with exp and acos.
// In mixed precision that constant is rounded to single precision, far above the differences of libraries.
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <cstring>
#include <iomanip>
#include <sstream>
#include <string_view>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// FNV-1a of the bytes of numbers.
class Hash {
 public:
  template <class T>
  void add(const T& number) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>, "no gaps");
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof bytes);
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 1099511628211u;
  }
  void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
  template <class T>
  void add(const std::vector<T>& rows) {
    add(rows.size());
    for (const T& row : rows) add(row);
  }
  /// A struct, field by field.
  template <HasFields T>
  void add(const T& row) {
    T::for_each_field(
        [this](const char* name, const auto& field) {
          if (!is_of_levels(name)) add(field);
        },
        row);
  }
  std::uint64_t value() const { return value_; }

 private:
  /// Zero without levels of detail, and younger than the hashes.
  static bool is_of_levels(std::string_view name) { return name == "switched" || name == "rigid_particles"; }
  std::uint64_t value_ = 14695981039346656037u;
};

std::uint64_t hash_of(Dem& dem) {
  Hash hash;
  const ParticleSnapshot p = dem.particles();
  hash.add(p.id), hash.add(p.rock), hash.add(p.fragment), hash.add(p.position), hash.add(p.velocity);
  hash.add(p.angular_velocity), hash.add(p.force), hash.add(p.radius), hash.add(p.mass);
  const BondSnapshot b = dem.bonds();
  hash.add(b.i), hash.add(b.j), hash.add(b.normal_force), hash.add(b.stress_ratio), hash.add(b.radius);
  hash.add(dem.wall_loads());
  hash.add(dem.energy());
  hash.add(dem.momentum());
  hash.add(dem.take_breakages());
  for (const WallImpulse& w : dem.take_wall_impulses())
    hash.add(w.wall), hash.add(w.centre), hash.add(w.radius), hash.add(w.impulse), hash.add(w.slip);
  Counts counts = dem.counts();
  counts.rebuilds = 0;  // the number of rebuilds does not belong to the results
  hash.add(counts);
  return hash.value();
}

struct Setup {
  Scene scene;
  std::vector<NewRock> rocks;
  std::int64_t steps;
};

Scene golden_scene(Precision precision, double dt) {
  Scene scene = plain_scene(dt);
  scene.pairs.assign(4, {0.5, precision == Precision::mixed ? 0.25 : 1.0, 0.02});
  scene.gravity = {0, 0, -9.81};
  scene.wall_impulses = true;
  return scene;
}

void add_bonds(Scene& scene) {
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.05;
  scene.bonds->tensile_strength = 3.6e6;
  scene.bonds->shear_strength = 2.4e6;
}

NewRock turned_rock(RockId id, Vec3d to) {
  NewRock rock = placed(lattice(0, 4), id, static_cast<ParticleId>(100 * id), to, {0.8, 0.36, 0.48, 0});
  scatter_strength(rock);
  return rock;
}

/// A bonded rock that tumbles and vibrates in free space.
Setup free_rock(Precision precision) {
  Scene scene = golden_scene(precision, 2e-6);
  add_bonds(scene);
  scene.gravity = {0, 0, 0};
  NewRock rock = turned_rock(0, {0, 0, 0});
  add_rigid_motion(rock, {1, 2, 3}, {20, -30, 10});
  for (NewParticle& p : rock.particles) p.velocity += 0.05 * random_vector(p.id, 0);
  return {scene, {rock}, 300};
}

/// Two rocks, one on the other, crushed between planes that close.
Setup crushed_rocks(Precision precision, int substeps) {
  Scene scene = golden_scene(precision, 2e-6 * substeps);
  add_bonds(scene);
  scene.substeps = substeps;
  scene.walls = {{"top", PlaneShape{{0, 0, 0.14}, {0, 0, -1}}, LinearMotion{{0, 0, -8}}, 1},
                 {"bottom", PlaneShape{{0, 0, -0.14}, {0, 0, 1}}, LinearMotion{{0, 0, 8}}, 1}};
  NewRock lower = turned_rock(2, {-0.005, 0.003, -0.07});
  if (substeps > 2) lower.substeps = 2;
  return {scene, {turned_rock(1, {0.005, 0, 0.07}), lower}, 1200 / substeps};
}

/// Spheres of three sizes that fall into a tube with an open floor, onto a wedge that rises.
Setup spheres_on_walls(Precision precision) {
  Scene scene = golden_scene(precision, 2e-6);
  scene.walls = {{"tube", ProfileShape{{{0.03, 0}, {0.07, 0}, {0.07, 0.2}}}, Fixed{}, 1},
                 {"wedge",
                  TriangleMesh{{{-0.05, -0.06, 0}, {0.05, -0.06, 0}, {0.05, 0, 0.02}, {-0.05, 0, 0.02}, {0, 0.05, 0}},
                               {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}},
                  LinearMotion{{0, 0, 0.5}}, 1}};
  std::vector<NewRock> rocks = cloud({{5, 5, 4}, 0.02, 0.009, 1.0});
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    NewParticle& p = rocks[k].particles[0];
    p.position.z += 0.07;
    p.velocity.z -= 3;
    if (k % 3 != 0) p.radius *= k % 3 == 1 ? 0.5 : 0.25;
  }
  return {scene, rocks, 2400};
}

struct Golden {
  const char* name;
  Setup (*setup)(Precision);
  std::uint64_t mixed, double_;
};

const Golden goldens[] = {
    {"free rock", free_rock, 0x6c3b775a1613fa32, 0x99ced7f4e6274830},
    {"crushed rocks", [](Precision p) { return crushed_rocks(p, 1); }, 0xf031976abf5340dc, 0x345b0f7921f55e4c},
    {"crushed rocks, held forces", [](Precision p) { return crushed_rocks(p, 3); }, 0xcf17f6b21ccc05bd,
     0x11ac68edb4bb0121},
    {"spheres on walls", spheres_on_walls, 0xf6439fc65aa0c582, 0xbc45ab3fa2055842},
};

/// Checks that contacts, breakage and motion occur, so that the hash covers the laws.
void require_busy(const Dem& dem, const Scene& scene) {
  const Counts counts = dem.counts();
  const EnergyTerms energy = dem.energy();
  if (scene.bonds) REQUIRE(energy.bond_damping > 0);
  if (scene.walls.empty()) return;
  REQUIRE(energy.friction > 0);
  REQUIRE(energy.wall_work != 0);
  if (scene.bonds) REQUIRE(counts.broken_tension + counts.broken_shear > 50);
}

}  // namespace

TEST_CASE("Fixed scenes have the stored hashes", "[dem][bits]") {
  const Golden& golden = goldens[GENERATE(0, 1, 2, 3)];
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  const Setup setup = golden.setup(precision);
  for (const int threads : {1, 2, 7}) {
    const auto dem = make_cpu_dem(setup.scene, precision, threads);
    dem->insert(setup.rocks);
    std::int64_t step = 0;
    run(*dem, setup.scene.dt, step, setup.steps, 120);
    require_busy(*dem, setup.scene);
    const std::uint64_t found = hash_of(*dem);
    std::ostringstream hex;
    hex << "0x" << std::hex << std::setw(16) << std::setfill('0') << found;
    INFO(golden.name << ", " << to_string(precision) << ", " << threads << " threads: " << hex.str());
    CHECK(found == (precision == Precision::mixed ? golden.mixed : golden.double_));
  }
}
