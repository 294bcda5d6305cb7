// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of contact laws with history: the hysteretic normal force and the rolling spring.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/plate_crush.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double dt = 1e-6;

PairProperties remembering(double restitution, double friction, double rolling) {
  return {friction, restitution, rolling, {NormalModel::hysteretic, RollingModel::spring_dashpot}};
}

/// A rock that is crushed between plates until most of its bonds have failed, with contacts that load and unload.
PlateCrush crush_scene() {
  PlateCrush crush(dt);
  crush.scene.pairs.assign(4, remembering(0.4, 0.5, 0.1));
  return crush;
}
constexpr std::int64_t end = 3000;  ///< steps after which the rock has broken

struct Outcome {
  ParticleSnapshot particles;
  EnergyTerms energy;
  Counts counts;
};

Outcome outcome_of(Dem& dem) {
  return {dem.particles(), dem.energy(), dem.counts()};
}

Outcome crushed(const PlateCrush& crush, Precision precision, int threads) {
  const auto dem = make_cpu_dem(crush.scene, precision, threads);
  const std::vector<NewRock> rocks{crush.rock};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, end);
  return outcome_of(*dem);
}

void check_same(const Outcome& a, const Outcome& b) {
  CHECK(same_bits(a.particles, b.particles));
  CHECK(a.energy.residual() == b.energy.residual());
  CHECK(a.energy.contact_damping == b.energy.contact_damping);
  CHECK(a.energy.contact_elastic == b.energy.contact_elastic);
}

/// Sets all numbers of a saved column to zero. @return whether any was not zero
template <class Real>
bool erase(SavedState& saved, const std::string& name) {
  bool any = false;
  for (Real& x : std::get<std::vector<Real>>(saved.columns().at(name).numbers)) {
    any = any || x != 0;
    x = 0;
  }
  return any;
}

bool forget(SavedState& saved, const std::string& name, Precision precision) {
  return precision == Precision::double_ ? erase<double>(saved, name) : erase<float>(saved, name);
}

}  // namespace

TEST_CASE("H40 a run resumed during hysteretic contacts has the same bits, and needs the contact history", "[hard]") {
  // First both laws have rolled against the plates, then contacts with grains and plates unload.
  struct Moment {
    std::int64_t step;
    const char* memory[2];
  };
  const auto precision = GENERATE(Precision::double_, Precision::mixed);
  const auto at = GENERATE(Moment{200, {"contacts/extra/roll_elastic", "wall_contacts/extra/roll_elastic"}},
                           Moment{600, {"contacts/extra/max_overlap", "wall_contacts/extra/max_overlap"}});
  const PlateCrush crush = crush_scene();
  const auto dem = make_cpu_dem(crush.scene, precision, 1);
  const std::vector<NewRock> rocks{crush.rock};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, at.step);
  const SavedState saved = dem->save();
  run(*dem, dt, step, end - at.step);
  const Outcome whole = outcome_of(*dem);
  REQUIRE(whole.counts.broken_tension + whole.counts.broken_shear > 20);

  const auto resumed = [&](const SavedState& state) {
    const auto other = make_cpu_dem(crush.scene, precision, 2);
    other->restore(state);
    std::int64_t from = at.step;
    run(*other, dt, from, end - at.step);
    return outcome_of(*other);
  };
  check_same(whole, resumed(saved));
  for (const char* name : at.memory) {
    INFO(name);
    SavedState without = saved;
    REQUIRE(forget(without, name, precision));
    CHECK_FALSE(same_bits(whole.particles, resumed(without).particles));
  }
}

