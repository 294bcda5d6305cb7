// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/shaft.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

// Unknowns of one leg that every drive has. All are gains since its start, so that the tolerance is relative to the
// small change in an interval, not to the speed or to an angle that grows without limit. The works are unknowns as
// well, so that the energy balance is as accurate as the solution.
enum Unknown { angle_gain, speed_gain, motor_impulse, motor_work, loss_work, unknowns };

// rad, rad/s, N m s, J, J: each about 1e-10 of the change in a window of 0.5 ms in a large crusher
constexpr std::array<double, unknowns> absolute_tolerance{1e-13, 1e-13, 1e-9, 1e-8, 1e-8};
constexpr double optional_tolerance = 1e-13;  // rad, rad/s, 1, s

constexpr int max_legs = 100;           // stick and slip, trips and restarts of one interval
constexpr double shortest_leg = 1e-12;  // [s]

double gain(std::span<const double> y, int index) {
  return index < 0 ? 0 : y[static_cast<std::size_t>(index)];
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

}  // namespace

Shaft::Layout::Layout(const DrivetrainParameters& parameters) : size(unknowns) {
  if (parameters.mantle_inertia > 0) {
    spin_angle = size++;
    spin_gain = size++;
  }
  if (parameters.spring.stiffness > 0) {
    twist_gain = size++;
    motor_gain = size++;
  }
  if (parameters.protection.overload_time > 0) heat_gain = size++;
  if (parameters.voltage.changes()) clock = size++;
}

CvodeSession Shaft::session_of(const Layout& layout) {
  std::vector<double> tolerance(static_cast<std::size_t>(layout.size), optional_tolerance);
  std::ranges::copy(absolute_tolerance, tolerance.begin());
  return CvodeSession(
      {.size = layout.size, .absolute_tolerance = tolerance},
      [this](std::span<const double> y, std::span<double> rate) { evaluate(y, rate); },
      [this](std::span<const double> y, std::span<double> values) { watch(y, values); }, all_events);
}

Shaft::Shaft(const DrivetrainParameters& parameters)
    : parameters_(parameters),
      model_(parameters),
      protection_(parameters.protection, parameters.protection.any() ? gyro::idle_speed(parameters) : 0),
      layout_(parameters),
      session_(session_of(layout_)) {}

ShaftMotion Shaft::start() const {
  ShaftMotion motion;
  if (parameters_.start == DrivetrainStart::rest) return motion;
  const IdleMantle mantle = idle_mantle(parameters_);
  motion.speed = idle_speed();
  motion.direction = +1;
  if (model_.has_spring()) motion.motor_speed = parameters_.gear_ratio * motion.speed;
  if (model_.mantle_spins()) {
    motion.spin = mantle.spin_ratio * motion.speed;
    motion.slip = mantle.slip;
  }
  const ShaftPoint now = point(motion);
  if (model_.has_spring()) motion.twist = model_.motor_torque_at(now, +1) / model_.spring_stiffness();
  const double current = model_.motor_current_at(now, +1);
  motion.motor.heat = current * current;
  return motion;
}

ShaftPoint Shaft::point(const ShaftMotion& m) const {
  return {m.speed, m.spin, motor_speed(m), m.twist, parameters_.voltage.at(m.time)};
}

ShaftPoint Shaft::point(std::span<const double> y) const {
  ShaftMotion now = begin_;
  now.speed += y[speed_gain];
  now.spin += gain(y, layout_.spin_gain);
  now.motor_speed += gain(y, layout_.motor_gain);
  now.twist += gain(y, layout_.twist_gain);
  now.time += gain(y, layout_.clock);
  return point(now);
}

ShaftBalance Shaft::balance(const ShaftPoint& now) const {
  return model_.balance(now, signs_, begin_.motor.sense, protection_.brake_torque(begin_.motor));
}

void Shaft::evaluate(std::span<const double> y, std::span<double> rate) const {
  const ShaftPoint now = point(y);
  const ShaftBalance b = balance(now);
  const auto set = [&](int index, double value) {
    if (index >= 0) rate[static_cast<std::size_t>(index)] = value;
  };
  rate[angle_gain] = now.speed;
  rate[speed_gain] = b.acceleration;
  rate[motor_impulse] = b.motor_torque;
  rate[motor_work] = b.motor_power;
  rate[loss_work] = b.loss_power;
  set(layout_.spin_angle, now.spin);
  set(layout_.spin_gain, b.spin_acceleration);
  set(layout_.twist_gain, now.motor_speed - model_.gear_ratio() * now.speed);
  set(layout_.motor_gain, b.motor_acceleration);
  set(layout_.clock, 1);
  if (layout_.heat_gain >= 0)
    set(layout_.heat_gain, protection_.heat_rate(model_.motor_current_at(now, begin_.motor.sense),
                                                 begin_.motor.heat + gain(y, layout_.heat_gain)));
}

