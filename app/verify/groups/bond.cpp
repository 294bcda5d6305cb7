// SPDX-License-Identifier: GPL-3.0-or-later
// One bond between two spheres with prescribed motion: stiffness, strength, and forces after failure.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

const std::string source = "Potyondy & Cundall, IJRMMS 41 (2004) 1329";

// Of the paper's bonds: k_n A, k_s A [N/m], k_n I, k_s J [N m/rad]; displacements, rotations and loads at failure.
constexpr double normal = 1.311615e8, shear = 5.238606e7, bending = 819.759, torsion = 654.826;
constexpr double stretch = 21.5569e-6, slide = 35.9820e-6, bend = 4.311377e-3, twist = 7.196402e-3;  // [m], [rad]
constexpr double tension_force = 2827.433, shear_force = 1884.956, bending_moment = 3.534292, torque = 4.712389;

/// Motion of the two ends i and j when the loading is complete: j has moved by `shift`, and both have rotated by small
/// angles.
struct Loading {
  Vec3d shift{0, 0, 0}, rotation_i{0, 0, 0}, rotation_j{0, 0, 0};  ///< [m], [rad]
};

Loading operator+(const Loading& a, const Loading& b) {
  return {a.shift + b.shift, a.rotation_i + b.rotation_i, a.rotation_j + b.rotation_j};
}
Loading operator*(double s, const Loading& a) {
  return {s * a.shift, s * a.rotation_i, s * a.rotation_j};
}

// Each of these loadings alone brings the bond to failure. In bending, the ends rotate in opposite directions, so that
// there is no shear.
const Loading pull{{stretch, 0, 0}}, shove{{0, slide * 0.6, slide * 0.8}};
const Loading bow{{0, 0, 0}, {0, -0.3 * bend, -0.4 * bend}, {0, 0.3 * bend, 0.4 * bend}};
const Loading wring{{0, 0, 0}, {-twist / 2, 0, 0}, {twist / 2, 0, 0}};

/// Two immovable spheres and their bond. The loading is complete half a step before step number `steps`.
class Press {
 public:
  static constexpr int steps = 10000;

  Press(const Loading& loading, Precision precision, double strength = 1, double radius_j = grain / 2,
        BondFailure failure = BondFailure::constant)
      : stage_(scene(failure), precision) {
    const double rate = 1 / ((steps - 0.5) * dt), length = grain / 2 + radius_j;
    const Vec3d drift{10, -20, 5};
    NewRock pair;
    pair.id = 0;
    pair.particles = {
        {0, {0, 0, 0}, drift, rate * loading.rotation_i, grain / 2, immovable},
        {1, {length, 0, 0}, drift + rate * loading.shift, rate * loading.rotation_j, radius_j, immovable}};
    pair.bonds = {{0, 1, length, grain_bond, strength}};
    pair.colour_begin = {0, 1};
    stage_.insert({pair});
    at_start_ = {pair.particles[0].angular_velocity, pair.particles[1].angular_velocity};
  }

  Stage& stage() { return stage_; }
  /// Share of the loading that has been applied so far.
  double share() const { return stage_.time() / ((steps - 0.5) * dt); }
  Vec3d force_on_j() { return stage_.dem().particles().force[1]; }
  /// Present torque on an end, for a torque that has grown linearly since the start [N m].
  Vec3d torque_on(int end) {
    const ParticleSnapshot s = stage_.dem().particles();
    const auto k = static_cast<std::size_t>(end);
    const double inertia = 0.4 * s.mass[k] * s.radius[k] * s.radius[k];
    return (2 * inertia / stage_.time()) * (s.angular_velocity[k] - at_start_[k]);
  }

  static constexpr double friction = 0.5;

  static constexpr double internal_friction = 0.6;  ///< of BondFailure::mohr_coulomb

 private:
  static Scene scene(BondFailure failure) {
    Scene scene = bonded_scene(dt, paper_bonds(), {friction, 1, 0});
    scene.bonds->internal_friction = internal_friction;
    scene.bond_model.failure = failure;
    return scene;
  }

  static constexpr double dt = 1e-6;
  Stage stage_;
  std::array<Vec3d, 2> at_start_;  ///< angular velocities [rad/s]
};

