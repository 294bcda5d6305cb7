// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/pair_lane.hpp"
#include "core/state/bonds.hpp"

#include <bit>
#include <type_traits>

namespace gyro {

/// How the particles of a pair move, as its contact sees it.
template <class T>
struct PairMotion {
  ContactMotion<T> contact;
  T arm_i, arm_j;  ///< from the centres to the contact point [m]
};

/// Contact of two particles: loads into the slots of the pair's two ends. A kernel for Exec::for_each_picked:
/// neighbours are looked at, and those that touch are evaluated, several at a time.
/// @tparam Law   a ContactLaw
/// @tparam held  some particles have sub-steps, over which forces are held
template <class Real, class Law, bool held>
struct PairForces {
  using Lane = OnePair;  ///< of a GPU thread
  /// Of a CPU core. A law that keeps ExtraHistory is evaluated one by one.
  using Pack = std::conditional_t<Law::keeps_extra_history, OnePair, PackOfPairs<load_lanes<Real>>>;
  using PickPack = PackOfPairs<native_lanes>;  ///< looked at together

  ConstParticleView p;
  PairView<Real> pairs;
  const std::int32_t* bond_state;  ///< null without bonds
  ContactConstants<Real> constants;
  double dt;  ///< step of the scene [s]
  OverlapCheck deep;

  /// Whether the pair touches. If it does not, its history is forgotten.
  GYRO_HD bool pick(Index n) const {
    const Pair pair = pairs.pair[n];
    const double sum = p.position[pair.i].radius + p.position[pair.j].radius, sum2 = sum * sum;
    const double distance2 = norm2(centre(pair.j) - centre(pair.i));
    // The root is needed only where its rounding decides. A NaN does not touch; the guard reports it.
    const bool overlap = distance2 < surely * sum2 || (distance2 < sum2 && ::sqrt(distance2) < sum);
    const bool touches = overlap && !is_bonded(pair);
    if (touches != (pairs.touching[n] != 0)) set_touching(n, touches);
    return touches;
  }

  /// The same for the pairs of a pack, which are neighbours in the list. @return bit k is set if pair k of them touches
  template <class Lanes>
  GYRO_FLATTEN std::uint32_t pick_each(const Lanes& lanes) const {
    using D = typename Lanes::template Number<double>;
    const auto [i, j] = lanes.both_ends(pairs.pair);
    ParticleRow<D> a = lanes.row(p.position, i), b = lanes.row(p.position, j);
    if constexpr (held) {
      a.vector = seen_centre(a.vector, lanes.row(p.motion, i).vector, D(dt), lanes.at(p.step, i));
      b.vector = seen_centre(b.vector, lanes.row(p.motion, j).vector, D(dt), lanes.at(p.step, j));
    }
    const D sum = a.number + b.number, sum2 = sum * sum, distance2 = norm2(b.vector - a.vector);
    const std::uint32_t overlap = bits_of(distance2 < D(surely) * sum2), near = bits_of(distance2 < sum2);
    std::uint32_t touches = overlap;
    // One by one: where rounding decides, or a bond, or something changes.
    std::uint32_t asks =
        (near ^ overlap) | (overlap ^ lanes.neighbour_flags(pairs.touching)) | (overlap & with_bonds(lanes));
    for (; asks != 0; asks &= asks - 1) {
      const int k = std::countr_zero(asks);
      touches = (touches & ~(1u << k)) | (pick(lanes.n[k]) ? 1u << k : 0u);
    }
    return touches;
  }

  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void operator()(const Lanes& lanes) const {
    using R = typename Lanes::template Number<Real>;
    const Lanes own = lanes;  // a copy, whose numbers no store can change
    const PairMotion<R> motion = own.in_parts(*this);
    store(own, motion.contact, motion.arm_i, motion.arm_j);
  }

