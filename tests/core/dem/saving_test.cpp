// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that is saved and continued in another solver has the same bits as one without interruption.
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <array>
#include <functional>

using namespace gyro;
using namespace gyro::test;

namespace {

using Make = std::function<std::unique_ptr<Dem>()>;

/// A scene that is saved and restored into another solver before each window; the makers alternate.
class Restarting final : public Dem {
 public:
  explicit Restarting(std::vector<Make> makers) : makers_(std::move(makers)), dem_(makers_.front()()) {}

  void advance(const Window& window, const MantlePath& path) override {
    const SavedState saved = dem_->save();
    dem_ = makers_[++restarts_ % makers_.size()]();
    dem_->restore(saved);
    dem_->advance(window, path);
  }
  void give_up_when(GiveUp condition) override { dem_->give_up_when(std::move(condition)); }
  void insert(std::span<const NewRock> rocks) override { dem_->insert(rocks); }
  void remove(std::span<const ParticleId> ids) override { dem_->remove(ids); }
  std::vector<WallPose> wall_poses() const override { return dem_->wall_poses(); }
  std::vector<std::pair<std::string, double>> phase_seconds() const override { return dem_->phase_seconds(); }
  std::vector<WallLoad> wall_loads() const override { return dem_->wall_loads(); }
  EnergyTerms energy() const override { return dem_->energy(); }
  Extremes extremes() const override { return dem_->extremes(); }
  Counts counts() const override { return dem_->counts(); }
  Vec3d momentum() const override { return dem_->momentum(); }
  ParticleSnapshot particles() const override { return dem_->particles(); }
  BondSnapshot bonds() const override { return dem_->bonds(); }
  std::vector<Breakage> take_breakages() override { return dem_->take_breakages(); }
  std::vector<WallImpulse> take_wall_impulses() override { return dem_->take_wall_impulses(); }
  SavedState save() const override { return dem_->save(); }
  void restore(const SavedState& saved) override { dem_->restore(saved); }

 private:
  std::vector<Make> makers_;
  std::size_t restarts_ = 0;
  std::unique_ptr<Dem> dem_;
};

Make on_cpu(Precision precision, int threads, int hold = 1) {
  Scene scene = breaking_scene();
  scene.substeps = hold;
  return [=] { return make_cpu_dem(scene, precision, threads); };
}

template <class Real>
std::unique_ptr<Dem> on_mirror() {
  return std::make_unique<DemSolver<Mirror, Real>>(breaking_scene(), Mirror{});
}

bool same_columns(const SavedState& a, const SavedState& b) {
  return std::equal(
      a.columns().begin(), a.columns().end(), b.columns().begin(), b.columns().end(), [](const auto& x, const auto& y) {
        return x.first == y.first && x.second.width == y.second.width && x.second.numbers == y.second.numbers;
      });
}

/// The scene while its rocks break.
std::unique_ptr<Dem> busy(Precision precision, int hold = 1) {
  auto dem = on_cpu(precision, 1, hold)();
  dem->insert(falling_rocks(0, 0, 0.045));
  std::int64_t step = 0;
  run(*dem, breaking_dt, step, 3000, 150);
  return dem;
}

}  // namespace

TEST_CASE("A run that is restarted before every window has the same bits as one without restarts", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  const int hold = GENERATE(1, 3);
  const Outcome whole = break_rocks(*on_cpu(precision, 1, hold)());
  require_busy(whole);
  Restarting restarting({on_cpu(precision, 1, hold), on_cpu(precision, 2, hold)});
  Outcome parts = break_rocks(restarting);
  CHECK(parts.counts.rebuilds > whole.counts.rebuilds);  // lists are rebuilt after a restart: that changes no bit
  parts.counts.rebuilds = whole.counts.rebuilds;
  check_same(whole, parts);
}

