// SPDX-License-Identifier: GPL-3.0-or-later
// Packs of entries of the wall list give the bits of one entry after the other.
#include "core/kernels/wall_pack.hpp"
#include "core/kernels/wall_forces.hpp"
#include "core/laws/contact/models.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"

#include <cstring>
#include <limits>
#include <vector>

using namespace gyro;

namespace {

constexpr int count = 24;  // entries, of as many particles with two walls

double draw(int thing, std::uint32_t d) {
  return 2 * uniform(1, Stream{}, static_cast<std::uint64_t>(thing), d) - 1;
}
Vec3d vector_of(int thing, std::uint32_t d) {
  return {draw(thing, d), draw(thing, d + 1), draw(thing, d + 2)};
}

/// Entries that touch in one place, of which some were in contact before and some roll to another place.
template <class Real>
struct Entries {
  std::vector<Sphere> spheres;
  std::vector<Motion> motions;
  std::vector<AngularMotion> angular;
  std::vector<double> steps, damping_rates;
  std::vector<WallPose> poses;
  std::vector<ContactConstants<Real>> constants;
  std::vector<WallEntry> entries;
  std::vector<WallTouchNow> touches;
  std::vector<WallHistory<Real>> history;
  std::vector<WallResult<Real>> results;
  std::vector<WallSum> sums, carried;
  std::int32_t limit_exceeded = 0;

  Entries() : results(count), sums(count), carried(count) {
    for (int w = 0; w < 2; ++w) {
      poses.push_back({vector_of(w, 0), {1, 0, 0, 0}, vector_of(w, 3), vector_of(w, 6)});
      const Real shift = static_cast<Real>(1 + w);
      constants.push_back({shift * Real(1e8), shift * Real(2e8), Real(0.2), Real(0.3) * shift, Real(0.05), Real(1e-5),
                           1, Real(1e5), shift * Real(1e4), shift * Real(3e4)});
    }
    for (int k = 0; k < count; ++k) {
      const int thing = 10 + k;
      spheres.push_back({vector_of(thing, 0), 0.02 + 0.01 * draw(thing, 3)});
      motions.push_back({vector_of(thing, 4), 0.1 + 0.05 * draw(thing, 7)});
      angular.push_back({10.0 * vector_of(thing, 8), 1e-5 + 5e-6 * draw(thing, 11)});
      steps.push_back(1e-5 / (1 + k % 3));
      damping_rates.push_back(1e5 * draw(thing, 24));
      entries.push_back({k, k % 3 == 0 ? 1 : 0, {0, 0}});
      const Vec3d n = vector_of(thing, 12);
      touches.push_back({1 / norm(n) * n, 1e-4 * (1.1 + draw(thing, 15))});
      WallHistory<Real> h{};
      h.count = 1;
      if (k % 4 != 0) {
        const Vec3d normal = k % 4 == 1 ? -touches.back().outward : touches.back().outward;
        h.contact[0] = {{cast<Real>(20.0 * vector_of(thing, 16)), static_cast<Real>(1e-4 * (1.1 + draw(thing, 19))),
                         cast<Real>(5.0 * vector_of(thing, 20))},
                        cast<Real>(normal)};
      }
      history.push_back(h);
    }
  }

  template <class Law>
  WallForces<Real, Law, true> kernel() {
    WallForces<Real, Law, true> k{};
    k.p.position = spheres.data();
    k.p.motion = motions.data();
    k.p.angular_motion = angular.data();
    k.walls = {nullptr, poses.data(), 2};
    k.near.entry = entries.data();
    k.near.touch = touches.data();
    k.near.history = history.data();
    k.near.result = results.data();
    k.booking = {sums.data(), carried.data()};
    k.constants = constants.data();
    k.p.step = steps.data();
    k.p.damping_rate = damping_rates.data();
    k.dt = 1e-5;
    k.last_of_window = true;
    k.deep = {0.8, &limit_exceeded};
    return k;
  }
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <int N, class Real>
void check_packs() {
  CAPTURE(N, sizeof(Real));
  using Law = ContactLaw<Hertz, ConstantRolling>;
  Entries<Real> one, packs;
  for (Index n = 0; n < count; ++n) one.template kernel<Law>()(OneEntry{n});
  std::vector<Index> order;
  for (Index k = 0; k < count; ++k) order.push_back((7 * k + 3) % count);
  for (int k = 0; k < count; k += N) packs.template kernel<Law>()(PackOfEntries<N>{order.data() + k});
  CHECK(same_bytes(one.history, packs.history));
  CHECK(same_bytes(one.results, packs.results));
  CHECK(same_bytes(one.sums, packs.sums));
  CHECK(same_bytes(one.carried, packs.carried));
  int pushed = 0, worked = 0;
  for (std::size_t k = 0; k < count; ++k) {
    pushed += norm2(one.results[k].force) > 0;
    worked += one.sums[k].work != 0 && one.carried[k].force.x != 0;
  }
  CHECK(pushed > count / 3);
  CHECK(worked > count / 3);
}

}  // namespace

TEST_CASE("Packs of entries of walls have the bits of one entry", "[kernels][walls]") {
  check_packs<4, float>();
  check_packs<4, double>();
  check_packs<8, float>();
  check_packs<8, double>();
}

TEST_CASE("Quanta of packs are those of one number, also of those that are not finite", "[kernels][walls]") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const double numbers[] = {0,      -0.0,   0.5, -0.5, 1e15 + 0.5, -2.5,   8.9e18,        -8.9e18,
                            9.1e18, -1e300, inf, -inf, nan,        1e-300, 1.49999999999, -7.5};
  for (int first = 0; first < 16; first += 8) {
    Pack<double, 8> pack;
    for (int k = 0; k < 8; ++k) pack.v[k] = numbers[first + k];
    const Pack<std::int64_t, 8> found = quanta(pack);
    for (int k = 0; k < 8; ++k) CHECK(found[k] == quanta(numbers[first + k]));
  }
}
