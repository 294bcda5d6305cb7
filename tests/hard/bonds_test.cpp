// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of bonds and breakage: packed-in overlap, gaps, cascades, rotations, twists.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <set>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double d = grain;

Scene bond_scene(double dt) {
  return bonded_scene(dt, paper_bonds(), {0.5, 0.25, 0});
}

/// A lattice whose particles are packed at `spacing` diameters and then moved by up to `shift` [m], so that its bonds
/// are loaded; every bond has `strength`.
NewRock loaded_lattice(int n, double spacing, double shift, double strength) {
  NewRock rock = lattice(0, n, {.bond_radius = grain / 4});
  for (NewParticle& p : rock.particles) p.position = spacing * p.position + shift * random_vector(p.id, 0);
  for (NewBond& b : rock.bonds) {
    b.length = spacing * d;
    b.strength = strength;
  }
  return rock;
}

}  // namespace

TEST_CASE("H12 bonds that break with packed-in overlap release no more than they stored", "[hard]") {
  // Overlap of 1, 5 and 10 % of the radius, with and without load. Full contact forces would give 0.5 to 9.7 m/s.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double overlap = GENERATE(0.01, 0.05, 0.10), shift = GENERATE(0.0, 2e-6);
  const double dt = 5e-7;
  Scene scene = bond_scene(dt);
  scene.bonds->damping = 0;
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{loaded_lattice(4, 1 - overlap / 2, shift, 1e-8)};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, 1);
  const EnergyTerms start = dem->energy();
  const double stored = start.exchanged;  // all particles are at rest at the start
  double fastest = 0, maximum = 0;
  for (int k = 0; k < 40; ++k) {
    run(*dem, dt, step, 100);
    for (const Vec3d& v : dem->particles().velocity) fastest = std::max(fastest, norm(v));
    maximum = std::max(maximum, dem->energy().kinetic);
  }
  INFO("overlap " << overlap << ": stored " << stored << " J, kinetic " << maximum << " J, fastest " << fastest);
  if (shift > 0) CHECK(dem->counts().bonds_intact == 0);
  CHECK(maximum <= stored * (1 + 1e-6) + 1e-15);
  CHECK(std::abs(dem->energy().residual()) <= 0.02 * stored + 1e-15);
}

TEST_CASE("H13 the force stays continuous if the gap of a bond closes before the bond breaks", "[hard]") {
  // The gap is 1 to 5 % of the diameter; the pair is pressed together until the shear of a slow slide breaks the bond.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double gap = GENERATE(0.01, 0.03, 0.05);
  const double dt = 2e-8;
  Scene scene = bond_scene(dt);
  scene.bonds->tensile_strength = 1e12;
  scene.bonds->shear_strength = 2.6e5;
  scene.bonds->normal_stiffness = 2e10;  // so soft that the gap closes
  scene.bonds->shear_stiffness = 6.67e9;
  NewRock rock;
  rock.id = 0;
  const double length = (1 + gap) * d;
  const double speed = gap * d / 100e-6;  // closes in 50 us, breaks at about 80 us
  rock.particles = {{0, {0, 0, 0}, {speed, -0.3, 0}, {0, 0, 0}, d / 2, 2600},
                    {1, {length, 0, 0}, {-speed, 0.3, 0}, {0, 0, 0}, d / 2, 2600}};
  rock.bonds = {{0, 1, length, d / 5, 1.0}};
  rock.colour_begin = {0, 1};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{rock};
  dem->insert(rocks);
  std::int64_t step = 0;
  double last = 0, last_change = 0, jump = 0, largest = 0, nearest = 1;
  bool broken = false;
  while (step < 40000) {
    run(*dem, dt, step, 1);
    const ParticleSnapshot s = dem->particles();
    const Vec3d span = s.position[1] - s.position[0];
    const double push = dot(s.force[1], span) / norm(span);
    nearest = std::min(nearest, norm(span));
    largest = std::max(largest, push);
    if (!broken && dem->counts().bonds_intact == 0) {
      broken = true;
      CHECK(norm(span) < d);  // the gap has closed before
      CHECK(push > 0.1 * largest);
    }
    // Jump in addition to the change in a step before.
    if (step > 2) jump = std::max(jump, std::abs(push - last - last_change));
    last_change = push - last;
    last = push;
    if (broken && norm(span) > 1.01 * length) break;
  }
  INFO("gap " << gap << ": jump " << jump << " of " << largest << " N, nearest " << nearest / d);
  REQUIRE(broken);
  REQUIRE(largest > 50);
  CHECK(jump < 0.02 * largest);
  CHECK(std::abs(dem->energy().residual()) < 0.01 * dem->energy().exchanged);
}