void stiffness(Recorder& out) {
  const double small = 1e-3;
  const Tolerance tolerance{1e-6, 1e-6};  // the references have seven digits
  const auto loaded = [&](const Loading& loading) {
    Press press(small * loading, out.precision());
    press.stage().advance(1000);
    return press;
  };
  Press tension = loaded(pull), across = loaded(shove);
  out.relative("normal", -tension.force_on_j().x / (tension.share() * small * stretch), normal, tolerance, source);
  const Vec3d f = across.force_on_j();
  out.relative("shear", -(0.6 * f.y + 0.8 * f.z) / (across.share() * small * slide), shear, tolerance, source);
  // The torque is measured on i, which does not rotate. Only j rotates, and it moves so that the bond is not sheared at
  // i.
  Press bent = loaded({{0, 0, -bend * grain / 2}, {0, 0, 0}, {0, bend, 0}});
  out.relative("bending", bent.torque_on(0).y / (bent.share() * small * bend), bending, tolerance, source);
  Press twisted = loaded({{0, 0, 0}, {0, 0, 0}, {twist, 0, 0}});
  out.relative("torsion", twisted.torque_on(0).x / (twisted.share() * small * twist), torsion, tolerance, source);
}

/// Spheres of two sizes: the section of the bond lies where their surfaces touch. Only i rotates.
void unequal_arms(Recorder& out) {
  const double radius_j = 0.4 * grain / 2, length = grain / 2 + radius_j, arm = grain / 2 / length, angle = 1e-6;
  Press press({{0, 0, 0}, {0, angle, 0}, {0, 0, 0}}, out.precision(), 1, radius_j);
  press.stage().advance(1000);
  const double rotation = press.share() * angle, slid = rotation * grain / 2;  // shear = arm of i x its rotation
  const std::string theory = "section at R_i from i: F = k_s A R_i phi, M_j = k_n I phi - R_j F";
  out.relative("shear-force", -press.force_on_j().z / slid, shear, {1e-6, 1e-6}, theory);
  out.relative("torque-on-small-end", press.torque_on(1).y / rotation, bending - (1 - arm) * length * shear * grain / 2,
               {1e-6, 1e-6}, theory);
}

/// Checks that the bond of a press fails in the first step after the loading is complete, and not earlier.
void fails_in(Press press, Recorder& out, const std::string& name, BreakMode mode, double steps_off = 1e-6,
              const std::string& reference = source) {
  press.stage().advance(Press::steps + 100);
  const std::vector<Breakage> broken = press.stage().dem().take_breakages();
  const bool once = broken.size() == 1;
  out.absolute(name + "-step-of-failure", once ? broken[0].time / press.stage().dt() : -1, Press::steps,
               {steps_off, steps_off}, reference);
  out.absolute(name + "-mode", once ? static_cast<int>(broken[0].mode) : 0, static_cast<int>(mode), {0, 0}, reference);
}

/// The same check for the failure criterion of constant strength.
void fails(Recorder& out, const std::string& name, const Loading& loading, BreakMode mode, double strength = 1,
           double steps_off = 1e-6) {
  fails_in(Press(loading, out.precision(), strength), out, name, mode, steps_off);
}

/// Checks the load just before failure, and the energy that failure releases.
template <class Load>
void at_failure(Recorder& out, const std::string& name, const Loading& loading, double force, double energy,
                Load&& load) {
  Press press(loading, out.precision());
  press.stage().advance(Press::steps - 1);
  out.relative(name + "-load", load(press) / press.share(), force, {5e-6, 5e-6}, source);
  press.stage().advance(1);
  const std::vector<Breakage> broken = press.stage().dem().take_breakages();
  // One step applies 1e-4 of the loading, which can change the energy by up to 3e-4.
  out.relative(name + "-energy-released", broken.empty() ? 0 : broken[0].energy, energy, {3e-4, 3e-4}, source);
}

void tension(Recorder& out) {
  fails(out, "whole", pull, BreakMode::tension);
  fails(out, "half-strength", 0.5 * pull, BreakMode::tension, 0.5);
  at_failure(out, "whole", pull, tension_force, 0.5 * tension_force * stretch,
             [](Press& p) { return p.stage().dem().bonds().normal_force[0]; });
}

void shearing(Recorder& out) {
  fails(out, "whole", shove, BreakMode::shear);
  fails(out, "half-strength", 0.5 * shove, BreakMode::shear, 0.5);
  at_failure(out, "whole", shove, shear_force, 0.5 * shear_force * slide, [](Press& p) {
    return norm(tangential(p.force_on_j(), Vec3d{1, 0, 0}));
  });
}

