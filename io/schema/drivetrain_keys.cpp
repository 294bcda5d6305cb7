// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/keys.hpp"

namespace gyro {
namespace {

using enum KeyType;
using enum Dimension;

constexpr double infinite = std::numeric_limits<double>::infinity();

// The formatter would put every field on its own line.
// clang-format off
const std::vector<Key> table = {
    {.path = "drivetrain", .doc = "Motor, gear and inertia that turn the eccentric; without the section the case has no gyration."},
    {.path = "drivetrain.fmu", .type = file,
     .doc = "FMI 2.0 co-simulation FMU for linux64 that turns the eccentric, instead of all keys from motor on; it is native "
            "code that runs with your rights, so use only what you trust."},
    {.path = "drivetrain.map", .when = "fmu",
     .doc = "Names of the FMU's variables where they differ from the names here; -name reverses the sign; declared units are "
            "converted."},
    {.path = "drivetrain.map.mantle_torque", .type = text,
     .doc = "Input: torque of the rock on the eccentric, positive when it resists; required."},
    {.path = "drivetrain.map.spin_torque", .type = text, .doc = "Input: torque of the rock on the mantle about its own axis."},
    {.path = "drivetrain.map.bushing_force", .type = text, .doc = "Input: force of the rock on the eccentric's bushings; needs bushing_depth."},
    {.path = "drivetrain.map.spider_force", .type = text, .doc = "Input: force of the rock on the spider; needs bushing_depth."},
    {.path = "drivetrain.map.eccentric_speed", .type = text, .doc = "Output: speed of the eccentric; required."},
    {.path = "drivetrain.map.eccentric_angle", .type = text,
     .doc = "Output: continuous angle of the eccentric; without it the mean of the speeds at both ends of a window is used."},
    {.path = "drivetrain.map.mantle_spin", .type = text,
     .doc = "Output: speed of the mantle about its own axis; without it the mantle does not spin."},
    {.path = "drivetrain.map.mantle_spin_angle", .type = text,
     .doc = "Output: angle of the mantle's spin; without it the mean of the speeds at both ends of a window is used."},
    {.path = "drivetrain.map.motor_speed", .type = text, .doc = "Output: speed of the motor, for the series."},
    {.path = "drivetrain.map.motor_angle", .type = text,
     .doc = "Output: integral of motor_speed; without it the mean of the values at both ends of a window is used."},
    {.path = "drivetrain.map.motor_torque", .type = text, .doc = "Output: torque at the motor's shaft, for the series."},
    {.path = "drivetrain.map.motor_impulse", .type = text,
     .doc = "Output: integral of motor_torque; without it the mean of the values at both ends of a window is used."},
    {.path = "drivetrain.map.motor_power", .type = text,
     .doc = "Output: mechanical power of the motor, for the series; without it torque times speed is used."},
    {.path = "drivetrain.map.motor_work", .type = text,
     .doc = "Output: integral of motor_power; with loss_work and kinetic_energy it gives the energy balance of the exchange."},
    {.path = "drivetrain.map.loss_work", .type = text, .doc = "Output: work of the losses since the start."},
    {.path = "drivetrain.map.kinetic_energy", .type = text, .doc = "Output: kinetic energy, including the energy of springs."},
    {.path = "drivetrain.map.tripped", .type = text,
     .doc = "Output, true or false: the motor is switched off; trips and restarts are reported."},
    {.path = "drivetrain.parameters", .type = values, .when = "fmu",
     .doc = "Values of the FMU's parameters by name, in the FMU's units, set before the start; the other parameters keep the "
            "values of the FMU."},
    {.path = "drivetrain.bushing_depth", .type = quantity, .dimension = length, .range = positive, .when = "fmu",
     .doc = "Height from the eccentric's bushings up to the pivot, for an FMU that takes bushing_force or spider_force."},
    {.path = "drivetrain.motor", .required = true, .when = "!fmu", .doc = "Torque of the motor against its speed."},
    {.path = "drivetrain.motor.model", .type = word, .required = true, .words = "induction|double_cage|nema|droop|curve|constant_speed",
     .doc = "induction: formula of Kloss; double_cage: with the starting torque of its name plate; nema: a typical motor of a "
            "design letter; droop: a straight line; curve: a table; constant_speed: ideal drive."},
    {.path = "drivetrain.motor.rated_power", .type = quantity, .dimension = power, .range = positive, .when = "model=induction|double_cage|nema",
     .doc = "Mechanical power at rated slip."},
    {.path = "drivetrain.motor.synchronous_speed", .type = quantity, .dimension = angular_speed, .range = positive,
     .when = "model=induction|double_cage|nema|droop", .doc = "Speed at zero torque."},
    {.path = "drivetrain.motor.design", .type = word, .words = "A|B|C|D", .when = "model=nema",
     .doc = "NEMA design letter; C is usual for crushers that start under load, D for flywheel loads."},
    {.path = "drivetrain.motor.rated_slip", .type = quantity, .range = {.low = 0, .high = 1, .low_open = true, .high_open = true},
     .when = "model=induction|double_cage", .doc = "1 - rated speed / synchronous speed."},
    {.path = "drivetrain.motor.breakdown_ratio", .type = quantity, .range = {.low = 1, .high = infinite, .low_open = true},
     .when = "model=induction|double_cage", .doc = "Pull-out torque / rated torque."},
    {.path = "drivetrain.motor.starting_ratio", .type = quantity, .range = positive, .when = "model=double_cage",
     .doc = "Torque at standstill / rated torque."},
    {.path = "drivetrain.motor.stall_torque", .type = quantity, .dimension = torque, .range = positive, .when = "model=droop",
     .doc = "Torque at standstill."},
    {.path = "drivetrain.motor.file", .type = file, .when = "model=curve",
     .doc = "CSV with the header speed_rpm,torque_Nm, from 0 rpm on: torques > 0 up to the synchronous speed; rows above it, with "
            "negative torque, are the generator's."},
    {.path = "drivetrain.motor.speed", .type = quantity, .dimension = angular_speed, .range = positive, .when = "model=constant_speed",
     .doc = "Speed of the motor."},
    {.path = "drivetrain.motor.voltage", .type = quantity, .range = {.low = 0, .high = 2, .low_open = true},
     .doc = "Supply voltage / rated voltage, 1 by default; torque is proportional to its square, a droop line is shifted "
            "instead; not with constant_speed."},
    {.path = "drivetrain.motor.voltage_file", .type = file,
     .doc = "Instead of voltage: CSV with the header time_s,voltage_ratio, linear between the rows, for example of a soft "
            "starter."},
    {.path = "drivetrain.gear_ratio", .type = quantity, .required = true, .range = positive, .when = "!fmu", .doc = "Motor speed / eccentric speed."},
    {.path = "drivetrain.gear_efficiency", .type = quantity, .fallback = "1", .range = {.low = 0, .high = 1, .low_open = true},
     .when = "!fmu", .doc = "Share of the power that the gear transmits."},
    {.path = "drivetrain.inertia", .defaulted = true, .when = "!fmu",
     .doc = "Moments of inertia; at least one must be > 0 unless the speed is constant."},
    {.path = "drivetrain.inertia.motor", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Inertia of motor, coupling and pinion about the motor's shaft."},
    {.path = "drivetrain.inertia.eccentric", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Inertia of the eccentric and its gear about the machine's axis."},
    {.path = "drivetrain.losses", .defaulted = true, .when = "!fmu", .doc = "Losses between motor and rock, as torques at the eccentric."},
    {.path = "drivetrain.losses.no_load", .type = quantity, .dimension = power, .fallback = "0", .range = not_negative,
     .doc = "Power of the idle crusher at rated speed; it acts as a constant torque."},
    {.path = "drivetrain.losses.load_factor", .type = quantity, .fallback = "0", .range = not_negative,
     .doc = "Share of the rock's torque that the bushings lose; leave it at 0 if drivetrain.bearings computes this loss from the "
            "forces."},
    {.path = "drivetrain.losses.viscous", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Viscous torque / speed of the eccentric."},
    {.path = "drivetrain.start", .type = word, .fallback = "running", .words = "running|rest",
     .when = "!fmu",
     .doc = "running: at t = 0 the machine runs without load and the motor carries the losses; rest: the motor is switched on at "
            "t = 0."},

    {.path = "drivetrain.coupling_spring", .when = "!fmu",
     .doc = "Torsional spring between motor and pinion; without it the shaft is rigid."},
    {.path = "drivetrain.coupling_spring.stiffness", .type = quantity, .dimension = torque, .required = true, .range = positive,
     .doc = "Torque / twist at the motor's shaft (N m per rad)."},
    {.path = "drivetrain.coupling_spring.damping", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Torque / rate of twist."},

    {.path = "drivetrain.mantle_inertia", .type = quantity, .dimension = inertia, .range = positive,
     .when = "!fmu",
     .doc = "Inertia of the mantle with its shaft about its own axis; with it the mantle spins freely between bushing, spider "
            "and rock, without it the mantle does not spin."},
    {.path = "drivetrain.bearings", .when = "!fmu", .doc = "Dry friction of the bearings that carry the crushing force: friction x radius x (idle_force + force of the rock)."},
    {.path = "drivetrain.bearings.bushing_depth", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Height from the eccentric's bushings up to the pivot."},
    {.path = "drivetrain.bearings.outer", .doc = "Bearing of the eccentric in the frame; it brakes the eccentric."},
    {.path = "drivetrain.bearings.outer.friction", .type = quantity, .required = true, .range = not_negative,
     .doc = "Friction coefficient; 0.003 to 0.01 for oil-fed bronze."},
    {.path = "drivetrain.bearings.outer.radius", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Radius of the sliding surface."},
    {.path = "drivetrain.bearings.outer.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},
    {.path = "drivetrain.bearings.inner",
     .doc = "Bearing of the mantle's shaft in the eccentric; it drags the mantle along with the eccentric."},
    {.path = "drivetrain.bearings.inner.friction", .type = quantity, .required = true, .range = not_negative,
     .doc = "Friction coefficient."},
    {.path = "drivetrain.bearings.inner.radius", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Radius of the sliding surface."},
    {.path = "drivetrain.bearings.inner.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},
    {.path = "drivetrain.bearings.spider", .doc = "Bearing of the mantle's shaft in the spider, at the pivot; it holds the mantle back."},
    {.path = "drivetrain.bearings.spider.friction", .type = quantity, .required = true, .range = not_negative,
     .doc = "Friction coefficient."},
    {.path = "drivetrain.bearings.spider.radius", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Radius of the sliding surface."},
    {.path = "drivetrain.bearings.spider.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},

    {.path = "drivetrain.protection", .when = "!fmu",
     .doc = "Relays that switch the motor off, and its restart; currents are relative to the rated current."},
    {.path = "drivetrain.protection.overload_time", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "Time constant of the thermal image of an inverse-time relay, which trips at overload_ratio^2 (IEC 60255-149)."},
    {.path = "drivetrain.protection.overload_ratio", .type = quantity, .fallback = "1.05", .range = positive,
     .doc = "Current that the thermal image carries continuously."},
    {.path = "drivetrain.protection.instantaneous_ratio", .type = quantity, .range = positive,
     .doc = "Current that trips at once; choose it above the starting current."},
    {.path = "drivetrain.protection.under_speed", .type = quantity, .range = {.low = 0, .high = 1, .low_open = true, .high_open = true},
     .doc = "Share of the idle speed; once the speed has been above it, the relay trips when it stays below for "
            "under_speed_delay."},
    {.path = "drivetrain.protection.under_speed_delay", .type = quantity, .dimension = Dimension::time, .fallback = "0", .range = not_negative,
     .doc = "Time below under_speed before it trips."},
    {.path = "drivetrain.protection.rated_torque", .type = quantity, .dimension = torque, .range = positive,
     .doc = "Rated torque of the motor, whose current is |torque| / rated_torque; for droop and curve, if a relay measures the "
            "current."},
    {.path = "drivetrain.protection.brake_torque", .type = quantity, .dimension = torque, .fallback = "0", .range = not_negative,
     .doc = "Torque of a dry brake at the motor's shaft from a trip to the restart; 0: the machine coasts."},
    {.path = "drivetrain.protection.restart_delay", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "Time from a trip to the restart; without it the motor stays off."},
    {.path = "drivetrain.protection.restarts", .type = integer, .fallback = "1", .range = {.low = 0, .high = 1000},
     .doc = "Largest number of restarts."},
    {.path = "drivetrain.protection.restart_sense", .type = word, .fallback = "same", .words = "same|reversed",
     .doc = "reversed: each restart reverses the sense of rotation, to clear the chamber."},
};
// clang-format on

}  // namespace

const std::vector<Key>& drivetrain_keys() {
  return table;
}

}  // namespace gyro
