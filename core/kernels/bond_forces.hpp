// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index_range.hpp"
#include "core/base/shared_counter.hpp"
#include "core/kernels/bond_lane.hpp"

namespace gyro {

/// Where failing bonds are noted.
struct BreakLog {
  BreakEvent* events;
  std::int32_t* count;
  std::int32_t* block_cracked;   ///< set to 1 when the first bond of a block fails: its particles may now touch
  double rotation_limit;         ///< of the ends of an intact bond against each other [rad]
  std::int32_t* limit_exceeded;  ///< set to 1 by any bond beyond it
};

/// All rocks, as a launch by block sees them.
struct BlockList {
  Block* blocks;
  const Index* colour_begin;  ///< first bond of each colour; a block has one entry more than colours
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

  /// @param dt  time since the axes of pressed bonds were stored [s]
  template <template <class> class Column>
  GYRO_HD BondLanes(const Lanes& lanes, const ConstParticleView& p, const Bonds<Column, Real>& b, double dt) {
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
    if (lanes.any_pressed(state)) {
      const Vec3<D> carried =
          pressed_axis(shape.axis, shape.arm * angular_velocity_i + (D(1) - shape.arm) * angular_velocity_j, D(dt));
      axis = select(lanes.template is_intact<double>(state), axis, carried);
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
///
/// A kernel for Exec::for_each_block: a block is a rock, its rows are particles, its items are bonds. Law is a bond law
/// of core/laws/bond/models.hpp.
template <class Real, class Law>
struct BondForces {
  using Lane = OneLane;                    ///< of a GPU thread
  using Pack = PackLanes<bond_alignment>;  ///< of a CPU core
  static constexpr int blocks_at_once = sizeof(Real) == 8 ? 2 : 4;

  ConstParticleView p;
  Load* loads;  ///< from bonds, of each particle
  BondView<Real> b;
  BlockList list;
  BondConstants<Real> law;
  BreakLog log;
  std::int64_t step;

  GYRO_HD IndexRange rows(Index block) const {
    return {list.blocks[block].first_particle, list.blocks[block].end_particle};
  }
  /// A whole number of packs.
  GYRO_HD IndexRange items(Index block) const { return {list.blocks[block].first_bond, list.blocks[block].end_bond}; }
  GYRO_HD IndexRange colours(Index block) const {
    return {list.blocks[block].first_colour, list.blocks[block].end_colour - 1};
  }
  /// Bonds that share no particle.
  GYRO_HD IndexRange items_of_colour(Index colour) const {
    return {list.colour_begin[colour], list.colour_begin[colour + 1]};
  }

  /// Clears the row of a particle before the bonds add to it.
  GYRO_HD void clear(Index particle) const { loads[particle] = Load{}; }

  template <class Lanes>
  GYRO_HD void operator()(const Lanes& lanes, Index block) const {
    using R = typename Lanes::template Number<Real>;
    const auto state = lanes.load(b.state);
    if (!lanes.any_unbroken(state)) return;
    const BondLanes<Real, Lanes> bond(lanes, p, b, static_cast<double>(law.dt));
    const BondConstants<R> constants = lanes.spread(law);

    BondLoad<R> load = Law::load(constants, bond.section, bond.strain_r, bond.rates);
    R slip_work(0);
    const auto intact = lanes.template is_intact<Real>(state);
    const auto broken = intact & ((load.tension_ratio >= R(1)) | (load.shear_ratio >= R(1)));
    if (lanes.any(broken)) note_failures(lanes, block, bond, load, broken, constants);
    const R rotation2 = bond.strain_r.twist * bond.strain_r.twist + norm2(bond.strain_r.bend);
    if (lanes.any(intact & (rotation2 > R(log.rotation_limit * log.rotation_limit)))) raise_flag(log.limit_exceeded);
    if (lanes.any_pressed(state)) {
      const auto pressed = Law::pressed(constants, bond.section, bond.strain_r, bond.rates);
      take(load, intact, pressed.load);
      slip_work = select(intact, R(0), pressed.slip_work);
      slip_and_part(lanes, bond, pressed.keep, state);
    }
    lanes.add(loads, lanes.load(b.i), lanes.load(b.j), state, load, slip_work);
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
  /// intact bond, and Verlet's next half kick spends them.
  template <class Lanes, class R, class Mask>
  GYRO_HD void note_failures(const Lanes& lanes, Index block, const BondLanes<Real, Lanes>& bond,
                             const BondLoad<R>& load, const Mask& broken, const BondConstants<R>& constants) const {
    const auto after = Law::pressed(constants, bond.section, bond.strain_r, bond.rates);
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
      if (list.blocks[block].state == block_intact) {
        list.blocks[block].state = block_broken;
        raise_flag(log.block_cracked);
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
