// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"
#include "tests/mbd/machines.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <vector>

namespace gyro {
namespace {

/// A smooth load, sum of A (1 + sin(n angle)); a share of it may grow with the speed.
struct SmoothLoad {
  double rate_share = 0;  ///< 0: of the angle alone; 1: proportional to the speed

  double rate_factor(double speed) const { return 1 - rate_share + rate_share * speed / (160 * rpm); }
  double at(double angle, double speed) const {
    return (10e3 * (1 + std::sin(5 * angle)) + 4e3 * (1 + std::sin(9 * angle))) * rate_factor(speed);
  }
  /// Exact mean along a path of constant speed: that of sin(n x) is sin(n middle) sin(n half) / (n half).
  double mean(double begin, double end, double speed) const {
    const double middle = (begin + end) / 2, half = (end - begin) / 2;
    const auto mean_sine = [&](double n) { return std::sin(n * middle) * std::sin(n * half) / (n * half); };
    return (10e3 * (1 + mean_sine(5)) + 4e3 * (1 + mean_sine(9))) * rate_factor(speed);
  }
};

DrivetrainParameters loaded_machine() {
  DrivetrainParameters machine = crusher_62_75(paper_droop());
  machine.losses = {.no_load_power = 50e3, .load_factor = 0.05};
  return machine;
}

constexpr double longest_window = 8e-3;  // [s]
constexpr int samples = 100;             // of the speed, one each longest window

/// Speeds at the samples with load and shaft integrated as one system [rad/s].
std::vector<double> monolithic_speeds(const SmoothLoad& load) {
  const DrivetrainParameters machine = loaded_machine();
  const Losses losses = machine.eccentric_losses();
  const std::array<double, 2> tolerance{1e-13, 1e-13};
  CvodeSession session({.size = 2, .relative_tolerance = 1e-12, .absolute_tolerance = tolerance},
                       [&](std::span<const double> y, std::span<double> rate) {
                         const double rock = load.at(y[0], y[1]);
                         const double drive = 3.75 * motor_torque(machine.motor, 3.75 * y[1]);
                         rate[0] = y[1];
                         rate[1] = (drive - rock - losses.torque(y[1], +1, rock)) / machine.effective_inertia();
                       },
                       {});
  std::array<double, 2> y{0, idle_speed(machine)};
  std::vector<double> speeds;
  for (int k = 0; k < samples; ++k) {
    session.integrate(longest_window, y);
    speeds.push_back(y[1]);
  }
  return speeds;
}

/// Largest error of the speed at the samples, relative to the speed. A single moment would not do: errors
/// of an oscillating load cancel at some.
template <class Torque>
double coupled_error(int windows_per_sample, const std::vector<double>& exact, const Torque& torque) {
  const double length = longest_window / windows_per_sample;
  Drivetrain drivetrain(loaded_machine());
  double largest = 0;
  for (int k = 0; k < samples * windows_per_sample; ++k) {
    exchange(drivetrain, window_number(k, length),
             [&](double begin, double end) { return torque(begin, end, (end - begin) / length); });
    if ((k + 1) % windows_per_sample != 0) continue;
    const double reference = exact[k / windows_per_sample];
    largest = std::max(largest, std::abs(drivetrain.state().speed / reference - 1));
  }
  return largest;
}

/// Undriven shaft on a torsion spring: 1 rad/s at angle 0; the motor is too weak to matter.
DrivetrainParameters shaft_on_spring(double inertia) {
  return {.motor = DroopMotor{.synchronous_speed = 1, .stall_torque = 1e-9}, .eccentric_inertia = inertia};
}

/// Share of the exchanged work that the coupling makes up or loses.
double residual_share(double inertia, double stiffness, double length, int windows) {
  Drivetrain drivetrain(shaft_on_spring(inertia));
  double residual = 0, work = 0;
  for (int k = 0; k < windows; ++k) {
    exchange(drivetrain, window_number(k, length), [&](double a, double b) { return stiffness * (a + b) / 2; });
    residual += std::abs(drivetrain.means().power_residual);
    work += std::abs(drivetrain.means().crushing_power);
  }
  return residual / work;
}

double growth_rate(const Eigen::MatrixXd& map, double length) {
  return std::log(map.eigenvalues().cwiseAbs().maxCoeff()) / length;
}

}  // namespace

TEST_CASE("Exchange of mean torque is of second order in the window", "[mbd][coupling]") {
  // A load of the angle alone does better in long windows: the predicted path is good to third order,
  // and the second-order part that is left is a total derivative, which cancels over a load cycle.
  const auto [rate_share, best_order] = GENERATE(table<double, double>({{1.0, 2.2}, {0.0, 3.0}}));
  const SmoothLoad load{rate_share};
  const auto mean = [&](double begin, double end, double speed) { return load.mean(begin, end, speed); };
  const std::vector<double> exact = monolithic_speeds(load);
  std::vector<double> milliseconds, errors, orders;
  for (const int split : {1, 2, 4, 8, 16}) {
    milliseconds.push_back(1e3 * longest_window / split);
    errors.push_back(coupled_error(split, exact, mean));
  }
  for (std::size_t k = 1; k < errors.size(); ++k) orders.push_back(std::log2(errors[k - 1] / errors[k]));
  CAPTURE(rate_share, milliseconds, errors, orders);
  for (const double order : orders) {
    CHECK(order > 1.8);
    CHECK(order < best_order);
  }
  CHECK(errors.back() < 1e-8);
}

TEST_CASE("Torque sampled at the window's begin is of first order only", "[mbd][coupling]") {
  const SmoothLoad load;
  const std::vector<double> exact = monolithic_speeds(load);
  const auto sampled = [&](double begin, double, double speed) { return load.at(begin, speed); };
  const auto mean = [&](double begin, double end, double speed) { return load.mean(begin, end, speed); };
  const double coarse = coupled_error(8, exact, sampled), fine = coupled_error(16, exact, sampled);
  CAPTURE(coarse, fine);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.2));
  CHECK(fine > 580 * coupled_error(16, exact, mean));
}

