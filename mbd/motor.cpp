// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motor.hpp"

#include "core/base/errors.hpp"

#include <cmath>
#include <utility>

namespace gyro {
namespace {

/// Calls f with a motor of each law, without parameters.
template <class F, std::size_t... k>
void for_each_law(F&& f, std::index_sequence<k...>) {
  (f(std::variant_alternative_t<k, Motor>{}), ...);
}
template <class F>
void for_each_law(F&& f) {
  for_each_law(f, std::make_index_sequence<std::variant_size_v<Motor>>());
}

}  // namespace

std::string model_of(const Motor& motor) {
  return std::visit([](const auto& law) { return std::string(law.model); }, motor);
}

std::vector<std::string> motor_models() {
  std::vector<std::string> names;
  for_each_law([&](const auto& law) { names.emplace_back(law.model); });
  return names;
}

Motor motor_of_model(const std::string& model) {
  Motor found;
  std::string known;
  bool is_known = false;
  for_each_law([&](const auto& law) {
    known += (known.empty() ? "" : ", ") + std::string(law.model);
    if (model != law.model) return;
    found = law;
    is_known = true;
  });
  if (!is_known) throw BadInput("unknown motor model `" + model + "`; use one of " + known);
  return found;
}

void complete_motor(Motor& motor) {
  std::visit(
      [](auto& law) {
        if constexpr (requires { law.complete(); }) law.complete();
      },
      motor);
}

void check_motor(const Motor& motor) {
  std::visit([](const auto& law) { law.check(); }, motor);
}

double motor_torque(const Motor& motor, double speed, double voltage) {
  return std::visit([&](const auto& law) { return law.torque(speed, voltage); }, motor);
}

double motor_current(const Motor& motor, double speed, double voltage, double rated_torque) {
  return std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.current(speed); })
          return voltage * law.current(speed);
        else
          return std::abs(law.torque(speed, voltage)) / rated_torque;
      },
      motor);
}

double no_load_speed(const Motor& motor) {
  return std::visit([](const auto& law) { return law.no_load_speed(); }, motor);
}

double rated_speed(const Motor& motor) {
  return std::visit([](const auto& law) { return law.rated_speed(); }, motor);
}

double rated_torque_of(const Motor& motor) {
  return std::visit(
      [](const auto& law) -> double {
        if constexpr (requires { law.rated_torque(); })
          return law.rated_torque();
        else
          return 0;
      },
      motor);
}

}  // namespace gyro
