// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/kernels/bond_lane.hpp"

#include <type_traits>

namespace gyro {

/// Where failing bonds are noted.
struct BreakLog {
  BreakEvent* events;
  std::int32_t* count;
  std::int32_t* block_cracked;   ///< set to 1 when the first bond of a block fails whose bonded pairs are not listed
  double rotation_limit;         ///< of the ends of an intact bond against each other [rad]
  std::int32_t* limit_exceeded;  ///< set to 1 by any bond beyond it
  const std::int32_t* steps;     ///< are added to BondStep::step, where a device counts them; null: none
};

namespace bond_detail {

template <class Real, class Lanes, template <class> class Column>
GYRO_HD auto rates_of(const Lanes& lanes, const ConstParticleView& p, const Bonds<Column, Real>& b) {
  const auto i = lanes.load(b.i), j = lanes.load(b.j);
  return BondRates<typename Lanes::template Number<Real>>{lanes.template difference<Real>(p.motion, j, i),
                                                          lanes.template vector<Real>(p.angular_motion, i),
                                                          lanes.template vector<Real>(p.angular_motion, j)};
}
template <class Real, class Lanes, template <class> class Column>
GYRO_HD auto section_of(const Lanes& lanes, const Bonds<Column, Real>& b) {
  return BondSection<typename Lanes::template Number<Real>>{
      lanes.load(b.radius),       lanes.load(b.strength), lanes.load(b.sqrt_mass),
      lanes.load(b.sqrt_inertia), lanes.load(b.arm),      lanes.template load_as<Real>(b.length)};
}

}  // namespace bond_detail

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

  /// Of intact bonds.
  template <template <class> class Column>
  GYRO_HD BondLanes(const Lanes& lanes, const ConstParticleView& p, const Bonds<Column, Real>& b) {
    const auto i = lanes.load(b.i), j = lanes.load(b.j);
    const R arm = lanes.load(b.arm);
    const D length = lanes.load(b.length);
    shape = {lane_cast<double>(Vec3<R>{lanes.load(b.axis_x), lanes.load(b.axis_y), lanes.load(b.axis_z)}), length,
             lane_cast<double>(arm)};
    ends = {lanes.template difference<double>(p.position, j, i), lanes.quaternion(p.orientation, i),
            lanes.quaternion(p.orientation, j)};
    take_axes(intact_axis(shape, ends));
    rates = bond_detail::rates_of<Real>(lanes, p, b);
    section = bond_detail::section_of<Real>(lanes, b);
  }

  /// Of bonds of which some are pressed: their axes are those of the last step, rotated with their ends.
  /// @param dt  time since their axes were stored [s]
  template <template <class> class Column, class State>
  GYRO_HD void carry_axes(const Lanes& lanes, const ConstParticleView& p, const Bonds<Column, Real>& b,
                          const State& state, double dt) {
    const auto angular_velocity_i = lanes.template vector<double>(p.angular_motion, lanes.load(b.i)),
               angular_velocity_j = lanes.template vector<double>(p.angular_motion, lanes.load(b.j));
    const Vec3<D> carried =
        pressed_axis(shape.axis, shape.arm * angular_velocity_i + (D(1) - shape.arm) * angular_velocity_j, D(dt));
    take_axes(select(lanes.template is_intact<double>(state), intact_axis(shape, ends), carried));
  }

 private:
  GYRO_HD void take_axes(const Vec3<D>& axis) {
    strain = strain_about(axis, shape.length, ends);
    strain_r = {lane_cast<Real>(strain.normal), lane_cast<Real>(strain.length), lane_cast<Real>(strain.stretch),
                lane_cast<Real>(strain.along),  lane_cast<Real>(strain.shear),  lane_cast<Real>(strain.twist),
                lane_cast<Real>(strain.bend)};
  }
};

/// The same of a pack of bonds that is wider than a register of doubles (wide_bond_pack.hpp).
template <class Real, class Lanes>
struct WideBondLanes;

/// The bonds of which rock are evaluated, and when.
struct BondStep {
  Index block;
  std::int64_t step;     ///< as in BreakEvent, less *BreakLog::steps
  std::int32_t substep;  ///< as in BreakEvent
  double dt;             ///< of a sub-step [s]
};

/// Forces of the bonds of some lanes, added to the rows of their particles bond by bond, and failure: every bond is
/// judged on the state that all of them saw and changes its own state only. Law is a bond law of
/// core/laws/bond/models.hpp.
template <class Real, class Law>
struct BondForces {
  ConstParticleView p;
  Load* loads;  ///< from bonds, of each particle
  BondView<Real> b;
  Block* blocks;
  BondConstants<Real> law;  ///< but for its step, which each rock has of its own
  BreakLog log;

  /// @param when  the same for all lanes
  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void operator()(const Lanes& lanes, const BondStep& when) const {
    using R = typename Lanes::template Number<Real>;
    const auto state = lanes.load(b.state);
    if (!lanes.any_unbroken(state)) return;
    if (lanes.any_pressed(state)) return with_pressed(lanes, when);
    const std::conditional_t<Lanes::in_halves, WideBondLanes<Real, Lanes>, BondLanes<Real, Lanes>> bond(lanes, p, b);
    const BondLoad<R> load = intact_load(lanes, bond, when, lanes.template is_intact<Real>(state));
    lanes.add(loads, lanes.load(b.i), lanes.load(b.j), state, load, R(0));
  }

