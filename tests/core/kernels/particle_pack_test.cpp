// SPDX-License-Identifier: GPL-3.0-or-later
// Packs of particles are advanced as one particle after the other, to the bit.
#include "core/kernels/particle_pack.hpp"
#include "app/verify/fixtures/random.hpp"
#include "core/exec/cpu.hpp"
#include "core/kernels/advance_rocks.hpp"
#include "core/kernels/wide_bond_pack.hpp"
#include "core/laws/bond/models.hpp"
#include "tests/catch.hpp"

#include <cstring>
#include <vector>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

template <class T>
using Rows = std::vector<T>;

constexpr Index count = 61;  // no multiple of a pack
constexpr double step_of_scene = 1e-5;

/// Particles with some contacts; every third of them has none. Of the contacts of the particles 16 to 39 none touches
/// but for one pair and one wall, so that packs have many that touch, few, or none.
template <class Real>
struct State {
  using Kernel = AdvanceRocks<Real, BondLaw<ConstantStrength>>;
  Particles<Rows> p;
  Pairs<Rows, Real> pairs;
  WallPairs<Rows, Real> walls;
  Rows<Load> held;
  Rows<Sphere> bounds;
  Rows<Piece> pieces{{0, 3, none, 1}, {3, 30, none, 2}, {30, 31, none, 1}, {31, count, none, 4}};
  std::int32_t stale = 0, limit_exceeded = 0;

  State() {
    for (Index n = 0; n < count; ++n) add_particle(static_cast<std::uint64_t>(n));
    for (Index n = 0; n < count; ++n) add_contacts(n);
    pairs.row_begin.push_back(static_cast<Index>(pairs.load.size()));
    walls.row_begin.push_back(static_cast<Index>(walls.result.size()));
    for (const Piece& piece : pieces)
      for (Index n = piece.first_particle; n < piece.end_particle; ++n)
        p.step[static_cast<std::size_t>(n)] = step_of_scene / piece.substeps;
  }

  Kernel kernel(Motions first, bool with_bonds, bool with_held) {
    Kernel k{};
    k.pieces = pieces.data();
    k.gather = {.p = view_of<ParticleView>(p),
                .pairs = view_of<ConstPairView<Real>>(pairs),
                .walls = view_of<ConstWallPairView<Real>>(walls),
                .gravity = {0.3, -0.0, -9.81},
                .with_bonds = with_bonds,
                .held = with_held ? held.data() : nullptr};
    k.move = {.p = k.gather.p,
              .dt = step_of_scene,
              .bounds = bounds.data(),
              .stale = &stale,
              .with_orientation = with_bonds,
              .limits = {},
              .limit_exceeded = &limit_exceeded};
    k.first = first;
    k.to_next = true;
    return k;
  }

  /// Each column, and whatever else a kernel writes.
  bool operator==(const State& other) const {
    bool same = stale == other.stale && limit_exceeded == other.limit_exceeded && equal(held, other.held);
    ParticleView::for_each_column([&](const char*, const auto& a, const auto& b) { same = same && equal(a, b); }, p,
                                  other.p);
    return same;
  }

 private:
  template <class T>
  static bool equal(const Rows<T>& a, const Rows<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
  }
  static Load load_of(std::uint64_t n, std::uint32_t d) {
    return {random_vector(n, d), random_share(n, d + 3), random_vector(n, d + 4), random_share(n, d + 7)};
  }
  void add_particle(std::uint64_t n) {
    const Vec3d centre = random_vector(n, 0);
    p.position.push_back({centre, 0.01 + 0.01 * random_share(n, 3)});
    bounds.push_back({centre + 1e-4 * random_vector(n, 4), p.position.back().radius + 1e-3});
    p.motion.push_back({random_vector(n, 7), 0.01 + random_share(n, 10)});
    p.angular_motion.push_back({30.0 * random_vector(n, 11), 1e-5 * (0.1 + random_share(n, 14))});
    p.orientation.push_back(rotation_by(random_vector(n, 15)));
    p.load.push_back(load_of(n, 18));
    p.bond_load.push_back(load_of(n, 26));
    held.push_back(load_of(n, 34));
    p.losses.push_back({random_share(n, 42), random_share(n, 43), random_share(n, 44), random_share(n, 45)});
    p.damping_rate.push_back(random_share(n, 46));
    p.step.push_back(step_of_scene);
    p.id.push_back(static_cast<ParticleId>(n));
    p.block.push_back(none);
  }
  void add_contacts(Index n) {
    pairs.row_begin.push_back(static_cast<Index>(pairs.load.size()));
    walls.row_begin.push_back(static_cast<Index>(walls.result.size()));
    for (Index e = 0; e < 2 * (n % 3); ++e) {
      const auto thing = static_cast<std::uint64_t>(1000 + 10 * n + e);
      const auto vector = [&](std::uint32_t d) { return gyro::cast<Real>(random_vector(thing, d)); };
      const auto number = [&](std::uint32_t d) { return static_cast<Real>(random_share(thing, d)); };
      const bool touches = n < 16 || n >= 40 ? e != 1 : (n == 20 && e == 2) || (n == 26 && e == 0);
      pairs.load.push_back({vector(0), vector(3), number(6), number(7)});
      pairs.dashpot.push_back(number(8));
      pairs.loaded.push_back(touches);
      if (e > 1) continue;
      walls.result.push_back({vector(10), vector(13), number(16), number(17), number(18)});
      walls.touching.push_back(touches && n % 2 == 0);
    }
  }
};