  /// What the contact law reads of the particles, in double precision until small differences are formed.
  template <class Lanes>
  GYRO_HD PairMotion<typename Lanes::template Number<Real>> part(const Lanes& lanes) const {
    using D = typename Lanes::template Number<double>;
    using R = typename Lanes::template Number<Real>;
    const auto [i, j] = lanes.both_ends(pairs.pair);
    const ParticleRow<D> va = lanes.row(p.motion, i), vb = lanes.row(p.motion, j);
    ParticleRow<D> a = lanes.row(p.position, i), b = lanes.row(p.position, j);
    if constexpr (held) {
      a.vector = seen_centre(a.vector, va.vector, D(dt), lanes.at(p.step, i));
      b.vector = seen_centre(b.vector, vb.vector, D(dt), lanes.at(p.step, j));
    }
    const ParticleRow<D> wa = lanes.row(p.angular_motion, i), wb = lanes.row(p.angular_motion, j);

    const Vec3<D> span = b.vector - a.vector;
    const D distance = norm(span), overlap = a.number + b.number - distance;
    if (lanes.any(overlap > D(deep.limit) * smaller(a.number, b.number))) raise_flag(deep.limit_exceeded);
    const D arm_a = a.number - D(0.5) * overlap, arm_b = b.number - D(0.5) * overlap;
    const Vec3<D> normal = (D(1) / distance) * span;

    PairMotion<R> out;
    ContactMotion<R>& c = out.contact;
    c.normal = lane_cast<Real>(normal);
    c.overlap = lane_cast<Real>(overlap);
    c.velocity = lane_cast<Real>(va.vector - vb.vector + cross(arm_a * wa.vector + arm_b * wb.vector, normal));
    c.angular_velocity = lane_cast<Real>(wa.vector - wb.vector);
    c.damping_rate = lane_cast<Real>(lanes.at(p.damping_rate, i) + lanes.at(p.damping_rate, j));
    c.radius = reduced(lane_cast<Real>(a.number), lane_cast<Real>(b.number));
    c.mass = reduced(lane_cast<Real>(va.number), lane_cast<Real>(vb.number));
    const R inertia_a = lane_cast<Real>(wa.number), inertia_b = lane_cast<Real>(wb.number);
    const R share = inertia_b / (inertia_a + inertia_b);
    c.inertia = inertia_a * share;
    out.arm_i = lane_cast<Real>(arm_a);
    out.arm_j = lane_cast<Real>(arm_b);
    c.lever = share * out.arm_i - (R(1) - share) * out.arm_j;
    return out;
  }

 private:
  static constexpr double surely = 1 - 1e-15;  ///< of a sum's square: nearer ones touch, whatever a root is rounded to

  GYRO_HD Vec3d centre(Index n) const {
    if constexpr (held) return seen_centre(p.position[n].x, p.motion[n].v, dt, p.step[n]);
    return p.position[n].x;
  }
  /// x y/(x + y), without a product that could be too small for single precision.
  template <class T>
  GYRO_HD static T reduced(const T& x, const T& y) {
    return x * (y / (x + y));
  }
  GYRO_HD bool is_bonded(const Pair& pair) const { return pair.bond != none && bond_state[pair.bond] != bond_broken; }
  template <class Lanes>
  std::uint32_t with_bonds(const Lanes& lanes) const {
    std::uint32_t bits = 0;
    if (bond_state == nullptr) return bits;
    for (int k = 0; k < Lanes::count; ++k) bits |= (pairs.pair[lanes.n[k]].bond != none ? 1u : 0u) << k;
    return bits;
  }
  /// A pair that has come apart forgets its history.
  GYRO_HD void set_touching(Index n, bool touches) const {
    const std::int8_t flag = touches ? 1 : 0;
    pairs.touching[n] = pairs.loaded[pairs.at[n].i] = pairs.loaded[pairs.at[n].j] = flag;
    if (touches) return;
    pairs.history[n] = {};
    if constexpr (Law::keeps_extra_history) pairs.extra[n] = {};
  }

  /// @param arm_a, arm_b  from the centres to the contact point [m]
  template <class Lanes, class R>
  GYRO_HD void store(const Lanes& lanes, const ContactMotion<R>& c, const R& arm_a, const R& arm_b) const {
    ExtraHistory<R> extra{};
    if constexpr (Law::keeps_extra_history) extra = lanes.load(pairs.extra);
    const ContactLoad<R> load = Law::load(lanes.spread(constants), c, lanes.load(pairs.history), extra);
    if constexpr (Law::keeps_extra_history) lanes.store(pairs.extra, extra);

    const Vec3<R> lever = cross(c.normal, load.force);
    lanes.store(pairs.history, load.history);
    const auto at = lanes.both_ends(pairs.at);
    lanes.store_at(pairs.load, at.i, EndLoad<R>{load.force, arm_a * lever + load.couple, load.damped, load.slipped});
    lanes.store_at(pairs.load, at.j, EndLoad<R>{-load.force, arm_b * lever - load.couple, R(0), R(0)});
    lanes.store_at(pairs.dashpot, at.i, load.dashpot);
    lanes.store_at(pairs.dashpot, at.j, load.dashpot);
  }
};

}  // namespace gyro
