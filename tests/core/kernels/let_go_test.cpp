// SPDX-License-Identifier: GPL-3.0-or-later
// Which broken bonds become ordinary contacts.
#include "core/kernels/let_go.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "core/laws/bond/constants.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <vector>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// Two spheres with a broken bond between them. @param shorter  than its length is the bond [m]
/// @param overlap  of the spheres at the bond's length [m]
struct PressedPair {
  std::vector<Sphere> position;
  std::vector<Motion> motion{2, Motion{{0, 0, 0}, 1}};
  std::vector<AngularMotion> angular{2, AngularMotion{{0, 0, 0}, 1}};
  std::vector<Quatd> orientation{2, Quatd{1, 0, 0, 0}};
  std::vector<Index> block{0, 0}, i{0}, j{1};
  std::vector<double> step{1e-6, 1e-6};
  std::vector<double> axis_x{1}, axis_y{0}, axis_z{0}, length, radius{grain_bond}, arm{0.5}, strength{1}, root{1},
      root_inertia{1};
  std::vector<std::int32_t> state{bond_pressed};
  std::vector<Block> blocks{Block{}};
  Scene scene = bonded_scene(1e-6, paper_bonds());

  PressedPair(double shorter, double overlap) {
    length = {grain - overlap};
    position = {{{0, 0, 0}, grain / 2}, {{length[0] - shorter, 0, 0}, grain / 2}};
    blocks[0].free_of_load = 1;
  }
  LetGo<double> kernel(double share) {
    ConstParticleView p{};
    p.position = position.data(), p.motion = motion.data(), p.angular_motion = angular.data();
    p.orientation = orientation.data(), p.block = block.data(), p.step = step.data();
    const ConstBondView<double> b{i.data(),        j.data(),      axis_x.data(),       axis_y.data(),
                                  axis_z.data(),   length.data(), radius.data(),       arm.data(),
                                  strength.data(), root.data(),   root_inertia.data(), state.data()};
    return {.p = p,
            .b = b,
            .state = state.data(),
            .blocks = blocks.data(),
            .law = bond_constants(scene),
            .model = scene.bond_model,
            .contact = contact_constants<double>(scene, 0, 0),
            .contact_model = rock_model(scene),
            .share = share,
            .with_history = keeps_extra_history(rock_model(scene))};
  }
};

/// k_n A of the bond [N/m], and the energy at which it fails in tension [J].
double stiffness() {
  return BondStiffness(paper_bonds()).normal;
}
double breaking_energy() {
  const double force = paper_bonds().tensile_strength * M_PI * grain_bond * grain_bond;
  return 0.5 * force * force / stiffness();
}

}  // namespace

TEST_CASE("A pressed bond is let go by the energy of its spring, and what that was is returned", "[levels]") {
  const double share = 0.01, limit = std::sqrt(2 * share * breaking_energy() / stiffness());
  for (const double of_limit : {-1.0, 0.5, 0.99}) {  // a gap of 0.1 mm between the spheres: no contact
    PressedPair pair(of_limit * limit, -1e-4);
    const double spring = of_limit > 0 ? 0.5 * stiffness() * std::pow(of_limit * limit, 2) : 0;
    CHECK(pair.kernel(share)(0) == Approx(spring).epsilon(1e-9).margin(1e-18));
    pair.kernel(share).let_go(0);
    CHECK(pair.state[0] == bond_broken);
  }
  PressedPair pair(1.01 * limit, -1e-4);
  CHECK(pair.kernel(share)(0) == 0);
  pair.kernel(share).let_go(0);
  CHECK(pair.state[0] == bond_pressed);
}

TEST_CASE("A pressed bond is kept where the contact that replaces it would push spheres apart", "[levels]") {
  // Hertz: E = 8/15 E* sqrt(R*) overlap^(5/2), with the paper's modulus of 1.5 GPa.
  const double share = 0.01, effective = 1.5e9 / (2 * (1 - 0.35 * 0.35)), radius = grain / 4;
  const double limit = std::pow(share * breaking_energy() / (8.0 / 15 * effective * std::sqrt(radius)), 0.4);
  PressedPair less(0, 0.99 * limit), more(0, 1.01 * limit);
  CHECK(less.kernel(share)(0) == Approx(-share * breaking_energy() * std::pow(0.99, 2.5)).epsilon(1e-6));
  CHECK(more.kernel(share)(0) == 0);
  less.kernel(share).let_go(0);
  more.kernel(share).let_go(0);
  CHECK(less.state[0] == bond_broken);
  CHECK(more.state[0] == bond_pressed);
}

TEST_CASE("Intact bonds, those of rigid rocks and of rocks that arrived under load are kept", "[levels]") {
  PressedPair pair(0, 0);
  SECTION("intact") {
    pair.state[0] = bond_intact;
  }
  SECTION("rigid") {
    pair.blocks[0].rigid = 1;
  }
  SECTION("under load") {
    pair.blocks[0].free_of_load = 0;
  }
  const std::int32_t before = pair.state[0];
  CHECK(pair.kernel(0.01)(0) == 0);
  pair.kernel(0.01).let_go(0);
  CHECK(pair.state[0] == before);
}

TEST_CASE("What the force of a bond that is let go does in the next half kick is not lost", "[levels]") {
  const double share = 0.01, shorter = 0.5 * std::sqrt(2 * share * breaking_energy() / stiffness()), speed = 1e-3;
  PressedPair at_rest(shorter, -1e-4), parting(shorter, -1e-4);
  parting.motion[1].v = {speed, 0, 0};
  const double work = 0.5 * 1e-6 * stiffness() * shorter * speed;
  CHECK(at_rest.kernel(share)(0) - parting.kernel(share)(0) == Approx(work).epsilon(1e-3));
}

TEST_CASE("Under a contact law with history bonds are let go only where spheres do not touch", "[levels]") {
  for (const double overlap : {-1e-5, 1e-7}) {
    PressedPair pair(0, overlap);
    pair.scene.pairs.assign(4, {0, 0.5, 0});
    LetGo<double> kernel = pair.kernel(0.01);
    kernel.with_history = true;
    kernel.let_go(0);
    CHECK((pair.state[0] == bond_broken) == (overlap < 0));
  }
}
