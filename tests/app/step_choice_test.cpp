// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of two rates: how long contacts are held, and how many steps the bonds of a rock take meanwhile.
#include "tests/app/rock_setup.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::test;

TEST_CASE("Contacts are held for half their undamped limit, and bonds take the steps that they need", "[simulation]") {
  Setup setup = rock_setup();
  REQUIRE(setup.scene.bonds);
  const StepRequest automatic{.rates = {.kind = Rates::Kind::automatic}};
  const StepChoice choice = set_step(setup, automatic);
  CHECK(choice.dt <= 0.5 * choice.contact_limit);
  CHECK(choice.dt > 0.45 * choice.contact_limit);
  CHECK(choice.dt * choice.steps_per_window == Approx(automatic.window));
  CHECK(choice.max_substeps > 1);
  CHECK(choice.bond_step == choice.dt / choice.max_substeps);
  CHECK(choice.bond_step <= 0.7 * choice.limit);
  CHECK(choice.dt / (choice.max_substeps - 1) > 0.7 * choice.limit);
  CHECK(setup.scene.dt == choice.dt);

  const StepChoice careful = choose_step(setup, {.safety = 0.35, .rates = automatic.rates});
  CHECK(careful.dt < 0.52 * choice.dt);
  CHECK(careful.bond_step <= 0.35 * careful.limit);

  setup.scene.bonds->damping = 0;
  CHECK(choose_step(setup, automatic).dt <= 0.35 * choice.contact_limit);
}

TEST_CASE("A given hold is taken, and refused above its share of the limit", "[simulation]") {
  Setup setup = rock_setup();
  const double limit = choose_step(setup, {.rates = {.kind = Rates::Kind::automatic}}).contact_limit;
  const auto with = [&](double hold) {
    return choose_step(setup, {.rates = {.kind = Rates::Kind::given, .hold = hold}});
  };
  CHECK(with(0.2 * limit).dt == Approx(0.2 * limit).epsilon(0.2));
  CHECK(with(0.2 * limit).dt <= 0.2 * limit);
  CHECK_THROWS_AS(with(0.51 * limit), BadHold);
  CHECK_THROWS_AS(with(1e-15), BadHold);
  CHECK_THROWS_WITH(choose_step(setup, {.step = 1e-16, .rates = {.kind = Rates::Kind::automatic}}),
                    Catch::Matchers::Contains("more than 1e9 steps"));
  setup.scene.bonds.reset();  // the same for loose particles, whose contacts may take longer steps
  CHECK(with(0.2 * limit).dt <= 0.2 * limit);
  CHECK(choose_step(setup, {.step = 0.3 * limit, .rates = {.kind = Rates::Kind::given, .hold = 0.2 * limit}}).dt <=
        0.2 * limit);
  CHECK_THROWS_AS(with(0.8 * limit), BadHold);
}

TEST_CASE("A rock whose bonds allow the hold must be stable with its contacts, too", "[simulation]") {
  Setup setup = rock_setup();
  for (RockTemplate& rock : setup.library.rocks) rock.bond_step = 1, rock.critical_step = 1e-7;
  const StepChoice choice = choose_step(setup, {.rates = {.kind = Rates::Kind::automatic}});
  CHECK(choice.max_substeps == 2);
}
