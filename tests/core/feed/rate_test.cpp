// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

RockLibrary library() {
  RockLibrary l;
  for (const double d : {0.1, 0.15, 0.2}) l.rocks.push_back(ball_rock(d, 3));
  return l;
}

FeedPlan rate_plan(double rate) {
  FeedPlan plan;
  plan.rate = rate;
  plan.start = 0.5;
  plan.entry = CylinderRegion{{0, 0, 1}, 0.6, 0.4};
  plan.seed = 5;
  return plan;
}

void append(std::vector<NewRock>& all, std::vector<NewRock> more) {
  for (NewRock& rock : more) all.push_back(std::move(rock));
}

/// Rocks in free fall: after a time t since it was placed, a rock has fallen by g t^2/2.
ParticleSnapshot fallen(const std::vector<NewRock>& rocks, const std::vector<double>& born, double time) {
  ParticleSnapshot p = snapshot_of(rocks);
  std::size_t row = 0;
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    for (std::size_t i = 0; i < rocks[k].particles.size(); ++i) {
      p.position[row++].z -= 4.905 * (time - born[k]) * (time - born[k]);
    }
  }
  return p;
}

}  // namespace

TEST_CASE("A rate is fed to within half a rock while there is room", "[feed]") {
  const RockLibrary rocks = library();
  Feed feed(rocks, rate_plan(100), {});
  std::vector<NewRock> all;
  std::vector<double> born;
  CHECK(!feed.wants(0.4));
  CHECK(feed.due(0.4, {}, {}).empty());
  for (int k = 0; k <= 3000; ++k) {
    const double time = 1e-3 * k;
    if (!feed.wants(time)) continue;
    const ParticleSnapshot present = fallen(all, born, time);
    const std::vector<NewRock> fresh = feed.due(time, {}, present);
    // No overlap with the falling rocks.
    for (const NewRock& rock : fresh) {
      for (const NewParticle& n : rock.particles) {
        CHECK(std::hypot(n.position.x, n.position.y) + n.radius <= 0.6);
        CHECK((n.position.z - n.radius >= 1 - 1e-12 && n.position.z + n.radius <= 1.4 + 1e-12));
        CHECK((n.velocity.z == 0 && n.angular_velocity.z == 0));
        for (std::size_t i = 0; i < present.size(); ++i) {
          if (norm(n.position - present.position[i]) < n.radius + present.radius[i]) FAIL("overlap");
        }
      }
    }
    append(all, fresh);
    born.resize(all.size(), time);
    CHECK(std::abs(feed.owed(time) - feed.account().mass) <= 0.5 * feed.template_mass(2) * (1 + 1e-9));
  }
  CHECK(feed.account().delayed == 0);
  CHECK(feed.owed(3.0) == Approx(250.0));
  CHECK(feed.account().mass == Approx(250.0).margin(0.5 * feed.template_mass(2)));
}

TEST_CASE("Rocks without room wait and are never dropped", "[feed]") {
  const RockLibrary rocks = library();
  FeedPlan plan = rate_plan(0);
  plan.batch = 2000;  // far more than fits into the entry region
  plan.start = 0;
  Feed feed(rocks, plan, {});
  const std::vector<NewRock> first = feed.due(0, {}, {});
  const FeedAccount full = feed.account();
  CHECK(full.rocks == static_cast<std::int64_t>(first.size()));
  CHECK(full.delayed == 1);
  CHECK(full.waiting == Approx(2000 - full.mass).epsilon(1e-12));
  CHECK(smallest_gap(first) >= 1e-4 * (1 - 1e-6));

  // Still full: the next attempt is made only after the retry time.
  CHECK(!feed.wants(0.005));
  CHECK(feed.wants(0.011));
  std::vector<NewRock> all = first;
  append(all, feed.due(0.011, {}, snapshot_of(all)));
  CHECK(smallest_gap(all) >= 1e-4 * (1 - 1e-6));

  // If the entry is emptied repeatedly, all rocks are fed in order, each id once.
  double time = 1;
  for (int k = 0; k < 1000 && feed.wants(time); ++k, time += 0.1) append(all, feed.due(time, {}, {}));
  CHECK(!feed.wants(1e6));
  const FeedAccount done = feed.account();
  CHECK(done.mass == Approx(2000).margin(0.5 * feed.template_mass(2)));
  CHECK(done.waiting == 0);
  CHECK(done.rocks == static_cast<std::int64_t>(all.size()));
  ParticleId next = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    CHECK(all[k].id == static_cast<RockId>(k));
    for (const NewParticle& p : all[k].particles) CHECK(p.id == next++);
  }
  CHECK(done.particles == static_cast<std::int64_t>(next));

  // The kinds drawn do not depend on how long rocks waited.
  FeedPlan roomy = plan;
  roomy.entry = BoxRegion{{-5, -5, 0}, {5, 5, 1}};
  Feed other(rocks, roomy, {});
  const std::vector<NewRock> at_once = other.due(0, {}, {});
  REQUIRE(at_once.size() == all.size());
  for (std::size_t k = 0; k < all.size(); ++k) CHECK(at_once[k].particles.size() == all[k].particles.size());
}

TEST_CASE("A feed that continues from its saved state gives the same rocks", "[feed]") {
  const RockLibrary rocks = library();
  Feed whole(rocks, rate_plan(300), {}), first(rocks, rate_plan(300), {});
  for (double time = 0.5; time < 1; time += 0.05) {
    whole.due(time, {}, {});
    first.due(time, {}, {});
  }
  Feed second(rocks, rate_plan(300), {});
  second.restore(first.state());
  const std::vector<NewRock> a = whole.due(1.3, {}, {}), b = second.due(1.3, {}, {});
  REQUIRE(a.size() == b.size());
  REQUIRE(!a.empty());
  for (std::size_t k = 0; k < a.size(); ++k) {
    CHECK(a[k].id == b[k].id);
    CHECK(a[k].particles[0].position.x == b[k].particles[0].position.x);
  }
}
