// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/drive_variable.hpp"

#include "core/base/errors.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace gyro {
namespace {

/// Collects variables that read and write fields.
class Collector {
 public:
  template <class T>
  void add(std::string name, std::string unit, T& field, std::string description) {
    const VariableType type = std::is_same_v<T, bool>  ? VariableType::boolean
                              : std::is_same_v<T, int> ? VariableType::integer
                                                       : VariableType::real;
    found.push_back({std::move(name), type, Causality::parameter, std::move(unit), std::move(description),
                     [&field] { return static_cast<double>(field); },
                     [&field](double value) {
                       if constexpr (std::is_same_v<T, bool>)
                         field = value != 0;
                       else
                         field = static_cast<T>(value);
                     }});
  }
  void add_list(const std::string& name, const std::string& unit, std::vector<double>& list, const std::string& what) {
    for (std::size_t k = 0; k < list.size(); ++k) add(name + "[" + std::to_string(k + 1) + "]", unit, list[k], what);
  }

  std::vector<DriveVariable> found;
};

/// The parameters of any motor law, as `motor.NAME`; lists as `motor.NAME[1]`, ...
void add_motor(Collector& c, Motor& motor) {
  for_each_parameter(
      [&]<class T>(const char* name, const char* unit, T& field, const char* description) {
        const std::string path = std::string("motor.") + name;
        if constexpr (std::is_same_v<T, std::vector<double>>)
          c.add_list(path, unit, field, description);
        else
          c.add(path, unit, field, description);
      },
      motor);
}

void add_bearing(Collector& c, const std::string& name, Bearing& bearing, const std::string& what) {
  c.add("bearings." + name + ".friction", "", bearing.friction, what + ": friction coefficient");
  c.add("bearings." + name + ".radius", "m", bearing.radius, what + ": radius of the sliding surface");
  c.add("bearings." + name + ".idle_force", "N", bearing.idle_force, what + ": force without rock");
}

void add_protection(Collector& c, ProtectionParameters& p) {
  c.add("protection.overload_time", "s", p.overload_time, "time constant of the thermal image; 0: no such relay");
  c.add("protection.overload_ratio", "", p.overload_ratio, "largest current that does not trip / rated current");
  c.add("protection.instantaneous_ratio", "", p.instantaneous_ratio,
        "current that trips immediately / rated current; 0: no such relay");
  c.add("protection.under_speed", "", p.under_speed, "share of the idle speed that trips; 0: no such relay");
  c.add("protection.under_speed_delay", "s", p.under_speed_delay, "time below under_speed before it trips");
  c.add("protection.rated_torque", "N.m", p.rated_torque, "of motors without a name plate");
  c.add("protection.brake_torque", "N.m", p.brake_torque, "dry brake at the motor's shaft from a trip to the restart");
  c.add("protection.restart_delay", "s", p.restart_delay, "time from a trip to the restart; 0: the motor stays off");
  c.add("protection.restarts", "", p.restarts, "largest number of restarts");
  c.add("protection.restart_reversed", "", p.restart_reversed, "each restart reverses the rotation");
}

/// Whether the drive starts at rest; in DrivetrainParameters this is an enumeration.
DriveVariable start_variable(DrivetrainParameters& p) {
  return {"starts_at_rest",
          VariableType::boolean,
          Causality::parameter,
          "",
          "the motor is switched on at standstill; otherwise it idles at the start",
          [&p] { return p.start == DrivetrainStart::rest ? 1.0 : 0.0; },
          [&p](double value) { p.start = value != 0 ? DrivetrainStart::rest : DrivetrainStart::running; }};
}

}  // namespace

std::vector<DriveVariable> parameter_variables(DrivetrainParameters& p) {
  Collector c;
  add_motor(c, p.motor);
  c.add_list("voltage.time", "s", p.voltage.times, "time of a point of the supply");
  c.add_list("voltage.ratio", "", p.voltage.ratios, "supply / rated voltage at that time");
  c.add("gear_ratio", "", p.gear_ratio, "motor speed / eccentric speed");
  c.add("gear_efficiency", "", p.gear_efficiency, "share of the power that passes the gear");
  c.add("inertia.motor", "kg.m2", p.motor_inertia, "motor, coupling and pinion, about the motor's shaft");
  c.add("inertia.eccentric", "kg.m2", p.eccentric_inertia, "eccentric and its gear, about the machine's axis");
  c.add("losses.no_load", "W", p.losses.no_load_power, "power of the idle crusher at rated speed");
  c.add("losses.load_factor", "", p.losses.load_factor, "share of the rock's torque that is lost in bushings");
  c.add("losses.viscous", "N.m.s/rad", p.losses.viscous, "torque / speed of the eccentric");
  c.found.push_back(start_variable(p));
  c.add("start_angle", "rad", p.start_angle, "of the eccentric");
  c.add("mantle_inertia", "kg.m2", p.mantle_inertia, "mantle about its own axis; 0: it does not spin");
  add_bearing(c, "outer", p.bearings.outer, "eccentric in the frame");
  add_bearing(c, "inner", p.bearings.inner, "mantle's shaft in the eccentric");
  add_bearing(c, "spider", p.bearings.spider, "mantle's shaft in the spider");
  c.add("bearings.bushing_depth", "m", p.bearings.depth, "from the eccentric's bushings up to the pivot");
  c.add("bearings.tilt_sine", "", p.bearings.tilt_sine, "eccentricity / pivot height");
  c.add("coupling_spring.stiffness", "N.m/rad", p.spring.stiffness, "at the motor's shaft; 0: a rigid shaft");
  c.add("coupling_spring.damping", "N.m.s/rad", p.spring.damping, "at the motor's shaft");
  add_protection(c, p.protection);
  return std::move(c.found);
}

}  // namespace gyro