/// What the particles do before their bonds are evaluated.
struct Doing {
  Motions motions;
  bool with_bonds, with_held;
};

template <int N, class Real>
void check_packs(const Doing& doing, const State<Real>& start) {
  CAPTURE(N, sizeof(Real), static_cast<int>(doing.motions), doing.with_bonds, doing.with_held);
  State<Real> one = start, packs = start;
  const auto by_one = one.kernel(doing.motions, doing.with_bonds, doing.with_held),
             by_packs = packs.kernel(doing.motions, doing.with_bonds, doing.with_held);
  for (Index n = 0; n < count / N * N; ++n) by_one.prepare(n, 0, 0);
  for (Index n = 0; n + N <= count; n += N) by_packs.prepare(PackOfParticles<N>{n}, 0, 0);
  CHECK(packs == one);
  CHECK(!(packs == start));
}

template <class Real>
void check_all_motions(const State<Real>& start) {
  for (const Motions motions : {Motions::loads_only, Motions::move, Motions::move_on, Motions::move_held})
    for (const bool with_bonds : {false, true})
      for (const bool with_held : {false, true}) {
        if (motions == Motions::loads_only && !with_bonds) continue;  // nothing to do
        if (motions == Motions::move_held && !with_held) continue;
        check_packs<4>({motions, with_bonds, with_held}, start);
        check_packs<8>({motions, with_bonds, with_held}, start);
      }
}

}  // namespace

TEST_CASE("Packs of particles are advanced to the bits of single particles", "[kernels]") {
  check_all_motions(State<float>());
  check_all_motions(State<double>());
}

TEST_CASE("Packs of particles raise the flags that one of them raises", "[kernels]") {
  for (const std::size_t n : {std::size_t{0}, std::size_t{5}, std::size_t{23}}) {
    CAPTURE(n);
    State<float> moved, fast, spinning;
    moved.bounds[n].x.y += 0.01;
    fast.p.motion[n].v.x = 1000;
    spinning.p.angular_motion[n].w.z = 20000;
    for (const State<float>& start : {moved, fast, spinning}) check_all_motions(start);
    for (State<float>* s : {&moved, &fast, &spinning}) {
      const auto kernel = s->kernel(Motions::move, true, false);
      kernel.prepare(PackOfParticles<8>{static_cast<Index>(n / 8 * 8)}, 0, 0);
    }
    CHECK((moved.stale == 1 && moved.limit_exceeded == 0));
    CHECK(fast.limit_exceeded == 1);
    CHECK((spinning.stale == 0 && spinning.limit_exceeded == 1));
  }
}

TEST_CASE("Pieces of any length are advanced as one particle after the other", "[kernels]") {
  const bool with_bonds = GENERATE(false, true), with_held = GENERATE(false, true);
  State<float> one, pieces;
  auto by_one = one.kernel(Motions::move_on, with_bonds, with_held);
  for (Index k = 0; k < 4; ++k)
    for (int pass = 0; pass < by_one.passes(k); ++pass)
      for (Index n = by_one.rows(k).begin; n < by_one.rows(k).end; ++n) by_one.prepare(n, k, pass);
  Cpu(1).for_each_block("advance rocks", {4, run_length}, pieces.kernel(Motions::move_on, with_bonds, with_held));
  CHECK(pieces == one);
}
