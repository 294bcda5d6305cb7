// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled run as a library: setups filled by hand, without a case file.
#include "app/simulation/simulation.hpp"
#include "core/base/errors.hpp"
#include "core/dem/make_dem.hpp"
#include "core/rocks/library.hpp"
#include "mbd/drivetrain.hpp"
#include "tests/app/rock_setup.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;

namespace {

/// A floor and one bonded rock of 60 mm in the air above it.
Setup dropped_rock(double height) {
  Setup setup = test::rock_setup();
  setup.scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1}};
  setup.feed = FeedPlan{};
  setup.feed->fixed = {{0, {0, 0, height}}};
  set_step(setup);
  return setup;
}

Simulation simulation_of(const Setup& setup) {
  return {setup, make_cpu_dem(setup.scene, Precision::double_, 1)};
}

double lowest(const Simulation& run) {
  const ParticleSnapshot s = run.dem().particles();
  double low = 1e300;
  for (std::size_t k = 0; k < s.size(); ++k) low = std::min(low, s.position[k].z - s.radius[k]);
  return low;
}

/// The reason why a setup is refused, and the part that causes it.
std::pair<std::string, SetupPart> refusal(const Setup& setup) {
  try {
    simulation_of(setup);
  } catch (const BadSetup& bad) {
    return {bad.what(), bad.part};
  }
  return {"", SetupPart::scene};
}

}  // namespace

TEST_CASE("A bonded rock falls freely without a case file", "[simulation]") {
  const Setup setup = dropped_rock(0.5);
  Simulation run(setup, make_cpu_dem(setup.scene, Precision::double_, 1));
  const double start = lowest(run);
  CHECK(run.bonds_initial() > 20);
  CHECK(run.fragments() == 1);
  while (run.time() < 0.1) run.advance();
  CHECK(lowest(run) - start == Approx(-0.5 * 9.81 * run.time() * run.time()).epsilon(1e-6));
  CHECK(run.ledger().residual_fraction() == Approx(0).margin(1e-9));
  CHECK_FALSE(run.verdict());
}

TEST_CASE("A rock that falls on a floor at 20 m/s breaks, and its breakages come window by window", "[simulation]") {
  Setup setup = dropped_rock(0.2);
  setup.scene.gravity.z *= 100;  // 20 m/s after 0.2 m and 20 ms
  setup.inspection_interval = 0;
  Simulation run(setup, make_cpu_dem(setup.scene, Precision::double_, 1));
  std::size_t breakages = 0;
  double last = 0;
  while (run.time() < 0.022) {
    const WindowResult window = run.advance();
    CHECK_FALSE(window.inspected);
    for (const Breakage& b : window.breakages) {
      CHECK(b.time >= last);
      CHECK(b.time <= run.time());
      last = b.time;
    }
    breakages += window.breakages.size();
  }
  const Counts counts = run.dem().counts();
  CHECK(breakages > 0);
  CHECK(static_cast<std::int64_t>(breakages) == counts.broken_tension + counts.broken_shear);
  CHECK(run.fragments() == 1);  // not inspected since the start
  run.inspect();
  CHECK(run.fragments() > 1);
}

TEST_CASE("Inspections come at their interval, and product is counted and removed without any output", "[simulation]") {
  Setup setup = dropped_rock(0.05);
  setup.scene.walls.clear();
  setup.discharge = Discharge{0.1};
  setup.inspection_interval = 2.2e-3;
  Simulation run(setup, make_cpu_dem(setup.scene, Precision::double_, 1));
  const double window = setup.steps_per_window * setup.scene.dt;
  const double mass = run.holdup();
  int inspections = 0;
  while (run.time() < 0.3) {
    const double before = run.time();
    const WindowResult result = run.advance();
    inspections += result.inspected;
    const bool due = std::floor(run.time() / 2.2e-3 + 1e-9) > std::floor(before / 2.2e-3 + 1e-9);
    CHECK(result.inspected == due);
  }
  CHECK(window == Approx(0.5e-3));
  CHECK(inspections == 136);
  CHECK(run.product()->state().mass == Approx(mass));
  CHECK(run.dem().counts().particles == 0);
  CHECK(run.mass_count().residual() == 0);
}

