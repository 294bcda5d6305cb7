// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "mbd/fmi/drive_variable.hpp"

#include <charconv>
#include <sstream>
#include <type_traits>

namespace gyro {
namespace {

constexpr const char* head = "gyrosim drivetrain 1";
constexpr double max_points = 1e6;  // of a curve; limits the memory that a wrong number can allocate

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
      throw BadInput("the drivetrain's parameters have `" + line + "`; a line `" + name + " ...` is expected");
    return line.substr(name.size() + 1);
  }

  double number(const std::string& name) {
    const std::string word = text(name);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      throw BadInput("the drivetrain's parameters have `" + name + " " + word + "`; a number is expected");
    return value;
  }

  std::size_t count(const std::string& name) {
    const double value = number(name);
    if (!(value >= 0 && value <= max_points))
      throw BadInput("the drivetrain's parameters have too many " + name + "; a count up to 1000000 is expected");
    return static_cast<std::size_t>(value);
  }

 private:
  std::istringstream stream_;
};

/// Calls f with each list among the parameters of a motor.
template <class F>
void for_each_list(Motor& motor, F&& f) {
  for_each_parameter(
      [&]<class T>(const char*, const char*, T& field, const char*) {
        if constexpr (std::is_same_v<T, std::vector<double>>) f(field);
      },
      motor);
}

}  // namespace

std::string drive_text(const DrivetrainParameters& parameters) {
  DrivetrainParameters p = parameters;
  std::size_t curve_points = 0;
  for_each_list(p.motor, [&](const std::vector<double>& list) { curve_points = list.size(); });
  std::string text = std::string(head) + "\nmotor " + model_of(p.motor) + "\ncurve_points " +
                     std::to_string(curve_points) + "\nvoltage_points " + std::to_string(p.voltage.times.size()) + "\n";
  for (const DriveVariable& variable : parameter_variables(p))
    text += variable.name + " " + all_digits(variable.get()) + "\n";
  return text;
}

DrivetrainParameters drive_from_text(const std::string& text) {
  Lines lines(text);
  DrivetrainParameters p;
  p.motor = motor_of_model(lines.text("motor"));
  const std::size_t curve_points = lines.count("curve_points"), voltage_points = lines.count("voltage_points");
  for_each_list(p.motor, [&](std::vector<double>& list) { list.resize(curve_points); });
  p.voltage.times.resize(voltage_points);
  p.voltage.ratios.resize(voltage_points);
  for (const DriveVariable& variable : parameter_variables(p)) variable.set(lines.number(variable.name));
  complete_motor(p.motor);
  return p;
}

}  // namespace gyro