 private:
  /// The constants of the law, with the step of these bonds.
  template <class Lanes>
  GYRO_HD auto spread(const Lanes& lanes, const BondStep& when) const {
    using R = typename Lanes::template Number<Real>;
    BondConstants<R> constants = lanes.spread(law);
    constants.dt = R(static_cast<Real>(when.dt));
    return constants;
  }

  /// The same, if some of the bonds are pressed. Apart from the other, whose registers it would need.
  template <class Lanes>
  GYRO_APART GYRO_FLATTEN GYRO_HD void with_pressed(const Lanes& lanes, const BondStep& when) const {
    if constexpr (Lanes::in_halves)
      for (const int k : {0, 1}) (*this)(lanes.half(k), when);
    else
      all_with_pressed(lanes, when);
  }
  template <class Lanes>
  GYRO_HD void all_with_pressed(const Lanes& lanes, const BondStep& when) const {
    using R = typename Lanes::template Number<Real>;
    const auto state = lanes.load(b.state);
    const auto intact = lanes.template is_intact<Real>(state);
    BondLanes<Real, Lanes> bond(lanes, p, b);
    bond.carry_axes(lanes, p, b, state, static_cast<double>(static_cast<Real>(when.dt)));
    BondLoad<R> load = intact_load(lanes, bond, when, intact);
    const auto pressed = Law::pressed(spread(lanes, when), bond.section, bond.strain_r, bond.rates);
    load.force = select(intact, load.force, pressed.load.force);
    load.torque_i = select(intact, load.torque_i, pressed.load.torque_i);
    load.torque_j = select(intact, load.torque_j, pressed.load.torque_j);
    load.damped = select(intact, load.damped, pressed.load.damped);
    slip_and_part(lanes, bond, pressed.keep, state);
    lanes.add(loads, lanes.load(b.i), lanes.load(b.j), state, load, select(intact, R(0), pressed.slip_work));
  }

  /// @param bond  BondLanes or WideBondLanes
  template <class Lanes, class Bond, class Mask>
  GYRO_HD auto intact_load(const Lanes& lanes, const Bond& bond, const BondStep& when, const Mask& intact) const {
    using R = typename Lanes::template Number<Real>;
    const BondLoad<R> load = Law::load(spread(lanes, when), bond.section, bond.strain_r, bond.rates);
    const auto broken = intact & failed(load);
    if (lanes.any(broken)) note_failures(lanes, when);
    const R rotation2 = bond.strain_r.twist * bond.strain_r.twist + norm2(bond.strain_r.bend);
    if (lanes.any(intact & (rotation2 > R(log.rotation_limit * log.rotation_limit)))) raise_flag(log.limit_exceeded);
    return load;
  }

  template <class R>
  GYRO_HD static auto failed(const BondLoad<R>& load) {
    return (load.tension_ratio >= R(1)) | (load.shear_ratio >= R(1));
  }

  /// A failing bond keeps its normal spring while its ends are pressed together; what else it stored
  /// is released. So is the work of half a step more: the loads of this step are still those of the
  /// intact bond, and Verlet's next half kick spends them.
  ///
  /// Failures are rare: what this needs of the bonds is computed again, so that their loads stay in registers.
  template <class Lanes>
  GYRO_COLD GYRO_HD void note_failures(const Lanes& lanes, const BondStep& when) const {
    if constexpr (Lanes::in_halves)
      for (const int k : {0, 1}) note_all_failures(lanes.half(k), when);
    else
      note_all_failures(lanes, when);
  }
  template <class Lanes>
  GYRO_HD void note_all_failures(const Lanes& lanes, const BondStep& when) const {
    const auto constants = spread(lanes, when);
    const BondLanes<Real, Lanes> bond(lanes, p, b);
    const auto load = Law::load(constants, bond.section, bond.strain_r, bond.rates);
    const auto after = Law::pressed(constants, bond.section, bond.strain_r, bond.rates);
    const auto broken = lanes.template is_intact<Real>(lanes.load(b.state)) & failed(load);
    const auto power = bond_power(load, bond.rates), power_after = bond_power(after.load, bond.rates);
    for (int lane = 0; lane < Lanes::count; ++lane) {
      if (!lanes.test(broken, lane)) continue;
      const Index n = lanes.index(lane);
      const Real tension = lanes.value(load.tension_ratio, lane), shear = lanes.value(load.shear_ratio, lane);
      const bool apart = separated(n, lanes.value(bond.strain.length, lane));
      const double kept = apart ? 0 : static_cast<double>(lanes.value(after.load.elastic, lane));
      const double stored = static_cast<double>(lanes.value(load.elastic, lane));
      const double lost_power = static_cast<double>(lanes.value(power, lane)) -
                                (apart ? 0 : static_cast<double>(lanes.value(power_after, lane)));
      const double released = stored - kept - 0.5 * static_cast<double>(static_cast<Real>(when.dt)) * lost_power;
      b.state[n] = apart ? bond_broken : bond_pressed;
      const std::int64_t step = log.steps == nullptr ? when.step : when.step + *log.steps;
      log.events[take_number(log.count)] = {step, when.substep, n, tension >= shear ? 1 : 2, released};
      if (!is_raised(&blocks[when.block].state)) {  // several threads may work on one block
        raise_flag(&blocks[when.block].state);
        if (!blocks[when.block].listed) raise_flag(log.block_cracked);
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

  /// Stores the axis of a pressed bond: what slip has left of its shear, world frame.
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