void Shaft::watch(std::span<const double> y, std::span<double> values) const {
  const ShaftPoint now = point(y);
  std::ranges::fill(values, 1.0);
  if (signs_.direction != 0) values[halts] = now.speed;
  if (model_.mantle_spins() && signs_.slip != 0) values[catches_up] = now.spin - model_.cos_tilt() * now.speed;
  const bool stuck = signs_.direction == 0, dragged = model_.mantle_spins() && signs_.slip == 0;
  if (stuck || dragged) {
    const ShaftBalance b = balance(now);
    if (dragged) values[breaks_drag] = model_.inner_torque() - std::abs(b.bushing_torque);
    if (stuck) values[starts_forward] = -b.stuck_forward;
    if (stuck) values[starts_backward] = b.stuck_backward;
  }
  if (layout_.heat_gain >= 0 || parameters_.protection.any())
    protection_.watch(begin_.motor, model_.motor_current_at(now, begin_.motor.sense),
                      begin_.motor.heat + gain(y, layout_.heat_gain), now.speed, values.subspan(own_events));
}

/// Whether the accelerations under these signs agree with them.
/// @param at_rest   the eccentric stands still, its direction is open
/// @param together  the mantle turns with the eccentric, its slip is open
bool Shaft::consistent(const ShaftPoint& now, FrictionSigns signs, bool at_rest, bool together) const {
  const ShaftBalance b = model_.balance(now, signs, begin_.motor.sense, protection_.brake_torque(begin_.motor));
  if (at_rest && signs.direction == 0 && (b.stuck_forward > 0 || b.stuck_backward < 0)) return false;
  if (at_rest && signs.direction != 0 && !(signs.direction * b.acceleration > 0)) return false;
  if (!together) return true;
  if (signs.slip == 0) return std::abs(b.bushing_torque) <= model_.inner_torque();
  return signs.slip * (b.spin_acceleration - model_.cos_tilt() * b.acceleration) > 0;
}

/// Signs for the next leg: those of the motion if it moves, otherwise the first that are consistent.
/// @param after_leg  a leg has just ended: if it ended where friction gave way, the motion starts
FrictionSigns Shaft::settle_friction(const ShaftMotion& motion, bool after_leg) const {
  if (after_leg && (session_.fired(starts_forward) || session_.fired(starts_backward)))
    return {session_.fired(starts_forward) ? +1 : -1, motion.slip};
  if (after_leg && session_.fired(breaks_drag))
    return {signs_.direction, balance(point(motion)).bushing_torque > 0 ? -1 : +1};
  const bool spins = model_.mantle_spins();
  const bool at_rest = motion.speed == 0 && !model_.ideal(), together = spins && motion.slip == 0;
  const ShaftPoint now = point(motion);
  for (const int direction : {0, +1, -1}) {
    if (!at_rest && direction != sign(motion.speed)) continue;
    for (const int slip : {0, -1, +1}) {
      if (spins ? !together && slip != motion.slip : slip != 0) continue;
      if (consistent(now, {direction, slip}, at_rest, together)) return {direction, slip};
    }
  }
  // Reached only by rounding, on the limit between two states.
  return {at_rest ? 0 : sign(motion.speed), motion.slip};
}

/// Whether the drive stands still and no clock, spring or mantle can set it in motion.
bool Shaft::changes_nothing(const ShaftMotion& motion) const {
  return signs_.direction == 0 && !model_.has_spring() && layout_.heat_gain < 0 && layout_.clock < 0 &&
         (!model_.mantle_spins() || (signs_.slip == 0 && motion.spin == 0));
}

void Shaft::add_leg(std::span<const double> y, double lasted, ShaftMotion& motion, ShaftAdvance& sum) const {
  const ShaftMotion before = motion;
  motion.speed += y[speed_gain];
  motion.spin += gain(y, layout_.spin_gain);
  motion.motor_speed += gain(y, layout_.motor_gain);
  motion.twist += gain(y, layout_.twist_gain);
  motion.time += lasted;
  motion.motor.heat += gain(y, layout_.heat_gain);
  if (model_.mantle_spins() && signs_.slip == 0) motion.spin = model_.cos_tilt() * motion.speed;
  const auto kinetic = [](double inertia, double from, double by) { return inertia * by * (from + by / 2); };
  sum.angle += y[angle_gain];
  sum.spin_angle += gain(y, layout_.spin_angle);
  sum.motor_angle += model_.gear_ratio() * y[angle_gain] + gain(y, layout_.twist_gain);
  sum.speed_change += y[speed_gain];
  sum.motor_impulse += y[motor_impulse];
  sum.motor_work += y[motor_work];
  sum.loss_work += y[loss_work];
  sum.kinetic_gain += kinetic(model_.inertia(), before.speed, y[speed_gain]) +
                      kinetic(model_.mantle_inertia(), before.spin, motion.spin - before.spin) +
                      kinetic(model_.motor_inertia(), before.motor_speed, gain(y, layout_.motor_gain)) +
                      kinetic(model_.spring_stiffness(), before.twist, gain(y, layout_.twist_gain));
}