TEST_CASE("H14 rotation by up to 0.1 rad a step does not strain bonds", "[hard]") {
  // A pair that rotates as a rigid body about an oblique axis; its bond is stretched as the centrifugal force requires.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double rotation = GENERATE(1e-4, 1e-3, 1e-2, 0.05, 0.09);
  const double dt = 1e-6, angular_velocity = rotation / dt;
  Scene scene = bond_scene(dt);
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 1e30;
  NewRock rock;
  rock.id = 0;
  const double mass = sphere_mass(d / 2, 2600), stiffness = 1.67e12 * M_PI * d * d / 25;
  // m w2 L/2 = k (L - L0); a density that makes the stretch 1 %.
  const double density = 2600 * 0.02 * stiffness / (mass * angular_velocity * angular_velocity) / 1.01;
  const Vec3d axis{0.6, 0, 0.8}, along{0, 1, 0};
  const double length = 1.01 * d;
  rock.particles = {{0, -0.5 * length * along, {0, 0, 0}, angular_velocity * axis, d / 2, density},
                    {1, 0.5 * length * along, {0, 0, 0}, angular_velocity * axis, d / 2, density}};
  for (NewParticle& p : rock.particles) p.velocity = cross(angular_velocity * axis, p.position);
  rock.bonds = {{0, 1, d, d / 5, 1.0}};
  rock.colour_begin = {0, 1};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{rock};
  dem->insert(rocks);
  const double kinetic = dem->energy().kinetic;
  std::int64_t step = 0;
  const auto steps = static_cast<std::int64_t>(std::min(2e5, std::ceil(10 * 2 * M_PI / rotation)));
  run(*dem, dt, step, steps);
  const EnergyTerms e = dem->energy();
  const double stretch_energy = 0.5 * stiffness * 1e-4 * d * d;
  INFO("rotation " << rotation << ": kinetic " << e.kinetic / kinetic - 1 << ", bond "
                   << e.bond_elastic / stretch_energy - 1);
  // The Verlet scheme has an orbit error of (w dt)^2; the strain of the bond must not increase it.
  const double expected = std::max(2 * rotation * rotation, precision == Precision::double_ ? 1e-9 : 1e-6);
  CHECK(std::abs(e.kinetic / kinetic - 1) < expected);
  CHECK(std::abs(e.bond_elastic / stretch_energy - 1) < 60 * expected);
  CHECK(dem->extremes().rotation == Approx(rotation).epsilon(0.01));
}

