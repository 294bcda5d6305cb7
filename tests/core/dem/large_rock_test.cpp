// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds of a rock that is too large for one thread.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/gpu/breaking_scene.hpp"
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/dem/bond_parts.hpp"

#include <array>
#include <map>
#include <set>

using namespace gyro;
using namespace gyro::test;
using namespace gyro::fixtures;

namespace {

/// Bonds of a lattice and, to have bonds of two lengths, of some of its diagonals.
NewRock with_diagonals() {
  NewRock rock = placed(lattice(0, 16), 0, 0, {1, -2, 3}, rotation_about({1, 0, 0}, 0.3));
  for (Index i = 0; i + 17 < static_cast<Index>(rock.particles.size()); i += 5) {
    const auto &a = rock.particles[static_cast<std::size_t>(i)], &b = rock.particles[static_cast<std::size_t>(i) + 17];
    const double length = norm(b.position - a.position);
    if (length < 4 * a.radius) rock.bonds.push_back({i, i + 17, length, rock.bonds[0].radius, 1});
  }
  return rock;
}

/// A block above a floor: its lower layers break.
NewRock falling_block() {
  NewRock block = placed(lattice(0, 15, {0.01, 0.004}), 0, 0, {0, 0, 0.0763}, rotation_about({1, 0, 0}, 0.02));
  REQUIRE(is_large_rock(static_cast<Index>(block.bonds.size())));
  add_rigid_motion(block, {0, 0, -12}, {0, 0, 0});
  return block;
}

struct End {
  ParticleSnapshot particles;
  std::vector<Breakage> breakages;
};

/// Two windows; in between a layer of 15 x 15 particles leaves, and of the next one every seventh; the scene is saved.
template <class Make>
End after_removal(const Make& make) {
  auto dem = make();
  dem->insert(std::array{falling_block()});
  dem->advance({.first_step = 0, .steps = 30, .dt = breaking_dt}, {});
  std::vector<ParticleId> leaving;
  for (ParticleId id = 0; id < 450; id += id < 225 ? 1 : 7) leaving.push_back(id);
  dem->remove(leaving);
  const SavedState saved = dem->save();
  dem = make();
  dem->restore(saved);
  dem->advance({.first_step = 30, .steps = 30, .dt = breaking_dt}, {});
  return {dem->particles(), dem->take_breakages()};
}

}  // namespace

TEST_CASE("Parts have every bond once, and those of a round share no particle", "[dem][bond]") {
  const NewRock rock = with_diagonals();
  const BondParts parts = bond_parts(rock);
  CHECK(std::set(parts.bond.begin(), parts.bond.end()).size() == rock.bonds.size());
  REQUIRE(parts.bond.size() == rock.bonds.size());
  REQUIRE(parts.starts.size() == parts.colour_begin.size());
  CHECK(parts.colour_begin.front() == 0);
  CHECK(parts.colour_begin.back() == static_cast<Index>(rock.bonds.size()));
  CHECK(parts.starts.front() == starts_round);

  int rounds = 0, count = 0;
  std::map<Index, int> part_of;  // of the particles of this round
  for (std::size_t c = 0; c + 1 < parts.colour_begin.size(); ++c) {
    if (parts.starts[c] == starts_round) ++rounds, part_of.clear();
    if (parts.starts[c] != starts_colour) ++count;
    std::set<Index> of_colour;
    REQUIRE(parts.colour_begin[c] < parts.colour_begin[c + 1]);
    for (Index k = parts.colour_begin[c]; k < parts.colour_begin[c + 1]; ++k) {
      const NewBond& b = rock.bonds[static_cast<std::size_t>(parts.bond[static_cast<std::size_t>(k)])];
      for (const Index end : {b.i, b.j}) {
        CHECK(of_colour.insert(end).second);
        CHECK(part_of.emplace(end, count).first->second == count);
      }
    }
  }
  CHECK(rounds == 8);
  CHECK(count > 40);
}

TEST_CASE("A rock of one cell has one part", "[dem][bond]") {
  const BondParts parts = bond_parts(lattice(0, 3));
  CHECK(std::count(parts.starts.begin(), parts.starts.end(), starts_colour) + 1 ==
        static_cast<std::ptrdiff_t>(parts.starts.size()));
}

TEST_CASE("A large rock that loses particles and is restored has the same bits everywhere", "[dem][bits][bond]") {
  Scene scene = breaking_scene();
  scene.substeps = GENERATE(1, 3);
  const auto on_cpu = [&](int threads) {
    return [&, threads] { return make_cpu_dem(scene, Precision::mixed, threads); };
  };
  const End one = after_removal(on_cpu(1));
  CHECK(one.breakages.size() > 5);
  const auto check = [&](const End& other) {
    CHECK(same_breakages(one.breakages, other.breakages));
    CHECK(same_bytes(one.particles.position, other.particles.position));
    CHECK(same_bytes(one.particles.velocity, other.particles.velocity));
  };
  check(after_removal(on_cpu(3)));
  DeviceMemory::instance().forget();
  check(after_removal([&] { return std::make_unique<DemSolver<Mirror, float>>(scene, Mirror{}); }));
}