TEST_CASE("Sampled spring: the code follows the exact 2 x 2 map, which grows", "[mbd][coupling]") {
  const double inertia = 300, stiffness = 5e6, length = 5e-3;
  Eigen::Matrix2d map;
  map << 1 - stiffness * length * length / (2 * inertia), length, -stiffness * length / inertia, 1;
  CHECK(map.determinant() == Approx(1 + stiffness * length * length / (2 * inertia)));
  CHECK(growth_rate(map, length) == Approx(19).margin(0.2));  // 1/s

  Drivetrain drivetrain(shaft_on_spring(inertia));
  Eigen::Vector2d exact(0, 1);
  for (int k = 0; k < 40; ++k) {
    exact = map * exact;
    exchange(drivetrain, window_number(k, length),
             [&](double, double) { return stiffness * drivetrain.state().angle; });
    CAPTURE(k);
    CHECK(drivetrain.state().angle == Approx(exact[0]).margin(1e-8));
    CHECK(drivetrain.state().speed == Approx(exact[1]).margin(1e-6));
  }
}

TEST_CASE("Averaged spring: the code follows the exact 4 x 4 map", "[mbd][coupling]") {
  const auto [inertia, length] = GENERATE(table<double, double>({{300, 5e-3}, {5700, 0.5e-3}}));
  const double stiffness = 5e6, half = length * length / (2 * inertia);
  // State: angle, speed, torque of the last window, angle of the wall.
  const Eigen::RowVector4d predicted(1, length, -half, 0);
  const Eigen::RowVector4d torque = stiffness / 2 * (predicted + Eigen::RowVector4d(0, 0, 0, 1));
  Eigen::Matrix4d map;
  map.row(0) = Eigen::RowVector4d(1, length, 0, 0) - half * torque;
  map.row(1) = Eigen::RowVector4d(0, 1, 0, 0) - length / inertia * torque;
  map.row(2) = torque;
  map.row(3) = predicted;

  Drivetrain drivetrain(shaft_on_spring(inertia));
  Eigen::Vector4d exact(0, 1, 0, 0);
  for (int k = 0; k < 40; ++k) {
    exact = map * exact;
    exchange(drivetrain, window_number(k, length), [&](double a, double b) { return stiffness * (a + b) / 2; });
    CAPTURE(inertia, k, growth_rate(map, length));
    CHECK(drivetrain.state().angle == Approx(exact[0]).margin(1e-8));
    CHECK(drivetrain.state().speed == Approx(exact[1]).margin(1e-6));
  }
  CHECK(growth_rate(map, length) < 0);  // the mean along the path damps where a sample grows
}

TEST_CASE("Light machine and long window show in the power residual", "[mbd][coupling]") {
  const double light = residual_share(300, 5e6, 5e-3, 100);
  const double halved = residual_share(300, 5e6, 2.5e-3, 200);
  const double crusher = residual_share(5700, 5e6, 0.5e-3, 1000);
  CAPTURE(light, halved, crusher);
  CHECK(light > 0.01);
  CHECK(halved < light / 2);
  CHECK(crusher < 1e-4);
}

}  // namespace gyro