TEST_CASE("H15 a bond twisted beyond the limit of its law has no jump and is reported", "[hard]") {
  // A weak bond fails long before the limit of its law; an unbreakable one exceeds the limit.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const bool breakable = GENERATE(true, false);
  const double dt = 1e-6, angular_velocity = 40;
  Scene scene = bond_scene(dt);
  scene.bonds->shear_stiffness = 1e7;  // so soft that the spheres keep rotating
  if (!breakable) scene.bonds->tensile_strength = scene.bonds->shear_strength = 1e30;
  if (breakable) scene.bonds->shear_strength = 1e7 * 0.005 * 0.3;  // at 0.3 rad of twist
  NewRock rock;
  rock.id = 0;
  rock.particles = {{0, {0, 0, 0}, {0, 0, 0}, {-angular_velocity, 0, 0}, d / 2, 2600},
                    {1, {d, 0, 0}, {0, 0, 0}, {angular_velocity, 0, 0}, d / 2, 2600}};
  rock.bonds = {{0, 1, d, 0.005, 1.0}};
  rock.colour_begin = {0, 1};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{rock};
  dem->insert(rocks);
  std::int64_t step = 0;
  double reported = -1, last = 0, jump = 0, twist = 0;
  while (twist < 3 * M_PI && step < 400000) {
    run(*dem, dt, step, 500);
    const ParticleSnapshot s = dem->particles();
    twist += (s.angular_velocity[1].x - s.angular_velocity[0].x) * 500 * dt;
    if (reported < 0 && dem->extremes().bond_rotation > scene.limits.bond_rotation) reported = twist;
    const double energy = dem->energy().bond_elastic;
    if (step > 500) jump = std::max(jump, std::abs(energy - last));
    last = energy;
  }
  const double capacity = 0.5 * 1e7 * 0.5 * M_PI * std::pow(0.005, 4) * 4;
  INFO("reported at " << reported << " rad, largest change in 0.04 rad " << jump / capacity);
  if (breakable) {
    CHECK(dem->counts().broken_shear == 1);
    CHECK(reported == -1);
  } else {
    CHECK(dem->counts().bonds_intact == 1);
    CHECK(reported > 0.5);
    CHECK(reported < 0.6);
    CHECK(dem->extremes().twisted <= 1);
    CHECK(jump < 0.05 * capacity);
  }
}

TEST_CASE("H16 a hundred thousand bonds that break in one step are all recorded, once and in order", "[hard]") {
  const int n = 33;  // 3 n2 (n - 1) = 104,544 bonds
  const NewRock rock = loaded_lattice(n, 1, 1e-6, 1e-12);
  const std::vector<NewRock> rocks{rock};
  Scene scene = bond_scene(5e-7);
  std::vector<Breakage> first;
  double first_energy = 0;
  for (const int threads : {1, 7}) {
    const auto dem = make_cpu_dem(scene, Precision::mixed, threads);
    dem->insert(rocks);
    std::int64_t step = 0;
    run(*dem, scene.dt, step, 1);
    const std::vector<Breakage> broken = dem->take_breakages();
    CHECK(dem->counts().bonds_intact == 0);
    REQUIRE(broken.size() == rock.bonds.size());
    CHECK(dem->counts().broken_tension + dem->counts().broken_shear == static_cast<std::int64_t>(rock.bonds.size()));
    std::set<std::pair<ParticleId, ParticleId>> pairs;
    double energy = 0;
    for (const Breakage& b : broken) {
      pairs.insert({b.i, b.j});
      energy += b.energy;
    }
    CHECK(pairs.size() == rock.bonds.size());
    CHECK(dem->energy().bond_breakage == Approx(energy).epsilon(1e-12));
    CHECK(std::is_sorted(broken.begin(), broken.end(), [](const Breakage& a, const Breakage& b) {
      return std::tie(a.time, a.i, a.j) < std::tie(b.time, b.i, b.j);
    }));
    run(*dem, scene.dt, step, 20);
    CHECK(dem->take_breakages().empty());
    if (threads == 1) {
      first = broken;
      first_energy = dem->energy().kinetic;
      continue;
    }
    CHECK(dem->energy().kinetic == first_energy);
    bool same_events = true;
    for (std::size_t k = 0; k < first.size(); ++k)
      same_events = same_events && first[k].i == broken[k].i && first[k].j == broken[k].j &&
                    first[k].energy == broken[k].energy && first[k].mode == broken[k].mode;
    CHECK(same_events);
  }
}
