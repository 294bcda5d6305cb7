// SPDX-License-Identifier: GPL-3.0-or-later
// Rolling resistance by an elastic-plastic spring with a dashpot: a ball rocks about the place where its rolling ends.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/fixtures/on_floor.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/laws/contact/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double g = OnFloor::g, radius = OnFloor::radius;
constexpr double damping_share = 0.3;  ///< eta: damping of the rolling dashpot / critical damping
const std::string source = "rigid-body mechanics of a ball, rolling torque of type C of Ai et al. (2011)";

PairProperties spring_dashpot(double mu_r) {
  return {0.5, 0.5, mu_r, {NormalModel::hertz, RollingModel::spring_dashpot}};
}

/// A ball on a floor as an oscillator with two degrees of freedom, sliding and rolling.
struct Rocker {
  double mass = sphere_mass(radius, rock_density), inertia = 0.4 * mass * radius * radius;
  double arm;                  ///< a, lever of friction: radius - overlap [m]
  double tangential, sliding;  ///< Mindlin's spring St [N/m] and its dashpot [N s/m]
  double spring, damping;      ///< of rolling: kr [N m/rad], cr [N m s/rad]

  Rocker(double mu_r, double slope) {
    const double overlap = OnFloor::overlap(slope);
    const Material& m = soft_rock();
    const double normal = 2 * youngs_against_rigid(m) * std::sqrt(radius * overlap);
    arm = radius - overlap;
    tangential = 8 * m.shear_modulus / (2 - m.poisson_ratio) * std::sqrt(radius * overlap);
    sliding = 2 * std::sqrt(5.0 / 6) * damping_for_restitution(0.5) * std::sqrt(tangential * mass);
    spring = 2.25 * normal * std::pow(mu_r * radius, 2);
    damping = 2 * damping_share * std::sqrt(3.5 * inertia * spring);
  }

  double inertia_about_contact() const { return inertia + mass * arm * arm; }

  /// Root with a positive imaginary part of the slow mode, in which the ball rolls [1/s]:
  /// (m s^2 + Z)(I s^2 + cr s + kr + a^2 Z) = a^2 Z^2 with Z = St + ct s, by Newton's method.
  std::complex<double> root() const {
    using Complex = std::complex<double>;
    const double frequency = std::sqrt(spring / inertia_about_contact());
    Complex s = frequency * Complex(-damping_share, std::sqrt(1 - damping_share * damping_share));
    for (int k = 0; k < 20; ++k) {
      const Complex z = tangential + sliding * s, a = mass * s * s, b = inertia * s * s + damping * s + spring;
      const Complex a1 = 2 * mass * s, b1 = 2 * inertia * s + damping;
      const Complex value = a * b + z * (b + arm * arm * a);
      s -= value / (a1 * b + a * b1 + sliding * (b + arm * arm * a) + z * (b1 + arm * arm * a1));
    }
    return s;
  }
};

struct Rocking {
  double half_period, decay;  ///< half a period of rocking [s]; ratio of the amplitudes after and before it [-]
  double turned;              ///< position where the ball first reversed its motion [m]
};

/// Steps until the velocity has changed its sign three times. Times and positions of these events are interpolated
/// between steps.
Rocking turning_points(OnFloor& s, double dt) {
  double at[3] = {}, place[3] = {}, before = s.speed();
  for (int found = 0; found < 3 && s.time() < 1;) {
    s.step();
    const double now = s.speed();
    if (before * now < 0) {
      const double after = now / (now - before) * dt;
      at[found] = s.time() - after;
      place[found++] = s.x() - 0.5 * after * now;
    }
    before = now;
  }
  return {0.5 * (at[2] - at[0]), (place[2] - place[1]) / (place[0] - place[1]), place[0]};
}

/// A ball starts to roll so slowly that the rolling spring stays below its limit.
Rocking rocks(double mu_r, double dt, Precision precision) {
  const Rocker rocker(mu_r, 0);
  const double spin = 0.3 * mu_r * radius * rocker.mass * g / rocker.spring * std::abs(rocker.root());
  OnFloor s({spring_dashpot(mu_r), 0, spin * rocker.arm, spin, dt}, precision);
  return turning_points(s, dt);
}

/// The dashpot uses the velocity of half a step earlier, so that the period has a relative error of about eta w dt/2.
void freely(Recorder& out) {
  for (const double mu_r : {0.02, 0.1}) {
    const std::complex<double> s = Rocker(mu_r, 0).root();
    const double half_period = pi / s.imag(), error = damping_share * std::abs(s) * OnFloor::dt;
    const Rocking got = rocks(mu_r, OnFloor::dt, out.precision());
    const std::string prefix = mu_r < 0.05 ? "rolling-2-hundredths" : "rolling-1-tenth";
    out.relative(prefix + "-half-period", got.half_period, half_period, {error, error}, source);
    out.relative(prefix + "-decay", got.decay, std::exp(s.real() * half_period), {error, error}, source);
  }
}