TEST_CASE("A saved state continues with the same bits on another executor", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  DeviceMemory::instance().forget();
  const SavedState saved = busy(precision)->save();
  const auto cpu = on_cpu(precision, 1)(),
             mirror = precision == Precision::mixed ? on_mirror<float>() : on_mirror<double>();
  for (Dem* dem : {cpu.get(), mirror.get()}) {
    dem->restore(saved);
    std::int64_t step = 3000;
    run(*dem, breaking_dt, step, 600, 150);
  }
  CHECK(same_columns(cpu->save(), mirror->save()));
}

TEST_CASE("A restored scene reports and saves the same as the one that was saved", "[dem]") {
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  const int hold = GENERATE(1, 3);
  const auto before = busy(precision, hold), after = on_cpu(precision, 1, hold)();
  const SavedState saved = before->save();
  after->restore(saved);
  REQUIRE(saved.get<Pair>("contacts/pair").size() > 5);
  REQUIRE(saved.get<WallEntry>("wall_contacts/entry").size() > 2);
  REQUIRE(!saved.get<Breakage>("dem/breakages").empty());
  CHECK(same_columns(saved, after->save()));
  CHECK(same_bits(before->particles(), after->particles()));
  CHECK(same_bytes(std::vector{before->energy()}, std::vector{after->energy()}));
  CHECK(same_bytes(before->wall_loads(), after->wall_loads()));
  CHECK(same_bytes(before->wall_poses(), after->wall_poses()));
  CHECK(same_breakages(before->take_breakages(), after->take_breakages()));
  const std::array leaving{before->particles().id[3]};
  for (Dem* dem : {before.get(), after.get()}) dem->remove(leaving);
  CHECK(same_bytes(std::vector{before->energy()}, std::vector{after->energy()}));
}

TEST_CASE("After a window that was given up, a solver can be restored, and continues with the same bits", "[dem]") {
  Scene scene = breaking_scene();
  scene.wall_impulses = true;
  const auto whole = make_cpu_dem(scene, Precision::mixed, 1), given_up = make_cpu_dem(scene, Precision::mixed, 1);
  whole->restore(busy(Precision::mixed)->save());
  whole->take_wall_impulses();
  const SavedState saved = whole->save();

  given_up->restore(saved);
  double asked_last = 0;
  given_up->give_up_when([&](double done) { return (asked_last = done) > 0.9; });
  CHECK_THROWS_AS(given_up->advance({.first_step = 3000, .steps = 3000, .dt = breaking_dt}, {}), WindowGivenUp);
  CHECK(asked_last == Approx(0.9).margin(1e-3));
  given_up->give_up_when({});
  given_up->restore(saved);
  for (Dem* dem : {whole.get(), given_up.get()}) {
    std::int64_t step = 3000;
    run(*dem, breaking_dt, step, 600, 150);
  }
  CHECK(same_columns(whole->save(), given_up->save()));
  const std::vector<WallImpulse> a = whole->take_wall_impulses(), b = given_up->take_wall_impulses();
  REQUIRE(a.size() > 10);
  CHECK(std::ranges::equal(a, b, [](const WallImpulse& x, const WallImpulse& y) {
    return x.wall == y.wall && same(x.centre, y.centre) && same(x.impulse, y.impulse) && x.slip == y.slip;
  }));
}

TEST_CASE("A state of the other precision, or with a column missing or too short, is refused", "[dem]") {
  SavedState saved = busy(Precision::mixed)->save();
  CHECK_THROWS_AS(on_cpu(Precision::double_, 1)()->restore(saved), BadInput);
  const auto dem = on_cpu(Precision::mixed, 1)();
  SavedState missing = saved, shorter = saved;
  missing.columns().erase("particles/angular_motion/velocity");
  CHECK_THROWS_WITH(dem->restore(missing), Catch::Matchers::Contains("particles/angular_motion/velocity"));
  std::vector<double> steps = shorter.get<double>("particles/step");
  steps.pop_back();
  shorter.put("particles/step", steps);
  CHECK_THROWS_WITH(dem->restore(shorter), Catch::Matchers::Contains("rows of particles/step"));
}
