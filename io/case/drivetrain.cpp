// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/parts.hpp"

#include <type_traits>

namespace gyro {
namespace {

double number_or(const Setting& section, std::string_view path, double otherwise) {
  const Setting* setting = section.find(path);
  return setting == nullptr ? otherwise : setting->numbers.at(0);
}

NemaDesign design_of(const std::string& letter) {
  return static_cast<NemaDesign>(letter.at(0) - 'A');
}

/// The motor of a section. Each parameter that is a number has a key of the same name; the points of a curve come from
/// its table.
/// @throws BadInput for a name plate that no motor can have
Motor motor_of(const Setting& section, const CaseTables& tables) {
  const std::string& model = section.text("model");
  if (model == "nema")
    return nema_motor(design_of(section.text("design")), section.number("rated_power"),
                      section.number("synchronous_speed"));
  Motor motor = motor_of_model(model);
  for_each_parameter(
      [&]<class T>(const char* key, const char*, T& field, const char*) {
        if constexpr (std::is_same_v<T, double>) field = section.number(key);
      },
      motor);
  if (auto* curve = std::get_if<CurveMotor>(&motor)) *curve = tables.motor;
  complete_motor(motor);
  return motor;
}

Bearing bearing_of(const Setting& bearings, std::string_view name) {
  const Setting* section = bearings.find(name);
  if (section == nullptr) return {};
  return {section->number("friction"), section->number("radius"), section->number("idle_force")};
}

Bearings bearings_of(const Setting* section, const CaseCrusher& crusher) {
  Bearings bearings;
  bearings.tilt_sine = crusher.eccentricity / crusher.pivot_height;
  if (section == nullptr) return bearings;
  bearings.depth = section->number("bushing_depth");
  bearings.outer = bearing_of(*section, "outer");
  bearings.inner = bearing_of(*section, "inner");
  bearings.spider = bearing_of(*section, "spider");
  return bearings;
}

ProtectionParameters protection_of(const Setting& section) {
  ProtectionParameters p;
  p.overload_time = number_or(section, "overload_time", 0);
  p.overload_ratio = section.number("overload_ratio");
  p.instantaneous_ratio = number_or(section, "instantaneous_ratio", 0);
  p.under_speed = number_or(section, "under_speed", 0);
  p.under_speed_delay = section.number("under_speed_delay");
  p.rated_torque = number_or(section, "rated_torque", 0);
  p.brake_torque = section.number("brake_torque");
  p.restart_delay = number_or(section, "restart_delay", 0);
  p.restarts = static_cast<int>(section.number("restarts"));
  p.restart_reversed = section.text("restart_sense") == "reversed";
  return p;
}

}  // namespace

DrivetrainParameters build_drivetrain(const Setting& section, const CaseTables& tables, const CaseCrusher& crusher) {
  DrivetrainParameters drive;
  drive.motor = motor_of(*section.find("motor"), tables);
  drive.gear_ratio = section.number("gear_ratio");
  drive.gear_efficiency = section.number("gear_efficiency");
  drive.motor_inertia = section.number("inertia.motor");
  drive.eccentric_inertia = section.number("inertia.eccentric");
  drive.losses = {section.number("losses.no_load"), section.number("losses.load_factor"),
                  section.number("losses.viscous")};
  drive.start = section.text("start") == "rest" ? DrivetrainStart::rest : DrivetrainStart::running;
  drive.mantle_inertia = number_or(section, "mantle_inertia", 0);
  drive.bearings = bearings_of(section.find("bearings"), crusher);
  if (const Setting* spring = section.find("coupling_spring"))
    drive.spring = {spring->number("stiffness"), spring->number("damping")};
  drive.voltage = tables.voltage;
  if (const Setting* voltage = section.find("motor.voltage")) drive.voltage = {{0}, {voltage->numbers.at(0)}};
  if (const Setting* protection = section.find("protection")) drive.protection = protection_of(*protection);
  return drive;
}

}  // namespace gyro
