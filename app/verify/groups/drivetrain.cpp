// SPDX-License-Identifier: GPL-3.0-or-later
// Motor, gear and shaft against closed forms, and the work of the drivetrain against the work on the rock.
#include "app/verify/fixtures/drives.hpp"
#include "app/verify/fixtures/gyrating_gap.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "mbd/shaft.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

/// Time of the run-up from rest to a slip, without load.
void run_up(Recorder& out) {
  constexpr double inertia = 500, synchronous = 100, torque = 1000, breakdown = 0.1;
  for (const auto& [slip, printed] : kloss_times) {
    Drivetrain drive({.motor = textbook_kloss(), .eccentric_inertia = inertia, .start = DrivetrainStart::rest});
    for (int k = 0; k < 2000; ++k) exchange(drive, window_number(k, printed / 2000), no_rock);
    const double acceleration = torque * 2 * slip * breakdown / (slip * slip + breakdown * breakdown) / inertia;
    const double late = (synchronous * (1 - slip) - drive.state().speed) / acceleration;
    out.absolute("time-to-slip-" + std::to_string(std::lround(100 * slip)), printed + late, printed, {2e-6, 2e-6},
                 "integral of J dw/T");
  }
}

void kloss(Recorder& out) {
  const InductionMotor motor = textbook_kloss();
  const std::string curve = "Kloss: 2 Tb s sb/(s^2 + sb^2)";
  out.relative("locked-rotor", motor.torque(0), 198.0198, {1e-6, 1e-6}, curve);
  out.relative("breakdown", motor.torque(90), 1000, {1e-13, 1e-13}, curve);
  out.absolute("synchronous", motor.torque(100), 0, {0, 0}, curve);
  out.relative("generator", motor.torque(105), -800, {1e-12, 1e-12}, curve);
  out.relative("plugging", motor.torque(-50), 1000 * 2 / (15 + 1 / 15.0), {1e-12, 1e-12}, curve);
  out.relative("rated-power", motor.torque(motor.rated_speed()) * motor.rated_speed(), motor.rated_power,
               {1e-12, 1e-12}, "name plate");
}

/// The speed of a droop motor runs up as w_idle (1 - exp(-t/tau)), tau = (J_e + i^2 J_m) w_idle/(i T).
void gear(Recorder& out) {
  constexpr double ratio = 3.75, motor_inertia = 50, inertia = 700, synchronous = 60, stall = 2000;
  const double reflected = 14.0625 * motor_inertia, idle = synchronous / ratio;
  const double tau = (inertia + reflected) * idle / (ratio * stall);
  Drivetrain drive({.motor = DroopMotor{.synchronous_speed = synchronous, .stall_torque = stall},
                    .gear_ratio = ratio,
                    .motor_inertia = motor_inertia,
                    .eccentric_inertia = inertia,
                    .start = DrivetrainStart::rest});
  for (int k = 0; k < 100; ++k) exchange(drive, window_number(k, tau / 100), no_rock);
  const std::string theory = "J_e + i^2 J_m, i = 3.75: 14.0625 J_m";
  out.relative("speed", drive.state().speed, idle * (1 - std::exp(-1.0)), {1e-9, 1e-9}, theory);
  out.relative("angle", drive.state().angle, idle * tau * std::exp(-1.0), {1e-9, 1e-9}, theory);
  out.relative("motor-speed", drive.motor_speed(), ratio * drive.state().speed, {1e-15, 1e-15}, "ratio of the gear");
  out.relative("power-through", drive.state().motor_work,
               0.5 * (inertia + reflected) * std::pow(drive.state().speed, 2), {1e-9, 1e-9},
               "rigid: power in is power out");
}

/// With losses, J dw/dt = T (1 - w/ws) - T0 - (1 + f) T_rock - c w is linear in w, so that the speed approaches its
/// limit exponentially.
void losses(Recorder& out) {
  const double slope = 50e3 / 20 + 100, rock = 12e3, dry = 60e3 / 20, end = 0.7;
  Drivetrain drive({.motor = DroopMotor{.synchronous_speed = 20, .stall_torque = 50e3},
                    .eccentric_inertia = 4000,
                    .losses = {.no_load_power = 60e3, .load_factor = 0.05, .viscous = 100}});
  const double idle = (50e3 - dry) / slope, loaded = (50e3 - dry - 1.05 * rock) / slope;
  out.relative("idle-speed", drive.state().speed, idle, {1e-12, 1e-12}, "balance of torques");
  for (int k = 0; k < 350; ++k) exchange(drive, window_number(k, end / 350), [&](double, double) { return rock; });
  out.relative("speed", drive.state().speed, loaded + (idle - loaded) * std::exp(-slope / 4000 * end), {1e-9, 1e-9},
               "exponential approach");
}