void bending_and_torsion(Recorder& out) {
  fails(out, "bending", bow, BreakMode::tension);
  fails(out, "torsion", wring, BreakMode::shear);
  // Torques on the end that does not rotate, at half the loading: the straight path of j then adds little tension.
  const auto torque_on_i = [&](const Loading& loading) {
    Press press(loading, out.precision());
    press.stage().advance(Press::steps / 2);
    return (1 / press.share()) * press.torque_on(0);
  };
  out.relative("torsion-load", torque_on_i({{0, 0, 0}, {0, 0, 0}, {twist, 0, 0}}).x, torque, {1e-5, 1e-5}, source);
  out.relative("bending-load", torque_on_i({{0, 0, -bend * grain / 2}, {0, 0, 0}, {0, bend, 0}}).y, bending_moment,
               {1e-5, 1e-5}, source);
}

void combined(Recorder& out) {
  for (const int percent : {25, 50, 75}) {
    const double share = 0.01 * percent;
    fails(out, "pull-" + std::to_string(percent) + "-bending", share * pull + (1 - share) * bow, BreakMode::tension);
    fails(out, "shear-" + std::to_string(percent) + "-torsion", share * shove + (1 - share) * wring, BreakMode::shear);
  }
  fails(out, "push-50-bending-150", -0.5 * pull + 1.5 * bow, BreakMode::tension);
}

/// The two criteria are independent: a load of one criterion neither advances nor delays failure by the other.
void independent(Recorder& out) {
  fails(out, "tension-with-99-torsion", pull + 0.99 * wring, BreakMode::tension);
  fails(out, "torsion-with-99-bending", 0.99 * bow + wring, BreakMode::shear);
  // Compression has shortened the bond by 1e-4. The same slide is then a larger angle: failure comes two steps earlier.
  fails(out, "shear-under-pressure", -0.1 * pull + shove, BreakMode::shear, 1, 2);
}

/// Slide v [m] at which a bond fails in shear. It is shortened by u = `shorter` [m], and its ends do not rotate:
///
///   ks L0^2 (L0 - u) v/L^3 = tau_c + tan(phi) max(0, -kn (L - L0))        L^2 = (L0 - u)^2 + v^2
double slide_at_failure(double shorter, double tan_phi) {
  const BondParameters b = paper_bonds();
  double v = slide;
  for (int k = 0; k < 50; ++k) {
    const double length = std::hypot(grain - shorter, v);
    const double strength = b.shear_strength + tan_phi * std::max(0.0, b.normal_stiffness * (grain - length));
    v = strength * std::pow(length, 3) / (b.shear_stiffness * grain * grain * (grain - shorter));
  }
  return v;
}

/// Compression raises the shear strength of a bond, and tension does not change it. The tensile strength is constant.
void mohr_coulomb(Recorder& out) {
  const std::string theory = "tau_c + tan(phi) x pressure: Potyondy, ARMA 12-501 (2012)";
  const auto fails_at = [&](const std::string& name, const Loading& loading, BreakMode mode) {
    fails_in({loading, out.precision(), 1, grain / 2, BondFailure::mohr_coulomb}, out, name, mode, 1e-6, theory);
  };
  for (const int percent : {50, 200, 1000}) {
    const double shorter = 0.01 * percent * stretch, v = slide_at_failure(shorter, Press::internal_friction);
    fails_at("push-" + std::to_string(percent), {{-shorter, 0.6 * v, 0.8 * v}}, BreakMode::shear);
  }
  const double longer = 0.5 * stretch, v = slide_at_failure(-longer, Press::internal_friction);
  fails_at("pull-50", {{longer, 0.6 * v, 0.8 * v}}, BreakMode::shear);
  fails_at("tension", pull, BreakMode::tension);
}

/// Approach of the two spheres since the start [m], and the normal and tangential forces between them [N].
struct Contact {
  double closed, normal, friction;
};
Contact contact(Press& press) {
  const ParticleSnapshot s = press.stage().dem().particles();
  const Vec3d span = s.position[1] - s.position[0], n = (1 / norm(span)) * span;
  return {grain - norm(span), dot(s.force[1], n), norm(tangential(s.force[1], n))};
}