TEST_CASE("H40 threads and rebuilt neighbour lists change no bit of contacts with history", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  PlateCrush crush = crush_scene();
  const Outcome one = crushed(crush, precision, 1);
  for (const int threads : {2, 7}) {
    INFO(threads << " threads");
    check_same(one, crushed(crush, precision, threads));
  }
  std::int64_t fewest = one.counts.rebuilds, most = fewest;
  for (const double skin : {5e-5, 2e-2}) {
    INFO("skin " << skin);
    crush.scene.neighbour_skin = skin;
    const Outcome other = crushed(crush, precision, 1);
    check_same(one, other);
    fewest = std::min(fewest, other.counts.rebuilds);
    most = std::max(most, other.counts.rebuilds);
  }
  CHECK(most > 20 * fewest);
}

TEST_CASE("H40 the energy of a rock that is crushed under contact laws with history balances", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const PlateCrush crush = crush_scene();
  const Outcome got = crushed(crush, precision, 2);
  REQUIRE(got.counts.broken_tension + got.counts.broken_shear > 20);
  INFO("residual " << got.energy.residual() / got.energy.wall_work << " of the work, hysteresis "
                   << got.energy.contact_damping / got.energy.wall_work);
  CHECK(std::abs(got.energy.residual()) < 5e-3 * got.energy.wall_work);
  CHECK(got.energy.contact_damping > 0);
}

TEST_CASE("H40 bonds with packed-in overlap that break add no energy to hysteretic contacts", "[hard]") {
  // As H12: the overlaps are 1, 5 and 10 % of the radius.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double overlap = GENERATE(0.01, 0.05, 0.10);
  Scene scene = bonded_scene(5e-7, paper_bonds(), remembering(0.4, 0.5, 0.1));
  scene.bonds->damping = 0;
  NewRock rock = lattice(0, 4, {.bond_radius = grain / 4});
  for (NewParticle& p : rock.particles) p.position = (1 - overlap / 2) * p.position + 2e-6 * random_vector(p.id, 0);
  for (NewBond& b : rock.bonds) {
    b.length = (1 - overlap / 2) * grain;
    b.strength = 1e-8;
  }
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{rock};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 1);
  const double stored = dem->energy().exchanged;
  double maximum = 0;
  for (int k = 0; k < 40; ++k) {
    run(*dem, scene.dt, step, 100);
    maximum = std::max(maximum, dem->energy().kinetic);
  }
  INFO("overlap " << overlap << ": stored " << stored << " J, kinetic " << maximum << " J");
  CHECK(dem->counts().bonds_intact == 0);
  CHECK(maximum <= stored * (1 + 1e-6));
  CHECK(std::abs(dem->energy().residual()) <= 0.02 * stored);
}

TEST_CASE("H40 a hysteretic contact that has opened starts without history, whatever the neighbour lists", "[hard]") {
  // A sphere between two plates: each rebound has the restitution, although the lists still contain the old contact.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double skin = GENERATE(0.0, 1e-4, 0.05), restitution = 0.6, radius = 0.01, gap = 1e-4, speed = 2;
  Scene scene = scene_of(soft_rock(), rigid(), remembering(restitution, 0, 0), 1e-7);
  scene.neighbour_skin = skin;
  scene.walls = {{"bottom", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1},
                 {"top", PlaneShape{{0, 0, 2 * radius + gap}, {0, 0, -1}}, Fixed{}, 1}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{sphere(0, {0, 0, radius + 0.5 * gap}, {0, 0, -speed}, radius, rock_density)};
  dem->insert(rocks);
  std::int64_t step = 0;
  double last = speed, direction = -1;
  for (int impacts = 0; impacts < 6 && step < 200000;) {
    run(*dem, scene.dt, step, 1);
    const ParticleSnapshot s = dem->particles();
    if (s.velocity[0].z * direction >= 0 || s.position[0].z < radius || s.position[0].z > radius + gap) continue;
    CAPTURE(skin, impacts, step);
    CHECK(norm(s.velocity[0]) / last == Approx(restitution).epsilon(1e-3));
    last = norm(s.velocity[0]);
    direction = -direction;
    ++impacts;
  }
  CHECK(last == Approx(speed * std::pow(restitution, 6)).epsilon(5e-3));
}