void converges(Recorder& out) {
  const double mu_r = 0.1;
  const std::complex<double> s = Rocker(mu_r, 0).root();
  const double half_period = pi / s.imag(), decay = std::exp(s.real() * half_period);
  const Rocking coarse = rocks(mu_r, 2e-5, out.precision()), half = rocks(mu_r, 1e-5, out.precision());
  const std::string order = "first order: the dashpot uses the velocity of half a step earlier";
  out.within("error-of-half-period-by-half-a-step",
             (coarse.half_period - half_period) / (half.half_period - half_period), 1.8, 2.2, order);
  out.within("error-of-decay-by-half-a-step", (coarse.decay - decay) / (half.decay - decay), 1.8, 2.2, order);
}

/// Speed at which a resting ball may creep in mixed precision [m/s]. The rolling spring is stored in single precision,
/// and in each step its torque is rounded by up to half a unit in the last place. @param shift  displacement that the
/// torque causes [m]
double creep_in_mixed(double shift) {
  return 0x1p-24 * shift / OnFloor::dt;
}

/// Displacement at rest on a slope [m]: the rolling spring carries the torque of the weight, the tangential spring its
/// downhill force.
double shift_on(const Rocker& rocker, double slope) {
  const double downhill = rocker.mass * g * std::sin(slope);
  return downhill * (rocker.arm * rocker.arm / rocker.spring + 1 / rocker.tangential);
}

void on_a_slope(Recorder& out) {
  const double slope = 0.1, mu_r = 2 * std::tan(slope);
  const double shift = shift_on({mu_r, slope}, slope), creep = creep_in_mixed(shift);
  OnFloor s({spring_dashpot(mu_r), slope}, out.precision());
  s.run_to(0.5);
  out.relative("shift", s.x(), shift, {1e-9, 0.5 * creep / shift}, source);
  out.absolute("rest", s.run_to(1), 0, {1e-9 * radius, creep}, "at rest for 0.5 s, R w and v at each 50th step");
}

/// Acceleration of a ball that rolls down a slope against the resisting torque mu_r R Fn [m/s2].
double acceleration(const Rocker& rocker, double mu_r, double slope) {
  const double torque = rocker.mass * g * (rocker.arm * std::sin(slope) - mu_r * radius * std::cos(slope));
  return rocker.arm * torque / rocker.inertia_about_contact();
}

/// A coefficient above the tangent of the slope holds the ball; with a coefficient below it the ball rolls.
void angle_of_rolling(Recorder& out) {
  const double slope = 0.1, limit = std::tan(slope), more = 1.02 * limit;
  const double creep = creep_in_mixed(shift_on({more, slope}, slope));
  OnFloor held({spring_dashpot(more), slope}, out.precision());
  held.run_to(0.5);
  const double position = held.x();
  out.absolute("rest", held.run_to(1), 0, {1e-9 * radius, creep}, "at rest for 0.5 s, R w and v");
  out.absolute("creep", held.x() - position, 0, {1e-9 * radius, 0.5 * creep}, "at rest for 0.5 s");
  for (const double share : {0.98, 0.5}) {
    const double mu_r = share * limit;
    OnFloor rolls({spring_dashpot(mu_r), slope}, out.precision());
    rolls.run_to(0.1);
    const double before = rolls.speed();
    rolls.run_to(0.5);
    out.relative(share > 0.9 ? "acceleration-2-percent-below" : "acceleration-at-half", (rolls.speed() - before) / 0.4,
                 acceleration({mu_r, slope}, mu_r, slope), {1e-5, 1e-5}, source);
  }
}

/// A ball rolls to a stop while its rolling spring is at the limit. The spring then rolls the ball back by the angle
/// that it has stored.
void stop(Recorder& out) {
  const double mu_r = 0.05, v = 0.2;
  const Rocker rocker(mu_r, 0);
  OnFloor s({spring_dashpot(mu_r), 0, v, v / radius}, out.precision());
  s.run_to(0.1);
  const double speed = s.speed(), start = s.x();
  double last = 0;
  while (s.speed() > 0 && s.time() < 1) {
    last = s.x();
    s.step();
  }
  out.relative("distance", last - start, -0.5 * speed * speed / acceleration(rocker, mu_r, 0), {1e-5, 1e-5}, source);
  s.run_to(2);
  const double weight = rocker.mass * g, friction = 5.0 / 7 * mu_r * weight;
  const double back = rocker.arm * mu_r * radius * weight / rocker.spring + friction / rocker.tangential;
  out.relative("recoil", last - s.x(), back, {1e-5, 1e-5}, source);
  out.absolute("rest", s.run_to(2.5), 0, {1e-9 * radius, 1e-9}, "at rest for 0.5 s, R w and v");
  out.absolute("energy-residual", s.energy().residual() / (0.7 * rocker.mass * v * v), 0, {1e-5, 1e-5}, "first law");
}