/// A bond fails in shear while it is compressed: afterwards its normal spring is unchanged, and friction limits the
/// tangential force.
void broken_pressed(Recorder& out) {
  Press press(-0.5 * pull + shove, out.precision());
  press.stage().advance(Press::steps - 1);
  const Contact before = contact(press);
  press.stage().advance(2);
  const Contact after = contact(press);
  const std::string theory = "a broken bond keeps its normal stiffness while it is pressed; Coulomb";
  out.absolute("broken-bonds", static_cast<double>(press.stage().dem().counts().broken_shear), 1, {0, 0}, theory);
  out.relative("stiffness-just-after-failure", after.normal / after.closed, before.normal / before.closed, {1e-6, 1e-6},
               theory);
  press.stage().advance(Press::steps / 2);
  const Contact late = contact(press);
  out.relative("stiffness", late.normal / late.closed, normal, {2e-6, 2e-6}, theory);
  out.relative("friction", late.friction / late.normal, Press::friction, {1e-6, 1e-6}, theory);
}

/// Velocity of a damped oscillator that starts at its rest position with the velocity 1: exp(-xi w t) (cos w_d t -
/// xi/sqrt(1 - xi^2) sin w_d t).
double damped_rate(double frequency, double damping, double time) {
  const double root = std::sqrt(1 - damping * damping), phase = root * frequency * time;
  return std::exp(-damping * frequency * time) * (std::cos(phase) - damping / root * std::sin(phase));
}

/// One mode of a free pair, and its initial motion.
struct Mode {
  std::string name;
  double stiffness, inertia;                           ///< of the mode
  double damping = 1;                                  ///< fraction of critical damping, relative to that of the bond
  Vec3d velocity{0, 0, 0}, angular_velocity{0, 0, 0};  ///< of j; i has the opposite
};

/// The oscillations of a free pair decay with 0.1 of critical damping. In shear the ends also rotate, so that the
/// effective mass of the mode is m/7, while the damper is designed for m/2.
void damping(Recorder& out) {
  const BondStiffness k(paper_bonds());
  const double mass = sphere_mass(grain / 2, rock_density), inertia = 0.1 * mass * grain * grain;
  const std::array<Mode, 4> modes{{{"normal", k.normal, mass / 2, 1, {5e-4, 0, 0}, {0, 0, 0}},
                                   {"shear", k.shear, mass / 7, std::sqrt(3.5), {0, 5e-4, 0}, {0, 0, 0}},
                                   {"bending", k.bending, inertia / 2, 1, {0, 0, 0}, {0, 5e-4, 0}},
                                   {"torsion", k.torsion, inertia / 2, 1, {0, 0, 0}, {5e-4, 0, 0}}}};
  for (const Mode& mode : modes) {
    const double frequency = std::sqrt(mode.stiffness / mode.inertia);
    BondParameters bonds = paper_bonds();
    bonds.damping = 0.1;
    Stage stage(bonded_scene(2 * pi / frequency / 4000, bonds), out.precision());
    NewRock pair = chain(0, 1);
    for (const int end : {0, 1}) {
      NewParticle& p = pair.particles[static_cast<std::size_t>(end)];
      p.velocity = (2.0 * end - 1) * mode.velocity;
      p.angular_velocity = (2.0 * end - 1) * mode.angular_velocity;
    }
    stage.insert({pair});
    stage.advance(5200);  // 1.3 periods
    const ParticleSnapshot s = stage.dem().particles();
    const Vec3d rolling = s.angular_velocity[1] - s.angular_velocity[0];
    const Vec3d sliding = s.velocity[1] - s.velocity[0] -
                          cross(0.5 * (s.angular_velocity[0] + s.angular_velocity[1]), Vec3d{grain, 0, 0});
    const double rate =
        dot(mode.velocity, sliding) / (5e-4 * 1e-3) + dot(mode.angular_velocity, rolling) / (5e-4 * 1e-3);
    out.absolute(mode.name, rate, damped_rate(frequency, 0.1 * mode.damping, stage.time()), {1e-3, 1e-3},
                 "damped oscillator");
  }
}

}  // namespace

std::vector<Verification> bond_cases() {
  return {
      {"bond/stiffness", stiffness},
      {"bond/unequal-spheres", unequal_arms},
      {"bond/tension", tension},
      {"bond/shear", shearing},
      {"bond/moments", bending_and_torsion},
      {"bond/combined", combined},
      {"bond/independent", independent},
      {"bond/broken-pressed", broken_pressed},
      {"bond/damping", damping},
      {"bond/mohr-coulomb", mohr_coulomb},
  };
}

}  // namespace gyro::verify