/// Motor work = gain in kinetic energy + rock work + losses, for the shaft alone.
void energy_of_the_shaft(Recorder& out) {
  const std::array<Motor, 2> motors{induction_450kw(), paper_droop()};
  for (std::size_t m = 0; m < motors.size(); ++m)
    for (const double length : {0.5e-3, 50e-3}) {
      DrivetrainParameters machine{.motor = motors[m],
                                   .gear_ratio = 3.75,
                                   .gear_efficiency = 0.96,
                                   .motor_inertia = 50,
                                   .eccentric_inertia = 5000,
                                   .losses = {.no_load_power = 60e3, .load_factor = 0.05, .viscous = 20}};
      Shaft shaft(machine);
      ShaftMotion motion{.speed = idle_speed(machine), .direction = +1};
      double motor_work = 0, spent = 0;
      for (int k = 0; k < 500; ++k) {
        const double rock = 21e3 * (1 + std::sin(0.13 * k));
        const ShaftAdvance window = shaft.advance(length, rock, motion);
        motor_work += window.motor_work;
        spent += rock * window.angle + window.loss_work + window.kinetic_gain;
      }
      const std::string name = (m == 0 ? "induction-" : "droop-") + std::to_string(std::lround(1e4 * length)) + "e-4-s";
      out.relative(name, motor_work / spent, 1, {1e-6, 1e-6}, "first law");
    }
}

/// Time to stall of a droop motor with the stall torque T0 under a constant overload L: tau ln(L/(L - T0)).
void stall(Recorder& out) {
  const double load = 120e3, stall_torque = 96e3, inertia = 5000 + 14.0625 * 50;
  const double tau = inertia * 160 * rpm / stall_torque;
  Drivetrain drive(crusher_62_75(paper_droop()));
  for (int k = 0; !drive.stalled() && k < 20000; ++k)
    exchange(drive, window_number(k, 2e-3), [&](double, double) { return load; });
  out.relative("time", drive.stall_time().value_or(0), tau * std::log(load / (load - stall_torque)), {1e-8, 1e-8},
               "integral of J dw/(L - T)");
}

/// Spheres between a gyrating mantle and a concave slow down the drive of the mantle. @param length  of windows [s]
/// @return |motor work - losses - rock work - gain in kinetic energy| / rock work
double residual_of_exchange(Precision precision, double length) {
  constexpr double dt = 5e-6, idle = 60;
  const GyratingGap gap(dt);
  const auto dem = make_cpu_dem(gap.scene, precision, 1);
  dem->insert(gap.spheres);
  Drivetrain drive({.motor = DroopMotor{.synchronous_speed = idle, .stall_torque = 500}, .eccentric_inertia = 5});
  const int steps = static_cast<int>(std::lround(length / dt));
  for (int k = 0; k * length < 0.2; ++k) {
    const Window window{std::int64_t{k} * steps, steps, dt};
    const MantlePath path = drive.predict(window);
    dem->advance(window, path);
    drive.advance(window, {.work = dem->wall_loads()[0].work});
  }
  return std::abs(drive.energy_residual()) / drive.state().rock_work;
}

/// The rock receives the work that the drive does.
void shared_work(Recorder& out) {
  out.absolute("account", residual_of_exchange(out.precision(), 0.5e-3), 0, {1e-3, 1e-3},
               "first law, windows of 0.5 ms");
}

}  // namespace

std::vector<Verification> drivetrain_cases() {
  return {
      {"drivetrain/run-up", run_up, Precisions::double_only},
      {"drivetrain/kloss", kloss, Precisions::double_only},
      {"drivetrain/gear", gear, Precisions::double_only},
      {"drivetrain/losses", losses, Precisions::double_only},
      {"drivetrain/energy", energy_of_the_shaft, Precisions::double_only},
      {"drivetrain/stall", stall, Precisions::double_only},
      {"drivetrain/shared-work", shared_work},
  };
}

}  // namespace gyro::verify