/// Two equal balls with opposite spins hit each other and roll on each other without slip. The normal spring is linear,
/// so that the stiffness of the rolling spring is constant. The spins are compared at the largest overlap, a quarter
/// oscillation of the normal spring after the first touch; the spins are then at a known phase of their own damped
/// oscillation.
void pair(Recorder& out) {
  const double mu_r = 0.3, fall = 1, spin = 20, steps = 2000;
  const Material stone = elastic(48e9, 0.20, 2800);
  const double mass = sphere_mass(radius, stone.density), inertia = 0.4 * mass * radius * radius;
  const double k1 = 4.0 / 3 * std::sqrt(0.1) * youngs_of_pair(stone) * 0.5 * radius;
  const double quarter = 0.5 * pi * std::sqrt(0.5 * mass / k1);
  const PairProperties pair{0.4, 1, mu_r, {NormalModel::hysteretic, RollingModel::spring_dashpot}};
  Stage stage(scene_of(stone, rigid(), pair, quarter / steps), out.precision());
  stage.insert(head_on(stone, radius, fall, spin, -spin));
  stage.advance(static_cast<int>(steps));

  const double reduced = 0.5 * inertia, kr = 2.25 * k1 * std::pow(0.5 * mu_r * radius, 2);
  const double frequency = std::sqrt(kr / reduced), zeta = damping_share * std::sqrt(3.5);
  const double damped = frequency * std::sqrt(1 - zeta * zeta), t = quarter;
  const double left =
      std::exp(-zeta * frequency * t) * (std::cos(damped * t) - zeta * frequency / damped * std::sin(damped * t));
  const ParticleSnapshot s = stage.dem().particles();
  const std::string oscillator = "damped oscillator of I* and kr, from the first touch to the largest overlap";
  out.relative("first-spin-lost", spin - s.angular_velocity[0].z, spin * (1 - left), {1e-4, 1e-4}, oscillator);
  out.relative("second-spin-lost", spin + s.angular_velocity[1].z, spin * (1 - left), {1e-4, 1e-4}, oscillator);
}

/// Ratio of two recoils: with one limit for the sum of spring and dashpot, as in LAMMPS, and with a limit for the
/// spring alone, as here. In LAMMPS the ball leaves the limit with the velocity 2 eta and a spring angle of 1 - 4 eta^2
/// (units: angle at the limit, 1/omega), and then moves as a free oscillator until it reverses.
double recoil_of_common_limit() {
  const double eta = damping_share, damped = std::sqrt(1 - eta * eta), x = 1 - 4 * eta * eta, v = 2 * eta;
  const double b = (v + eta * x) / damped, phase = std::atan(v / (eta * b + damped * x));
  return std::exp(-eta * phase / damped) * (x * std::cos(phase) + b * std::sin(phase));
}

/// Comparison with the same balls in LAMMPS at the same steps: cases/verification/rocking/README.md. The remaining
/// differences are the error of the step, and the lever of friction, which is R in LAMMPS and R - overlap here.
void lammps(Recorder& out) {
  const std::string code = "LAMMPS 22Jul2025, rolling sds";
  OnFloor stops({spring_dashpot(0.05), 0, 0.2, 0.2 / radius}, out.precision());
  const Rocking rocking = turning_points(stops, OnFloor::dt);
  stops.run_to(1);
  const double step = 0.5 * damping_share * std::abs(Rocker(0.05, 0).root()) * OnFloor::dt;
  out.relative("half-period", rocking.half_period, 0.01051571, {step, step}, code);
  out.relative("decay", rocking.decay, 0.3740547, {step, step}, code);
  out.relative("recoil", rocking.turned - stops.x(), 2.960955e-6 / recoil_of_common_limit(), {step, step},
               code + ", which limits the sum of spring and dashpot");
  const double creep = creep_in_mixed(4.971903e-7), lever = 2 * OnFloor::overlap(0.1) / radius;
  OnFloor rests({spring_dashpot(0.2), 0.1}, out.precision());
  rests.run_to(0.5);
  out.relative("shift", rests.x(), 4.971903e-7, {lever, lever + 0.5 * creep / 4.971903e-7}, code);
  OnFloor rolls({spring_dashpot(0.05), 0.1}, out.precision());
  rolls.run_to(0.1);
  const double before = rolls.speed();
  rolls.run_to(0.5);
  out.relative("acceleration", (rolls.speed() - before) / 0.4, 0.3509402, {lever, lever}, code);
}

}  // namespace

std::vector<Verification> rocking_cases() {
  return {
      {"rocking/freely", freely},
      {"rocking/convergence", converges},
      {"rocking/on-a-slope", on_a_slope},
      {"rocking/angle-of-rolling", angle_of_rolling},
      {"rocking/stop", stop},
      {"rocking/pair", pair},
      {"rocking/lammps", lammps},
  };
}

}  // namespace gyro::verify