namespace {

NewRock sphere_at(ParticleId id, const Vec3d& position, const Vec3d& velocity) {
  NewRock rock;
  rock.id = static_cast<RockId>(id);
  rock.particles.push_back({id, position, velocity, {0, 0, 0}, 0.01, 2600});
  return rock;
}

/// A cone that opens from 0.1 m at z = 0 to 0.2 m at its rim, 0.3 m above. Two spheres fly over the rim, one rolls off
/// it, one falls through the opening.
Setup spilling_chamber() {
  Setup setup;
  Scene& scene = setup.scene;
  scene.materials = {{"rock", 2600, 557e6, 0.35}};
  scene.pairs = {{0.5, 0.2, 0}};
  const ProfileShape cone{{{0.1, 0}, {0.2, 0.3}}};
  scene.walls = {{"concave", cone, Fixed{}, 0}};
  setup.start = {sphere_at(0, {0.1, 0, 0.35}, {2, 0, 0}), sphere_at(1, {0, 0.1, 0.4}, {0, 3, 0}),
                 sphere_at(2, {-0.2005, 0, 0.32}, {-0.1, 0, 0}), sphere_at(3, {0, 0, 0.2}, {0, 0, 0})};
  setup.discharge = Discharge{0.05, ConcaveOutline(cone.points)};
  set_step(setup);
  return setup;
}

}  // namespace

TEST_CASE("Rock that leaves over the rim is counted separately from the product, also after a restart",
          "[simulation]") {
  const Setup setup = spilling_chamber();
  const auto make = [&](const SavedState* saved) {
    return std::make_unique<Simulation>(setup, make_cpu_dem(setup.scene, Precision::double_, 1),
                                        std::optional<Drivetrain>(), saved);
  };
  auto run = make(nullptr);
  const double one = run->start_mass() / 4;
  CHECK(run->setup().start.empty());  // the scene has it: no second copy
  bool restarted = false;
  while (run->time() < 0.8) {
    run->advance();
    REQUIRE_FALSE(run->verdict());
    CHECK(run->mass_count().residual() == 0);
    CHECK(run->holdup() == Approx(4 * one - run->discharged_mass() - run->escaped_mass()).margin(1e-12));
    if (!restarted && run->escaped_mass() > 0) {
      const SavedState saved = run->save();
      run = make(&saved);
      CHECK(run->setup().start.empty());
      restarted = true;
    }
  }
  CHECK(restarted);
  CHECK(run->escaped_mass() == Approx(3 * one));
  CHECK(run->escaped_fraction() == Approx(0.75));
  CHECK(run->discharged_mass() == Approx(one));
  CHECK(run->product()->row(run->time()).mass == Approx(one));
  CHECK(run->holdup() == Approx(0).margin(1e-12));
  CHECK(run->mass_count().escaped == 3);
  CHECK(run->dem().counts().particles == 0);  // all were removed
}

TEST_CASE("Without gravity and with fixed walls the residual is a share of the energy", "[simulation]") {
  Setup setup = spilling_chamber();
  setup.scene.gravity = {0, 0, 0};
  setup.start = {sphere_at(0, {0, 0, 0.15}, {3, 0, 0})};
  setup.discharge.reset();
  set_step(setup);
  Simulation run(setup, make_cpu_dem(setup.scene, Precision::double_, 1));
  const double kinetic = run.dem().energy().kinetic;
  while (run.time() < 0.1) run.advance();
  const EnergyTerms end = run.ledger().energy();
  REQUIRE(end.kinetic < 0.9 * kinetic);  // it has touched the wall
  REQUIRE(end.residual() != 0);
  CHECK(run.ledger().residual_fraction() == Approx(end.residual() / kinetic).epsilon(1e-12));
  CHECK(std::abs(run.ledger().residual_fraction()) < 0.01);
}

