// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ceiling/bond_loop.hpp"

#include "app/bench/speed/start_state.hpp"
#include "core/dem/particle_store.hpp"
#include "core/exec/cpu.hpp"
#include "core/kernels/advance_rocks.hpp"
#include "core/kernels/wide_bond_pack.hpp"
#include "core/laws/bond/models.hpp"
#include "core/math/random.hpp"
#include "core/rocks/bonds.hpp"

#include <ctime>
#include <memory>

namespace gyro::bench {
namespace {

constexpr int rock_size = 136;  // particles, as in S2r
constexpr double dt = 0.5e-6;   // [s], as in S2r
constexpr std::uint64_t seed = 20244;

/// Numbers of the bonds of S2r, with dashpots. No two are equal, so that no two expressions of the law become one.
constexpr BondParameters parameters{.normal_stiffness = 1670e9,
                                    .shear_stiffness = 667e9,
                                    .tensile_strength = 1e9,
                                    .shear_strength = 1.1e9,
                                    .damping = 0.05};

/// A number from -1 to 1.
double scattered(std::size_t thing, std::uint32_t draw) {
  return 2 * uniform(seed, Stream::turn, thing, draw) - 1;
}

/// A rock of S2r whose bonds are stretched by about 1e-4 of their length and whose particles move.
NewRock one_rock() {
  const StartState state = bonded_rocks({.seed = seed, .particles = rock_size});
  NewRock rock{.id = 0, .particles = {}, .bonds = {}, .colour_begin = {}};
  for (std::size_t k = 0; k < state.centres.size(); ++k) {
    const auto three = [&](std::uint32_t first) {
      return Vec3d{scattered(k, first), scattered(k, first + 1), scattered(k, first + 2)};
    };
    rock.particles.push_back({.id = static_cast<ParticleId>(k),
                              .position = state.centres[k],
                              .velocity = three(0),
                              .angular_velocity = three(3),
                              .radius = state.radii[k],
                              .density = 2600});
  }
  std::vector<TemplateBond> bonds;
  for (const auto& [i, j] : state.bonds) {
    const auto at = [&](Index k) { return state.centres[static_cast<std::size_t>(k)]; };
    const double length = norm(at(j) - at(i)) * (1 + 1e-4 * scattered(bonds.size(), 6));
    bonds.push_back({i, j, length, 0.5 * state.radii.front()});
  }
  rock.colour_begin = colour_bonds(bonds, rock_size);
  for (const TemplateBond& bond : bonds) rock.bonds.push_back({bond.i, bond.j, bond.length, bond.radius, 1});
  return rock;
}

/// A rock as the solver holds it, with what its bonds need.
template <class Real>
struct BondedRock {
  using Law = BondLaw<ConstantStrength>;
  ParticleStore<Cpu, Real> store{true};
  BreakEvent event{};
  std::int32_t breaks = 0, cracked = 0, rotated = 0;

  BondedRock() {
    Scene scene;
    scene.dt = dt;
    Arrivals<Real> arrivals(store.present(), scene, 0);
    arrivals.add(one_rock());
    store.append(arrivals);
  }
  BondForces<Real, Law> kernel() {
    BondConstants<Real> law = cast<Real>(BondConstants<double>{parameters, 0.5, dt});
    return {.p = store.read(),
            .loads = store.view().bond_load,
            .b = store.bond_view(),
            .blocks = store.block_view(),
            .law = law,
            .log = {&event, &breaks, &cracked, StepLimits{}.bond_rotation, &rotated, nullptr}};
  }

  template <class Lanes>
  void evaluate(int passes) {
    const BondForces<Real, Law> bonds = kernel();
    const BondStep when{.block = 0, .step = 0, .substep = 0, .dt = dt};
    const Block block = store.blocks().front();
    for (int pass = 0; pass < passes; ++pass)
      for (Index bond = block.first_bond; bond < block.end_bond; bond += Lanes::count) bonds(Lanes{bond}, when);
  }
};

template <class Real>
BondLoop loop_of() {
  const auto rock = std::make_shared<BondedRock<Real>>();
  const auto bonds = static_cast<int>(one_rock().bonds.size());
  return {.bonds = bonds,
          .in_packs = [rock](int passes) { rock->template evaluate<PackLanes<load_lanes<Real>>>(passes); },
          .one_by_one = [rock](int passes) { rock->template evaluate<OneLane>(passes); }};
}

template <class Real>
BondOperations operations_of() {
  BondedRock<Real> rock;
  Expressions expressions;
  recorded = &expressions;
  rock.kernel()(TracedLane{}, BondStep{.block = 0, .step = 0, .substep = 0, .dt = dt});
  recorded = nullptr;
  return {.in_double = expressions.counts(true), .in_single = expressions.counts(false)};
}

}  // namespace

BondOperations bond_operations(Precision precision) {
  return precision == Precision::mixed ? operations_of<float>() : operations_of<double>();
}

BondLoop bond_loop(Precision precision) {
  return precision == Precision::mixed ? loop_of<float>() : loop_of<double>();
}

double seconds_of(const std::function<void()>& work) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

}  // namespace gyro::bench
