// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "mbd/fmi/drive_variable.hpp"

#include <charconv>
#include <limits>
#include <sstream>

namespace gyro {
namespace {

constexpr const char* head = "gyrosim drivetrain 1";
constexpr const char* motor_names[] = {"induction", "double_cage", "droop", "curve", "constant_speed"};
constexpr double max_points = 1e6;  ///< of a curve: a wrong number shall not ask for all memory

/// Shortest text that reads back to the same double.
std::string all_digits(double value) {
  char text[40];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

/// Lines `name value`, in a given order.
class Lines {
 public:
  explicit Lines(const std::string& text) : stream_(text) {
    std::string line;
    if (!std::getline(stream_, line) || line != head)
      throw BadInput("the drivetrain's parameters do not begin with `" + std::string(head) + "`");
  }

  std::string text(const std::string& name) {
    std::string line;
    if (!std::getline(stream_, line) || !line.starts_with(name + " "))
      throw BadInput("the drivetrain's parameters have `" + line + "`; a line `" + name + " ...` is accepted there");
    return line.substr(name.size() + 1);
  }

  double number(const std::string& name) {
    const std::string word = text(name);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      throw BadInput("the drivetrain's parameters have `" + name + " " + word + "`; a number is accepted there");
    return value;
  }

  std::size_t count(const std::string& name) {
    const double value = number(name);
    if (!(value >= 0 && value <= max_points)) throw BadInput("the drivetrain's parameters have too many " + name);
    return static_cast<std::size_t>(value);
  }

 private:
  std::istringstream stream_;
};

template <std::size_t... k>
Motor motor_number(std::size_t number, std::index_sequence<k...>) {
  Motor motor;
  ((number == k ? void(motor.emplace<k>()) : void()), ...);
  return motor;
}

Motor motor_named(const std::string& name) {
  constexpr std::size_t count = std::variant_size_v<Motor>;
  static_assert(count == std::size(motor_names));
  for (std::size_t k = 0; k < count; ++k)
    if (name == motor_names[k]) return motor_number(k, std::make_index_sequence<count>());
  throw BadInput("the drivetrain's parameters have a motor `" + name + "`, which this program does not know");
}

}  // namespace

std::string drive_text(const DrivetrainParameters& parameters) {
  DrivetrainParameters p = parameters;
  const auto* curve = std::get_if<CurveMotor>(&p.motor);
  std::string text = std::string(head) + "\nmotor " + motor_names[p.motor.index()] + "\ncurve_points " +
                     std::to_string(curve ? curve->speeds.size() : 0) + "\nvoltage_points " +
                     std::to_string(p.voltage.times.size()) + "\n";
  for (const DriveVariable& variable : parameter_variables(p))
    text += variable.name + " " + all_digits(variable.get()) + "\n";
  return text;
}

DrivetrainParameters drive_from_text(const std::string& text) {
  Lines lines(text);
  DrivetrainParameters p;
  p.motor = motor_named(lines.text("motor"));
  const std::size_t curve_points = lines.count("curve_points"), voltage_points = lines.count("voltage_points");
  if (auto* curve = std::get_if<CurveMotor>(&p.motor)) {
    curve->speeds.resize(curve_points);
    curve->torques.resize(curve_points);
  }
  p.voltage.times.resize(voltage_points);
  p.voltage.ratios.resize(voltage_points);
  for (const DriveVariable& variable : parameter_variables(p)) variable.set(lines.number(variable.name));
  complete_motor(p.motor);
  return p;
}

}  // namespace gyro