TEST_CASE("A driven mantle needs no case file, and its energy account closes", "[simulation]") {
  Setup setup;
  Scene& scene = setup.scene;
  scene.materials = {{"rock", 2600, 557e6, 0.35}};
  scene.pairs = {{0.5, 0.2, 0}};
  // A pyramid below its pivot, and a sphere on a floor that it reaches after half a revolution.
  const TriangleMesh cone{{{0, 0, 0.5}, {0.1, 0, 0}, {0, 0.1, 0}, {-0.1, 0, 0}, {0, -0.1, 0}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
  scene.walls = {{"mantle", cone, GyrationMotion{0.005, 1.0}, 0},
                 {"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 0}};
  NewRock sphere;
  sphere.id = none;
  sphere.particles.push_back({0, {-0.1185, 0, 0.02}, {0, 0, 0}, {0, 0, 0}, 0.02, 2600});
  setup.start = {sphere};
  const StepChoice step = set_step(setup, {.window = 0.25e-3});
  CHECK(step.steps_per_window == setup.steps_per_window);
  CHECK(step.dt < 0.7 * step.limit * (1 + 1e-12));
  DrivetrainParameters drive;
  drive.motor = DroopMotor{.synchronous_speed = 60, .stall_torque = 10};
  drive.eccentric_inertia = 0.5;
  Simulation run(setup, make_cpu_dem(scene, Precision::double_, 1), Drivetrain(drive));
  double work = 0;
  while (run.time() < 0.3) work += run.advance().load.work;
  CHECK(run.drivetrain()->state().rock_work == Approx(work));
  CHECK(work > 1e-3);
  CHECK(std::abs(run.drivetrain()->energy_residual()) < 0.01 * work);
  CHECK_FALSE(run.verdict());
}

TEST_CASE("A saved simulation continues with the same bits", "[simulation]") {
  Setup setup = dropped_rock(0.06);
  setup.discharge = Discharge{0};
  Simulation whole(setup, make_cpu_dem(setup.scene, Precision::mixed, 1));
  while (whole.time() < 0.02) whole.advance();
  const SavedState saved = whole.save();
  Simulation part(setup, make_cpu_dem(setup.scene, Precision::mixed, 1), {}, &saved);
  CHECK(part.time() == whole.time());
  while (whole.time() < 0.04) {
    const WindowResult a = whole.advance(), b = part.advance();
    CHECK(a.inspected == b.inspected);
  }
  const ParticleSnapshot a = whole.dem().particles(), b = part.dem().particles();
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) CHECK(a.position[k].z == b.position[k].z);
  CHECK(whole.ledger().energy().residual() == part.ledger().energy().residual());
  CHECK(whole.momentum().residual() == part.momentum().residual());
  setup.scene.dt *= 0.5;
  CHECK_THROWS_WITH(Simulation(setup, make_cpu_dem(setup.scene, Precision::mixed, 1), {}, &saved),
                    Catch::Matchers::Contains("was written with a time step"));
}

TEST_CASE("A setup that cannot be run is refused, with the part that causes it", "[simulation]") {
  const Setup good = dropped_rock(0.5);
  CHECK(refusal(good).first.empty());
  const auto part = [&](auto change) {
    Setup bad = good;
    change(bad);
    const auto [problem, blamed] = refusal(bad);
    CAPTURE(problem);
    CHECK_FALSE(problem.empty());
    return blamed;
  };
  CHECK(part([](Setup& s) { s.scene.pairs.pop_back(); }) == SetupPart::scene);
  CHECK(part([](Setup& s) { s.scene.rock_material = 2; }) == SetupPart::scene);
  CHECK(part([](Setup& s) { s.scene.walls[0].material = 7; }) == SetupPart::scene);
  CHECK(part([](Setup& s) { s.scene.materials[0].density = 0; }) == SetupPart::scene);
  CHECK(part([](Setup& s) { s.scene.dt = 0; }) == SetupPart::step);
  CHECK(part([](Setup& s) { s.steps_per_window = 0; }) == SetupPart::step);
  CHECK(part([](Setup& s) { s.inspection_interval = -1; }) == SetupPart::step);
  CHECK(part([](Setup& s) { s.feed->fixed[0].position.z = 0; }) == SetupPart::feed);
  CHECK(part([](Setup& s) { s.feed->initial = 5; }) == SetupPart::feed);
  CHECK(part([](Setup& s) {
          NewRock rock;
          rock.id = none;
          rock.particles.push_back({0, {0, 0, -1}, {0, 0, 0}, {0, 0, 0}, 0.01, 2600});
          s.start = {rock};
        }) == SetupPart::start);
}

TEST_CASE("A given step must be below its limit", "[simulation]") {
  Setup setup = dropped_rock(0.5);
  const double limit = set_step(setup).limit;
  CHECK_NOTHROW(set_step(setup, {.step = 0.7 * limit}));
  CHECK_THROWS_WITH(set_step(setup, {.step = 0.71 * limit}), Catch::Matchers::Contains("of the stability limit"));
  const StepRequest many{.rates = {.kind = Rates::Kind::uniform, .substeps = 1000}};
  CHECK_THROWS_AS(set_step(setup, many), BadHold);
  CHECK_THROWS_WITH(set_step(setup, many), Catch::Matchers::Contains("of their stability limit"));
}

namespace {

/// A scene that nobody may look at between a window that was given up and restore().
class Unseen final : public Dem {
 public:
  explicit Unseen(std::unique_ptr<Dem> dem) : dem_(std::move(dem)) {}
  void advance(const Window& window, const MantlePath& path) override {
    in_window_ = true;
    dem_->advance(window, path);
    in_window_ = false;
  }
  void give_up_when(GiveUp condition) override { dem_->give_up_when(std::move(condition)); }
  void insert(std::span<const NewRock> rocks) override { seen().insert(rocks); }
  void remove(std::span<const ParticleId> ids) override { seen().remove(ids); }
  std::vector<WallPose> wall_poses() const override { return seen().wall_poses(); }
  std::vector<std::pair<std::string, double>> phase_seconds() const override { return dem_->phase_seconds(); }
  std::vector<WallLoad> wall_loads() const override { return dem_->wall_loads(); }
  EnergyTerms energy() const override { return seen().energy(); }
  Extremes extremes() const override { return seen().extremes(); }
  Counts counts() const override { return dem_->counts(); }
  Vec3d momentum() const override { return seen().momentum(); }
  ParticleSnapshot particles() const override { return seen().particles(); }
  BondSnapshot bonds() const override { return seen().bonds(); }
  std::vector<Breakage> take_breakages() override { return dem_->take_breakages(); }
  std::vector<WallImpulse> take_wall_impulses() override { return dem_->take_wall_impulses(); }
  SavedState save() const override { return seen().save(); }
  void restore(const SavedState& saved) override { dem_->restore(saved); }

 private:
  Dem& seen() const {
    REQUIRE_FALSE(in_window_);
    return *dem_;
  }
  std::unique_ptr<Dem> dem_;
  bool in_window_ = false;
};

}  // namespace

TEST_CASE("The mass balance of a run whose window was given up is that of its last inspection, also when resumed",
          "[simulation]") {
  const Setup setup = spilling_chamber();
  const auto make = [&](const SavedState* saved) {
    auto dem = std::make_unique<Unseen>(make_cpu_dem(setup.scene, Precision::double_, 1));
    return std::make_unique<Simulation>(setup, std::move(dem), std::optional<Drivetrain>(), saved);
  };
  std::unique_ptr<Simulation> run = make(nullptr);
  run->advance();
  if (GENERATE(false, true)) {
    const SavedState saved = run->save();
    run = make(&saved);
  }
  run->give_up_windows_when([](double share) { return share >= 0.5; });
  CHECK_THROWS_AS(run->advance(), WindowGivenUp);
  CHECK(run->mass_count().inside == 4);
  CHECK(run->mass_count().residual() == 0);
}

TEST_CASE("A window that is given up never was, and the run goes on from the saved state with the same bits",
          "[simulation]") {
  Setup setup = dropped_rock(0.06);
  const auto make = [&](const SavedState* saved) {
    return std::make_unique<Simulation>(setup, make_cpu_dem(setup.scene, Precision::mixed, 1),
                                        std::optional<Drivetrain>(), saved);
  };
  const std::unique_ptr<Simulation> whole = make(nullptr);
  for (int k = 0; k < 10; ++k) whole->advance();
  std::unique_ptr<Simulation> run = make(nullptr);
  for (int k = 0; k < 5; ++k) run->advance();
  const SavedState saved = run->save();
  const double time = run->time();
  const std::int64_t steps = run->dem().counts().particle_steps;
  std::vector<double> shares;
  run->give_up_windows_when([&](double share) {
    shares.push_back(share);
    return share >= 0.5;
  });
  CHECK_THROWS_AS(run->advance(), WindowGivenUp);
  CHECK(shares.front() == 0);
  CHECK(shares.back() == Approx(0.5).margin(1.0 / setup.steps_per_window));
  CHECK(run->time() == time);
  CHECK(run->dem().counts().particle_steps == steps);
  run = make(&saved);
  run->give_up_windows_when([](double) { return false; });
  for (int k = 0; k < 5; ++k) run->advance();
  const ParticleSnapshot a = whole->dem().particles(), b = run->dem().particles();
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) CHECK(a.position[k].z == b.position[k].z);
}
