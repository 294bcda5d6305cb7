// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/kernels/bond_lane.hpp"
#include "core/laws/bond.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// Where failing bonds are noted.
struct BreakLog {
  BreakEvent* events;
  std::int32_t* count;
  std::int32_t* relist;  ///< set to 1 when the first bond of a block fails: its particles may now touch
  Block* blocks;
  double rotation_limit;         ///< of the ends of a glued bond against each other [rad]
  std::int32_t* limit_exceeded;  ///< set to 1 by any bond beyond it
};

/// Strain, rates and section of the bonds of some lanes; the only place that knows how they lie in
/// memory. Lanes are a pack of bonds (CPU) or one bond (a GPU thread).
template <class Real, class Lanes>
struct BondLanes {
  using D = typename Lanes::template Number<double>;
  using R = typename Lanes::template Number<Real>;
  BondShape<D> shape;
  BondEnds<D> ends;
  BondStrain<D> strain;
  BondStrain<R> strain_r;
  BondRates<R> rates;
  BondSection<R> section;

  /// @param dt  time since the axes of unglued bonds were stored [s]
  GYRO_HD BondLanes(const Lanes& lanes, const ParticleView& p, const BondView<Real>& b, double dt) {
    const auto i = lanes.load(b.i), j = lanes.load(b.j);
    const R arm = lanes.load(b.arm);
    const D length = lanes.load(b.length);
    shape = {lanes.template cast<double>(Vec3<R>{lanes.load(b.axis_x), lanes.load(b.axis_y), lanes.load(b.axis_z)}),
             length, lanes.template cast<double>(arm)};
    ends = {lanes.vector(p.position, j) - lanes.vector(p.position, i), lanes.quaternion(p.orientation, i),
            lanes.quaternion(p.orientation, j)};
    const Vec3<D> angular_velocity_i = lanes.vector(p.angular_motion, i),
                  angular_velocity_j = lanes.vector(p.angular_motion, j);
    Vec3<D> axis = intact_axis(shape, ends);
    const auto state = lanes.load(b.state);
    if (lanes.any_below_and_not(state, bond_broken, bond_intact)) {
      const Vec3<D> carried =
          pressed_axis(shape.axis, shape.arm * angular_velocity_i + (D(1) - shape.arm) * angular_velocity_j, D(dt));
      axis = select(lanes.template equal<double>(state, bond_intact), axis, carried);
    }
    strain = strain_about(axis, shape.length, ends);
    strain_r = {lanes.template cast<Real>(strain.normal),  lanes.template cast<Real>(strain.length),
                lanes.template cast<Real>(strain.stretch), lanes.template cast<Real>(strain.along),
                lanes.template cast<Real>(strain.shear),   lanes.template cast<Real>(strain.twist),
                lanes.template cast<Real>(strain.bend)};
    rates = {lanes.template cast<Real>(lanes.vector(p.motion, j) - lanes.vector(p.motion, i)),
             lanes.template cast<Real>(angular_velocity_i), lanes.template cast<Real>(angular_velocity_j)};
    section = {lanes.load(b.radius),
               lanes.load(b.strength),
               lanes.load(b.sqrt_mass),
               lanes.load(b.sqrt_inertia),
               arm,
               lanes.template cast<Real>(length)};
  }
};

/// Forces of the bonds of one block, added to the rows of its particles bond by bond, and failure:
/// every bond is judged on the state that all of them saw and changes its own state only.
template <class Real>
struct BondForces {
  ParticleView p;
  BondView<Real> b;
  BondLaw<Real> law;
  BreakLog log;
  std::int64_t step;

  /// Clears the rows of a particle before the bonds add to them.
  GYRO_HD void clear(Index particle) const { p.bond_load[particle] = Load{}; }

  template <class Lanes>
  GYRO_HD void operator()(const Lanes& lanes, Index block) const {
    using R = typename Lanes::template Number<Real>;
    const auto state = lanes.load(b.state);
    if (!lanes.any_below(state, bond_broken)) return;
    const BondLanes<Real, Lanes> bond(lanes, p, b, static_cast<double>(law.dt));
    const BondLaw<R> constants = lanes.spread(law);

    BondLoad<R> load = bond_load(constants, bond.section, bond.strain_r, bond.rates);
    R slip_work(0);
    const auto intact = lanes.template equal<Real>(state, bond_intact);
    const auto broken = intact & ((load.tension_ratio >= R(1)) | (load.shear_ratio >= R(1)));
    if (lanes.any(broken)) note_failures(lanes, block, bond, load, broken, constants);
    const R turn2 = bond.strain_r.twist * bond.strain_r.twist + norm2(bond.strain_r.bend);
    if (lanes.any(intact & (turn2 > R(log.rotation_limit * log.rotation_limit)))) raise_flag(log.limit_exceeded);
    if (lanes.any_below_and_not(state, bond_broken, bond_intact)) {
      const auto pressed = pressed_load(constants, bond.section, bond.strain_r, bond.rates);
      take(load, intact, pressed.load);
      slip_work = select(intact, R(0), pressed.slip_work);
      slip_and_part(lanes, bond, pressed.keep, state);
    }
    lanes.add(p.bond_load, lanes.load(b.i), lanes.load(b.j), state, load, slip_work);
  }

