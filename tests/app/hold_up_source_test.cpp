// SPDX-License-Identifier: GPL-3.0-or-later
// The fragments that feed.initial_from finds in a saved run.
#include "app/assembly/initial_from.hpp"
#include "core/fragments/fragment_table.hpp"
#include "small_crusher.hpp"
#include "tests/catch.hpp"

#include <numbers>
#include <set>

using namespace gyro;

TEST_CASE("A saved run gives the fragments that are in its chamber, turned about the axis") {
  SmallCrusher crusher({"feed.initial=1.5", "feed.initial_top=250 mm"});
  Simulation& simulation = crusher.simulation;
  const SavedState at_start = simulation.save();
  for (const SourceFragment& f : hold_up_of(at_start, 0)) CHECK((f.whole && !f.single));
  while (simulation.time() < 0.2 || simulation.discharged_mass() == 0) simulation.advance();
  const ParticleSnapshot particles = simulation.dem().particles();
  const FragmentTable table = fragment_table(particles);
  const std::vector<SourceFragment> found = hold_up_of(simulation.save(), std::numbers::pi / 2);
  std::size_t inside = 0, whole = 0, singles = 0;
  double mass = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const Fragment& f = table.rows[row];
    if (simulation.product()->has_left(particles.id[static_cast<std::size_t>(f.first_particle)])) continue;
    REQUIRE(inside < found.size());
    const SourceFragment& s = found[inside++];
    CHECK(s.mass == Approx(f.mass));
    CHECK(norm(s.centre - Vec3d{-f.centre.y, f.centre.x, f.centre.z}) < 1e-12);
    CHECK(s.single == (f.particles == 1));
    const Vec3d v = particles.velocity[static_cast<std::size_t>(f.first_particle)];
    if (s.single) CHECK(norm(s.velocity - Vec3d{-v.y, v.x, v.z}) < 1e-12);
    CHECK((s.radius > 0 && s.radius < f.highest - f.lowest));
    whole += s.whole ? 1 : 0;
    singles += s.single ? 1 : 0;
    mass += s.mass;
  }
  CHECK(inside == found.size());
  CHECK(mass == Approx(simulation.holdup()).epsilon(1e-9));
  CHECK((singles > 0 && singles < inside));
  std::set<RockId> unbroken(particles.rock.begin(), particles.rock.end());
  CHECK(whole < unbroken.size());  // some are broken
}
