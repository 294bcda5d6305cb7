// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/keys.hpp"

namespace gyro {
namespace {

using enum KeyType;
using enum Dimension;

constexpr double infinite = std::numeric_limits<double>::infinity();

// clang-format would put every field on its own line.
// clang-format off
const std::vector<Key> table = {
    {.path = "drivetrain", .doc = "Motor, gear and inertia that turn the eccentric; without this section there is no gyration."},
    {.path = "drivetrain.fmu", .type = file,
     .doc = "FMI 2.0 co-simulation FMU for linux64 that turns the eccentric; it replaces all keys from motor on. It contains native "
            "code that runs with your permissions, so use only FMUs that you trust."},
    {.path = "drivetrain.map", .when = "fmu",
     .doc = "Names of the FMU's variables where they differ from the names of these keys; -name reverses the sign; declared units are "
            "converted."},
    {.path = "drivetrain.map.mantle_torque", .type = text,
     .doc = "Input: torque of the rock on the eccentric, positive when it resists; required."},
    {.path = "drivetrain.map.spin_torque", .type = text, .doc = "Input: torque of the rock on the mantle about its own axis."},
    {.path = "drivetrain.map.bushing_force", .type = text, .doc = "Input: force of the rock on the eccentric's bushings; needs bushing_depth."},
    {.path = "drivetrain.map.spider_force", .type = text, .doc = "Input: force of the rock on the spider; needs bushing_depth."},
    {.path = "drivetrain.map.eccentric_speed", .type = text, .doc = "Output: speed of the eccentric; required."},
    {.path = "drivetrain.map.eccentric_angle", .type = text,
     .doc = "Output: continuous angle of the eccentric; if it is missing, the mean of the speeds at both ends of a window is used."},
    {.path = "drivetrain.map.mantle_spin", .type = text,
     .doc = "Output: speed of the mantle about its own axis; if it is missing, the mantle does not spin."},
    {.path = "drivetrain.map.mantle_spin_angle", .type = text,
     .doc = "Output: angle of the mantle's spin; if it is missing, the mean of the speeds at both ends of a window is used."},
    {.path = "drivetrain.map.motor_speed", .type = text, .doc = "Output: speed of the motor, for the series."},
    {.path = "drivetrain.map.motor_angle", .type = text,
     .doc = "Output: integral of motor_speed; if it is missing, the mean of the values at both ends of a window is used."},
    {.path = "drivetrain.map.motor_torque", .type = text, .doc = "Output: torque at the motor's shaft, for the series."},
    {.path = "drivetrain.map.motor_impulse", .type = text,
     .doc = "Output: integral of motor_torque; if it is missing, the mean of the values at both ends of a window is used."},
    {.path = "drivetrain.map.motor_power", .type = text,
     .doc = "Output: mechanical power of the motor, for the series; if it is missing, torque times speed is used."},
    {.path = "drivetrain.map.motor_work", .type = text,
     .doc = "Output: integral of motor_power; together with loss_work and kinetic_energy it gives the energy balance of the exchange."},
    {.path = "drivetrain.map.loss_work", .type = text, .doc = "Output: work of the losses since the start."},
    {.path = "drivetrain.map.kinetic_energy", .type = text, .doc = "Output: kinetic energy, including the energy of springs."},
    {.path = "drivetrain.map.tripped", .type = text,
     .doc = "Output: true while the motor is switched off; trips and restarts are then reported."},
    {.path = "drivetrain.parameters", .type = values, .when = "fmu",
     .doc = "Values of the FMU's parameters by name, in the FMU's units, set before the start; the other parameters keep their "
            "values in the FMU."},
    {.path = "drivetrain.bushing_depth", .type = quantity, .dimension = length, .range = positive, .when = "fmu",
     .doc = "Height from the eccentric's bushings up to the pivot, for an FMU with the input bushing_force or spider_force."},
    {.path = "drivetrain.motor", .required = true, .when = "!fmu", .doc = "Torque of the motor as a function of its speed."},
    {.path = "drivetrain.motor.model", .type = word, .required = true, .words = "induction|double_cage|nema|droop|curve|constant_speed",
     .doc = "induction: Kloss's formula; double_cage: also with the starting torque of the name plate; nema: a typical motor of a "
            "design letter; droop: a straight line; curve: a table; constant_speed: an ideal drive."},
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
     .doc = "CSV with the header speed_rpm,torque_Nm, starting at 0 rpm: torques > 0 up to the synchronous speed; rows above it have "
            "negative torques, because there the motor is a generator."},
    {.path = "drivetrain.motor.speed", .type = quantity, .dimension = angular_speed, .range = positive, .when = "model=constant_speed",
     .doc = "Speed of the motor."},
    {.path = "drivetrain.motor.voltage", .type = quantity, .range = {.low = 0, .high = 2, .low_open = true},
     .doc = "Supply voltage / rated voltage, 1 by default; the torque is proportional to its square, but a droop line is shifted; "
            "not with constant_speed."},
    {.path = "drivetrain.motor.voltage_file", .type = file,
     .doc = "Instead of voltage: CSV with the header time_s,voltage_ratio, with linear interpolation between the rows, for example "
            "for a soft starter."},
    {.path = "drivetrain.gear_ratio", .type = quantity, .required = true, .range = positive, .when = "!fmu", .doc = "Motor speed / eccentric speed."},
    {.path = "drivetrain.gear_efficiency", .type = quantity, .fallback = "1", .range = {.low = 0, .high = 1, .low_open = true},
     .when = "!fmu", .doc = "Share of the power that the gear transmits."},
    {.path = "drivetrain.inertia", .defaulted = true, .when = "!fmu",
     .doc = "Moments of inertia; at least one must be > 0 unless the speed is constant."},
    {.path = "drivetrain.inertia.motor", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Inertia of motor, coupling and pinion about the motor's shaft."},
    {.path = "drivetrain.inertia.eccentric", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Inertia of the eccentric and its gear about the machine's axis."},
    {.path = "drivetrain.losses", .defaulted = true, .when = "!fmu", .doc = "Losses between motor and rock, expressed as torques at the eccentric."},
    {.path = "drivetrain.losses.no_load", .type = quantity, .dimension = power, .fallback = "0", .range = not_negative,
     .doc = "Power of the idle crusher at rated speed; it acts as a constant torque."},
    {.path = "drivetrain.losses.load_factor", .type = quantity, .fallback = "0", .range = not_negative,
     .doc = "Share of the rock's torque that is lost in the bushings; leave it at 0 if drivetrain.bearings computes this loss from the "
            "forces."},
    {.path = "drivetrain.losses.viscous", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Viscous torque / speed of the eccentric."},
    {.path = "drivetrain.start", .type = word, .fallback = "running", .words = "running|rest",
     .when = "!fmu",
     .doc = "running: at t = 0 the machine runs without load, at the speed at which the motor balances the losses; rest: the motor is "
            "switched on at t = 0."},

    {.path = "drivetrain.coupling_spring", .when = "!fmu",
     .doc = "Torsional spring between motor and pinion; without this section the shaft is rigid."},
    {.path = "drivetrain.coupling_spring.stiffness", .type = quantity, .dimension = torque, .required = true, .range = positive,
     .doc = "Torque / twist at the motor's shaft (N m per rad)."},
    {.path = "drivetrain.coupling_spring.damping", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Torque / rate of twist."},

    {.path = "drivetrain.mantle_inertia", .type = quantity, .dimension = inertia, .range = positive,
     .when = "!fmu",
     .doc = "Inertia of the mantle with its shaft about its own axis. With this key the mantle spins freely between bushing, spider "
            "and rock; without it the mantle does not spin."},
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
     .doc = "Relays that switch the motor off, and its restart; currents are given relative to the rated current."},
    {.path = "drivetrain.protection.overload_time", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "Time constant of the thermal image of an inverse-time relay; the relay trips when the image reaches overload_ratio^2 "
            "(IEC 60255-149)."},
    {.path = "drivetrain.protection.overload_ratio", .type = quantity, .fallback = "1.05", .range = positive,
     .doc = "Current that the thermal image carries continuously."},
    {.path = "drivetrain.protection.instantaneous_ratio", .type = quantity, .range = positive,
     .doc = "Current that trips at once; choose it above the starting current."},
    {.path = "drivetrain.protection.under_speed", .type = quantity, .range = {.low = 0, .high = 1, .low_open = true, .high_open = true},
     .doc = "Share of the idle speed; after the speed has once been above it, the relay trips when the speed stays below it for "
            "under_speed_delay."},
    {.path = "drivetrain.protection.under_speed_delay", .type = quantity, .dimension = Dimension::time, .fallback = "0", .range = not_negative,
     .doc = "Time below under_speed after which the relay trips."},
    {.path = "drivetrain.protection.rated_torque", .type = quantity, .dimension = torque, .range = positive,
     .doc = "Rated torque of a droop or curve motor, whose current is taken as |torque| / rated_torque; needed if a relay measures "
            "the current."},
    {.path = "drivetrain.protection.brake_torque", .type = quantity, .dimension = torque, .fallback = "0", .range = not_negative,
     .doc = "Torque of a dry brake at the motor's shaft from a trip to the restart; 0: the machine coasts."},
    {.path = "drivetrain.protection.restart_delay", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "Time from a trip to the restart; without this key the motor stays off."},
    {.path = "drivetrain.protection.restarts", .type = integer, .fallback = "1", .range = {.low = 0, .high = 1000},
     .doc = "Maximum number of restarts."},
    {.path = "drivetrain.protection.restart_sense", .type = word, .fallback = "same", .words = "same|reversed",
     .doc = "reversed: each restart reverses the sense of rotation, to clear the chamber."},
};
// clang-format on

}  // namespace

const std::vector<Key>& drivetrain_keys() {
  return table;
}

}  // namespace gyro