/// One leg, with fixed signs and a fixed switch. @return its duration [s]
double Shaft::leg(double duration, ShaftMotion& motion, ShaftAdvance& sum) {
  begin_ = motion;
  if (changes_nothing(motion)) {
    sum.motor_impulse += model_.motor_torque_at(point(motion), motion.motor.sense) * duration;
    motion.time += duration;
    return duration;
  }
  std::vector<double> y(static_cast<std::size_t>(layout_.size), 0);
  const double lasted = session_.integrate(duration, y);
  if (session_.fired(halts)) y[speed_gain] = -begin_.speed;  // exactly 0 at the root
  add_leg(y, lasted, motion, sum);
  if (session_.fired(halts) && signs_.slip == 0) motion.spin = 0;
  if (session_.fired(catches_up)) {
    motion.spin = model_.cos_tilt() * motion.speed;
    motion.slip = 0;
  }
  return lasted;
}

void Shaft::halt(ShaftMotion& motion, double done, ShaftAdvance& sum) const {
  if (signs_.direction > 0) sum.stopped_after = done;
  const bool driven = motion.motor.sense * signs_.direction > 0;
  const bool against = motion.motor.sense * signs_.direction < 0;
  if (driven) sum.events.push_back({motion.time, DriveEventKind::stall});
  if (!driven && !against) sum.events.push_back({motion.time, DriveEventKind::standstill});
}

void Shaft::switch_motor(ShaftMotion& motion, ShaftAdvance& sum, bool after_leg) const {
  if (!parameters_.protection.any()) return;
  std::array<bool, Protection::events> fired{};
  for (int k = 0; k < Protection::events && after_leg; ++k)
    fired[static_cast<std::size_t>(k)] = session_.fired(own_events + k);
  const auto settle = [&] {
    const double current = model_.motor_current_at(point(motion), motion.motor.sense);
    protection_.settle(motion.motor, motion.time, current, motion.speed, fired, sum.events);
  };
  const double before = motion.motor.sense;
  settle();
  if (before == 0 && motion.motor.sense != 0) settle();  // switched on: it may trip at once
}

ShaftAdvance Shaft::advance(double duration, const ShaftLoad& load, ShaftMotion& motion) {
  model_.set_load(load);
  if (model_.ideal() && !model_.mantle_spins()) return advance_at_constant_speed(duration, motion);
  ShaftAdvance sum;
  double done = 0;
  bool after_leg = false;
  for (int number = 0; number < max_legs; ++number) {
    switch_motor(motion, sum, after_leg);
    set_signs(motion, sum, after_leg);
    const double rest = duration - done;
    const double until = std::min(rest, std::max(protection_.next_deadline(motion.motor) - motion.time, 0.0));
    const double lasted = until > shortest_leg ? leg(until, motion, sum) : until;
    after_leg = lasted < until;
    done += lasted;
    if (after_leg && session_.fired(halts)) halt(motion, done, sum);
    if (!(lasted < rest) || duration - done < shortest_leg) return sum;
  }
  throw StoppedByGuard(
      "the drive changed its state too often in one window under a constant load; check motor, losses and bearings");
}

void Shaft::set_signs(ShaftMotion& motion, ShaftAdvance& sum, bool after_leg) {
  begin_ = motion;
  signs_ = settle_friction(motion, after_leg);
  const double sense = motion.motor.sense;
  if (signs_.direction * sense < 0 && motion.direction * sense >= 0)
    sum.events.push_back({motion.time, DriveEventKind::turned_back});
  if (signs_.direction == 0 && motion.direction * sense < 0) sum.events.push_back({motion.time, DriveEventKind::held});
  motion.direction = signs_.direction;
  motion.slip = signs_.slip;
}

ShaftAdvance Shaft::advance_at_constant_speed(double duration, ShaftMotion& motion) const {
  const ShaftBalance b = model_.balance(point(motion), {+1, 0}, +1, 0);
  ShaftAdvance sum;
  sum.angle = motion.speed * duration;
  sum.motor_angle = model_.gear_ratio() * sum.angle;
  sum.motor_impulse = b.motor_torque * duration;
  sum.motor_work = b.motor_torque * sum.motor_angle;
  sum.loss_work = b.loss_power * duration;
  motion.time += duration;
  return sum;
}

double Shaft::energy(const ShaftMotion& m) const {
  return 0.5 * (model_.inertia() * m.speed * m.speed + model_.mantle_inertia() * m.spin * m.spin +
                model_.motor_inertia() * m.motor_speed * m.motor_speed + model_.spring_stiffness() * m.twist * m.twist);
}

double Shaft::motor_torque_now(const ShaftMotion& motion, const ShaftLoad& load) const {
  ShaftModel model = model_;
  model.set_load(load);
  return model.balance(point(motion), {motion.direction, motion.slip}, motion.motor.sense, 0).motor_torque;
}

}  // namespace gyro
