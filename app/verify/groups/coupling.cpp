// SPDX-License-Identifier: GPL-3.0-or-later
// Exchange of motion and torque between drive and rock: order of convergence in the window, stability, and the energy
// that the exchange adds or removes.
#include "app/verify/fixtures/drives.hpp"
#include "app/verify/verification.hpp"
#include "core/math/random.hpp"
#include "mbd/cvode_session.hpp"

#include <Eigen/Dense>
#include <span>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double longest = 8e-3;  // longest window [s]
constexpr int samples = 100;      // of the speed, one after each longest window

/// Torque of the rock: sixty Gaussian pulses over the angle, with random positions, heights and widths. A share of the
/// torque may be proportional to the speed.
class Pulses {
 public:
  explicit Pulses(double rate_share) : rate_share_(rate_share) {
    for (std::uint32_t k = 0; k < 60; ++k) {
      const auto draw = [k](std::uint32_t n) { return uniform(5, Stream::shape, k, n); };
      pulses_.push_back({13 * draw(0), 6e3 + 20e3 * draw(1), 0.15 + 0.15 * draw(2)});
    }
  }
  double at(double angle, double speed) const {
    double sum = 0;
    for (const Pulse& p : pulses_) sum += p.height * std::exp(-std::pow((angle - p.angle) / p.width, 2));
    return sum * rate(speed);
  }
  /// Exact mean along a path of constant speed.
  double mean(double begin, double end, double speed) const {
    double sum = 0;
    for (const Pulse& p : pulses_)
      sum += p.height * p.width * (std::erf((end - p.angle) / p.width) - std::erf((begin - p.angle) / p.width));
    return sum * 0.5 * std::sqrt(std::numbers::pi) / (end - begin) * rate(speed);
  }

 private:
  struct Pulse {
    double angle, height, width;
  };
  double rate(double speed) const { return 1 - rate_share_ + rate_share_ * speed / (160 * rpm); }
  double rate_share_;
  std::vector<Pulse> pulses_;
};

DrivetrainParameters loaded_machine() {
  return {.motor = paper_droop(),
          .gear_ratio = 3.75,
          .eccentric_inertia = 3000,
          .losses = {.no_load_power = 50e3, .load_factor = 0.05}};
}

/// Speeds at the samples from an integration of load and shaft as one system [rad/s].
std::vector<double> monolithic(const Pulses& load) {
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
    session.integrate(longest, y);
    speeds.push_back(y[1]);
  }
  return speeds;
}

/// Largest relative error of the speed at the samples. @param torque  (begin, end, speed)
template <class Torque>
double speed_error(int split, const std::vector<double>& exact, const Torque& torque) {
  const double length = longest / split;
  Drivetrain drive(loaded_machine());
  double largest = 0;
  for (int k = 0; k < samples * split; ++k) {
    exchange(drive, window_number(k, length),
             [&](double begin, double end) { return torque(begin, end, (end - begin) / length); });
    if ((k + 1) % split == 0)
      largest = std::max(largest, std::abs(drive.state().speed / exact[static_cast<std::size_t>(k / split)] - 1));
  }
  return largest;
}

std::string seconds(int split) {
  return std::to_string(std::lround(1e4 * longest / split)) + "e-4-s";
}

/// The mean torque of each window is exchanged: the error is of second order in the length of the window.
void averaged(Recorder& out) {
  const Pulses load(1);
  const std::vector<double> exact = monolithic(load);
  double before = 0;
  for (const int split : {1, 2, 4, 8, 16}) {
    const double error = speed_error(split, exact, [&](double a, double b, double w) { return load.mean(a, b, w); });
    if (before > 0) out.within("order-at-" + seconds(split), std::log2(before / error), 1.8, 2.2, "second order");
    before = error;
  }
  out.absolute("speed-error-at-5e-4-s", before, 0, {1e-6, 1e-6}, "monolithic integration by CVODE");
}

/// The torque at the beginning of each window is held: the error is of first order, and hundreds of times larger.
void sampled(Recorder& out) {
  const Pulses load(0);
  const std::vector<double> exact = monolithic(load);
  const auto sample = [&](double a, double, double w) { return load.at(a, w); };
  const auto mean = [&](double a, double b, double w) { return load.mean(a, b, w); };
  const double coarse = speed_error(8, exact, sample), fine = speed_error(16, exact, sample);
  out.within("order-at-5e-4-s", std::log2(coarse / fine), 0.8, 1.2, "first order");
  out.within("mean-is-better-by", fine / speed_error(16, exact, mean), 580, 1e9, "at the same cost");
}

double growth_rate(const Eigen::MatrixXd& map, double length) {
  return std::log(map.eigenvalues().cwiseAbs().maxCoeff()) / length;
}