 private:
  template <class R, class Mask>
  GYRO_HD static void take(BondLoad<R>& load, const Mask& intact, const BondLoad<R>& other) {
    load.force = select(intact, load.force, other.force);
    load.torque_i = select(intact, load.torque_i, other.torque_i);
    load.torque_j = select(intact, load.torque_j, other.torque_j);
    load.damped = select(intact, load.damped, other.damped);
  }

  /// A failing bond keeps its normal spring while its ends are pressed together; what else it stored
  /// is released. So is the work of half a step more: the loads of this step are still those of the
  /// glued bond, and Verlet's next half kick spends them.
  template <class Lanes, class R, class Mask>
  GYRO_HD void note_failures(const Lanes& lanes, Index block, const BondLanes<Real, Lanes>& bond,
                             const BondLoad<R>& load, const Mask& broken, const BondLaw<R>& constants) const {
    const auto after = pressed_load(constants, bond.section, bond.strain_r, bond.rates);
    const R power = bond_power(load, bond.rates), power_after = bond_power(after.load, bond.rates);
    for (int lane = 0; lane < Lanes::count; ++lane) {
      if (!lanes.test(broken, lane)) continue;
      const Index n = lanes.index(lane);
      const Real tension = lanes.value(load.tension_ratio, lane), shear = lanes.value(load.shear_ratio, lane);
      const bool apart = separated(n, lanes.value(bond.strain.length, lane));
      const double kept = apart ? 0 : static_cast<double>(lanes.value(after.load.elastic, lane));
      const double stored = static_cast<double>(lanes.value(load.elastic, lane));
      const double lost_power = static_cast<double>(lanes.value(power, lane)) -
                                (apart ? 0 : static_cast<double>(lanes.value(power_after, lane)));
      const double released = stored - kept - 0.5 * static_cast<double>(law.dt) * lost_power;
      b.state[n] = apart ? bond_broken : bond_pressed;
      log.events[take_number(log.count)] = {step, n, tension >= shear ? 1 : 2, released};
      if (log.blocks[block].state == block_intact) {
        log.blocks[block].state = block_broken;
        raise_flag(log.relist);
      }
      if (!apart) slip(lanes, bond, after.keep, lane);
    }
  }

  template <class Lanes, class R, class State>
  GYRO_HD void slip_and_part(const Lanes& lanes, const BondLanes<Real, Lanes>& bond, const R& keep,
                             const State& state) const {
    for (int lane = 0; lane < Lanes::count; ++lane) {
      if (lanes.value(state, lane) != bond_pressed) continue;
      if (separated(lanes.index(lane), lanes.value(bond.strain.length, lane)))
        b.state[lanes.index(lane)] = bond_broken;
      else
        slip(lanes, bond, keep, lane);
    }
  }

  GYRO_HD bool separated(Index n, double distance) const {
    const double touch = p.position[b.i[n]].radius + p.position[b.j[n]].radius;
    return distance > b.length[n] && distance > touch;
  }

  /// Stores the axis of an unglued bond: what slip has left of its shear, world frame.
  template <class Lanes, class R>
  GYRO_HD void slip(const Lanes& lanes, const BondLanes<Real, Lanes>& bond, const R& keep, int lane) const {
    const auto& s = bond.strain;
    BondStrain<double> one{};
    one.normal = {lanes.value(s.normal.x, lane), lanes.value(s.normal.y, lane), lanes.value(s.normal.z, lane)};
    one.shear = {lanes.value(s.shear.x, lane), lanes.value(s.shear.y, lane), lanes.value(s.shear.z, lane)};
    one.along = lanes.value(s.along, lane);
    const Vec3d axis = slipped_axis(one, static_cast<double>(lanes.value(keep, lane)));
    const Index n = lanes.index(lane);
    b.axis_x[n] = static_cast<Real>(axis.x);
    b.axis_y[n] = static_cast<Real>(axis.y);
    b.axis_z[n] = static_cast<Real>(axis.z);
  }
};

}  // namespace gyro