/// A spring whose torque is sampled at the beginning of each window and held. The code must follow the exact map of
/// (angle, speed), whose oscillations grow.
void exact_map_of_two(Recorder& out) {
  constexpr double inertia = 300, stiffness = 5e6, length = 5e-3;
  Eigen::Matrix2d map;
  map << 1 - stiffness * length * length / (2 * inertia), length, -stiffness * length / inertia, 1;
  Drivetrain drive(shaft_on_spring(inertia));
  Eigen::Vector2d exact(0, 1);
  double worst = 0, begin = 0;
  for (int k = 0; k < 40; ++k) {
    exact = map * exact;
    exchange(drive, window_number(k, length), [&](double, double) { return stiffness * drive.state().angle; });
    worst = std::max({worst, std::abs(drive.state().angle - exact[0]) * 150, std::abs(drive.state().speed - exact[1])});
    if (k == 19) begin = std::hypot(drive.state().speed, drive.state().angle * std::sqrt(stiffness / inertia));
  }
  const double end = std::hypot(drive.state().speed, drive.state().angle * std::sqrt(stiffness / inertia));
  out.absolute("code-against-map", worst / exact.norm(), 0, {1e-8, 1e-8}, "exact 2 x 2 map");
  out.relative("determinant", map.determinant(), 1 + length * length * stiffness / (2 * inertia), {1e-12, 1e-12},
               "1 + H^2 k/2J");
  out.absolute("growth-of-the-map", growth_rate(map, length), 19, {0.2, 0.2}, "1/s");
  out.absolute("growth-of-the-code", std::log(end / begin) / (20 * length), 19, {2, 2}, "1/s");
}

/// A spring whose mean torque along the predicted path is held. The state of the exact map consists of angle, speed,
/// torque of the last window, and angle of the wall.
void exact_map_of_four(Recorder& out) {
  const std::array<std::array<double, 2>, 2> machines{{{300, 5e-3}, {5700, 0.5e-3}}};
  for (const auto& [inertia, length] : machines) {
    const double stiffness = 5e6, half = length * length / (2 * inertia);
    const Eigen::RowVector4d predicted(1, length, -half, 0);
    const Eigen::RowVector4d torque = stiffness / 2 * (predicted + Eigen::RowVector4d(0, 0, 0, 1));
    Eigen::Matrix4d map;
    map.row(0) = Eigen::RowVector4d(1, length, 0, 0) - half * torque;
    map.row(1) = Eigen::RowVector4d(0, 1, 0, 0) - length / inertia * torque;
    map.row(2) = torque;
    map.row(3) = predicted;
    Drivetrain drive(shaft_on_spring(inertia));
    Eigen::Vector4d exact(0, 1, 0, 0);
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      exact = map * exact;
      exchange(drive, window_number(k, length), [&](double a, double b) { return stiffness * (a + b) / 2; });
      worst =
          std::max({worst, std::abs(drive.state().angle - exact[0]) * 150, std::abs(drive.state().speed - exact[1])});
    }
    const std::string name = std::to_string(std::lround(inertia)) + "-kg-m2";
    out.absolute(name + "-code-against-map", worst, 0, {1e-6, 1e-6}, "exact 4 x 4 map");
    out.within(name + "-growth", growth_rate(map, length), -1e3, 0, "the mean along the path damps");
  }
}

/// Energy that the coupling adds or loses, as a share of the exchanged work.
double residual_share(double inertia, double length, int windows) {
  constexpr double stiffness = 5e6;
  Drivetrain drive(shaft_on_spring(inertia));
  double residual = 0, work = 0;
  for (int k = 0; k < windows; ++k) {
    exchange(drive, window_number(k, length), [&](double a, double b) { return stiffness * (a + b) / 2; });
    residual += std::abs(drive.means().power_residual);
    work += std::abs(drive.means().crushing_power);
  }
  return residual / work;
}

/// The power residual is large for a light machine in long windows and small for a crusher in windows of 0.5 ms.
void monitor(Recorder& out) {
  const double light = residual_share(300, 5e-3, 100), halved = residual_share(300, 2.5e-3, 200);
  const std::string source = "Rodriguez et al., MBSD 55 (2022) 103";
  out.within("light-machine", light, 0.01, 10, source);
  out.within("halved-window", halved / light, 0, 0.5, source);
  out.absolute("crusher", residual_share(5700, 0.5e-3, 1000), 0, {1e-4, 1e-4}, source);
}

}  // namespace

std::vector<Verification> coupling_cases() {
  return {
      {"coupling/averaged-torque", averaged, Precisions::double_only},
      {"coupling/sampled-torque", sampled, Precisions::double_only},
      {"coupling/sampled-spring", exact_map_of_two, Precisions::double_only},
      {"coupling/averaged-spring", exact_map_of_four, Precisions::double_only},
      {"coupling/power-residual", monitor, Precisions::double_only},
  };
}

}  // namespace gyro::verify
