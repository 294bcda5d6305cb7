// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/time_step.hpp"

#include "core/laws/contact/models.hpp"
#include "core/laws/contact/scene_contacts.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace gyro {

BedContacts bed_contacts(const Scene& scene) {
  constexpr double number = 6, overlap = 0.05;
  const ContactConstants<double> law = contact_constants<double>(scene, scene.rock_material, scene.rock_material);
  const ContactStiffness stiffness = contact_stiffness(rock_model(scene), law, 0.5, overlap);  // R* of R = 1
  BedContacts bed;
  bed.number = number;
  bed.normal_stiffness = stiffness.normal;
  bed.tangential_stiffness = stiffness.tangential + stiffness.rolling;
  bed.normal_damping = bed.tangential_damping = stiffness.damping;
  bed.damping_cap = scene.damping_cap;
  return bed;
}

namespace {

/// A rock of a start state in the form of a template, for its critical step.
RockTemplate as_template(const NewRock& rock, const std::string& name) {
  RockTemplate t;
  t.name = name;
  for (const NewParticle& p : rock.particles) {
    t.centres.push_back(p.position);
    t.radii.push_back(p.radius);
    t.particle_density = p.density;
  }
  for (const NewBond& b : rock.bonds) t.bonds.push_back({b.i, b.j, b.length, b.radius});
  t.colour_begin = rock.colour_begin;
  return t;
}

struct Limit {
  double step = std::numeric_limits<double>::infinity();
  std::string by;
  void consider(double other, const std::string& what) {
    if (other < step) {
      step = other;
      by = what;
    }
  }
  void consider(const Limit& other) { consider(other.step, other.by); }
};

/// The smallest loose particle, by its step: a contact's stiffness grows with the radius.
struct SmallestParticle {
  double radius = 1e300, density = 0;
  void consider(double other, double rho) {
    if (density > 0 && !(other * std::sqrt(rho) < radius * std::sqrt(density))) return;
    radius = other;
    density = rho;
  }
};

SmallestParticle smallest_particle(const RockLibrary& library, std::span<const NewRock> start) {
  SmallestParticle smallest;
  for (const RockTemplate& rock : library.rocks)
    for (const double r : rock.radii) smallest.consider(r, rock.particle_density);
  for (const NewRock& rock : start)
    for (const NewParticle& p : rock.particles) smallest.consider(p.radius, p.density);
  return smallest;
}

/// Limits of the steps of a setup's rocks.
class RockLimits {
 public:
  explicit RockLimits(const Setup& setup)
      : setup_(setup), bed_(bed_contacts(setup.scene)), smallest_(smallest_particle(setup.library, setup.start)) {}

  /// Contacts of the smallest loose particle [s].
  Limit loose(bool damped) const {
    Limit limit;
    if (!(smallest_.density > 0)) return limit;
    BedContacts bed = bed_;
    if (!damped) bed.normal_damping = bed.tangential_damping = 0;
    std::ostringstream what;
    what << "contacts of particles of radius " << smallest_.radius * 1e3 << " mm";
    limit.consider(loose_critical_step(smallest_.radius, smallest_.density, bed), what.str());
    return limit;
  }

  /// A rock with bonds, and the place of its sub-steps.
  struct Rock {
    std::vector<int> StepChoice::*place;
    std::size_t k;
  };
  std::vector<Rock> bonded() const {
    std::vector<Rock> all;
    if (!setup_.scene.bonds) return all;
    for (std::size_t k = 0; k < setup_.library.rocks.size(); ++k)
      if (!setup_.library.rocks[k].bonds.empty()) all.push_back({&StepChoice::of_library, k});
    for (std::size_t k = 0; k < setup_.start.size(); ++k)
      if (!setup_.start[k].bonds.empty()) all.push_back({&StepChoice::of_start, k});
    return all;
  }

  /// @param with_bed  bonds with what the rock touches, or alone
  Limit of(const Rock& rock, bool with_bed) const {
    Limit limit;
    if (rock.place == &StepChoice::of_library) {
      const RockTemplate& t = setup_.library.rocks[rock.k];
      limit.consider(with_bed ? t.critical_step : t.bond_step, "bonds of rock " + t.name);
    } else {
      const std::string name = std::to_string(setup_.start[rock.k].id);
      limit.consider(
          critical_step(as_template(setup_.start[rock.k], name), *setup_.scene.bonds, with_bed ? bed_ : BedContacts{}),
          "bonds of rock " + name);
    }
    return limit;
  }

 private:
  const Setup& setup_;
  BedContacts bed_;
  SmallestParticle smallest_;
};

/// The step in which the fastest wall of given motion sweeps the allowed share of the smallest radius.
Limit sweep_limit(const Scene& scene, double smallest_radius) {
  Limit limit;
  for (const Wall& wall : scene.walls) {
    const double speed = sweep_speed(wall, extent_of(wall), pose_of(wall, 0, {}));
    if (speed > 0) limit.consider(scene.limits.speed_ratio * smallest_radius / speed, "motion of wall " + wall.name);
  }
  return limit;
}

[[noreturn]] void refuse_step(double wanted, const std::string& what, double maximum, const std::string& condition) {
  std::ostringstream message;
  message << "the time step of " << wanted << " s is above " << what << "; it must be at most " << maximum << " s"
          << condition << ", or be chosen by the program";
  throw BadInput(message.str());
}

void check_step(double wanted, const Limit& stable, double safety) {
  constexpr double rounding = 1 + 1e-9;
  if (wanted <= rounding * safety * stable.step) return;
  std::ostringstream what;
  what << safety << " of the stability limit of " << stable.step << " s (" << stable.by << ")";
  refuse_step(wanted, what.str(), safety * stable.step, " at this safety factor");
}

void check_sweep(double wanted, const Limit& sweep, double speed_ratio) {
  constexpr double rounding = 1 + 1e-9;
  if (wanted <= rounding * sweep.step) return;
  std::ostringstream what;
  what << "the step in which no wall moves by more than " << speed_ratio << " of the smallest radius (" << sweep.by
       << ")";
  refuse_step(wanted, what.str(), sweep.step, "");
}

constexpr double max_window_steps = 1e9;  // of a window: they are counted in 32 bits

[[noreturn]] void refuse_count(double window, double step, bool asked_for) {
  std::ostringstream message;
  message << "a coupling interval of " << window << " s has more than 1e9 steps of " << step << " s; "
          << (asked_for ? "lengthen time.step or shorten coupling.interval" : "shorten coupling.interval");
  throw BadInput(message.str());
}

/// Divides the window into steps of at most `wanted`.
void divide(double window, double wanted, bool asked_for, StepChoice& choice) {
  if (!(window / wanted <= max_window_steps)) refuse_count(window, wanted, asked_for);
  choice.steps_per_window = static_cast<int>(std::ceil(window / wanted * (1 - 1e-9)));
  choice.dt = window / choice.steps_per_window;
}

[[noreturn]] void refuse_hold(double wanted, double share, double limit, const std::string& instead) {
  std::ostringstream message;
  message << "contact and wall forces would be held for " << wanted << " s; at most " << share
          << " of their stability limit of " << limit << " s is possible, " << instead;
  throw BadHold(message.str());
}

/// Held contacts feed vibrations of bonds with twice the period of the hold, which some damping of bonds stops: from
/// 0.01 on, more changes nothing (tests/hard/near_limit.md).
double held_share(const Scene& scene, const Rates& rates) {
  constexpr double min_damping = 0.01, share_below = 0.35;
  return scene.bonds && scene.bonds->damping < min_damping ? std::min(rates.share, share_below) : rates.share;
}

void check_hold(const StepChoice& choice, const Scene& scene, const Rates& rates) {
  const double maximum = held_share(scene, rates) * choice.contact_limit;
  if (choice.max_substeps == 1 || choice.dt <= maximum) return;
  std::ostringstream instead;
  instead << "which is " << std::max(1, static_cast<int>(maximum / choice.bond_step)) << " sub-steps of "
          << choice.bond_step << " s";
  refuse_hold(choice.dt, held_share(scene, rates), choice.contact_limit, instead.str());
}

/// A hold that is asked for must not be above what is allowed.
void check_given(double hold, double allowed, const std::string& by) {
  constexpr double rounding = 1 + 1e-9;
  if (hold <= rounding * allowed) return;
  std::ostringstream message;
  message << "contact and wall forces would be held for " << hold << " s; at most " << allowed << " s is possible ("
          << by << ")";
  throw BadHold(message.str());
}

/// All rocks have the same sub-steps.
void choose_uniform(const Setup& setup, const StepRequest& request, const RockLimits& rocks, Limit sweep,
                    StepChoice& choice) {
  const int substeps = request.rates.kind == Rates::Kind::uniform ? request.rates.substeps : 1;
  Limit stable = rocks.loose(true);
  for (const RockLimits::Rock& rock : rocks.bonded()) stable.consider(rocks.of(rock, true));
  sweep.step /= substeps;
  const bool swept = sweep.step < request.safety * stable.step;
  choice.limit = swept ? sweep.step : stable.step;
  choice.limited_by = swept ? sweep.by : stable.by;
  double wanted = std::min({request.safety * stable.step, sweep.step, request.window});
  if (request.step) {
    wanted = *request.step;
    check_step(wanted, stable, request.safety);
    check_sweep(wanted, sweep, setup.scene.limits.speed_ratio);
  }
  if (request.rates.kind == Rates::Kind::given) {  // of a scene without bonded rock
    check_given(request.rates.hold, request.safety * stable.step, stable.by);
    wanted = std::min(wanted, request.rates.hold);
  }
  divide(request.window, wanted * substeps, request.step.has_value(), choice);
  choice.min_substeps = choice.max_substeps = substeps;
  choice.bond_step = choice.dt / substeps;
  check_hold(choice, setup.scene, request.rates);
  choice.of_library.assign(setup.library.rocks.size(), substeps);
  choice.of_start.assign(setup.start.size(), substeps);
}

/// The longest step of the scene that contacts and walls allow, or the one that is asked for.
void choose_hold(const Setup& setup, const StepRequest& request, const Limit& undamped, const Limit& sweep,
                 StepChoice& choice) {
  const double reserve = std::min(1.0, request.safety / StepRequest{}.safety);  // the usual one is in the share
  const double allowed = reserve * held_share(setup.scene, request.rates) * undamped.step;
  double hold = std::min({allowed, sweep.step, request.window});
  choice.hold_limited_by = hold == allowed ? undamped.by : hold == sweep.step ? sweep.by : "the coupling interval";
  if (request.rates.kind == Rates::Kind::given) {
    check_given(request.rates.hold, allowed, undamped.by);
    check_given(request.rates.hold, sweep.step, sweep.by);
    hold = request.rates.hold;
    choice.hold_limited_by = "numerics.hold";
    if (!(request.window / hold <= max_window_steps))
      throw BadHold("a coupling interval has more than 1e9 holds of this length; lengthen it");
  }
  divide(request.window, hold, request.step.has_value(), choice);
}

/// Each rock has the sub-steps that its bonds need. One without any feels contacts and bonds in the same step, and must
/// be stable with both.
void choose_substeps(const Setup& setup, const StepRequest& request, const RockLimits& rocks, StepChoice& choice) {
  choice.of_library.assign(setup.library.rocks.size(), 1);
  choice.of_start.assign(setup.start.size(), 1);
  const std::vector<RockLimits::Rock> bonded = rocks.bonded();
  choice.min_substeps = bonded.empty() ? 1 : std::numeric_limits<int>::max();
  Limit stiffest;
  for (const RockLimits::Rock& rock : bonded) {
    const Limit alone = rocks.of(rock, false);
    stiffest.consider(alone);
    if (request.step) check_step(*request.step, alone, request.safety);
    const double step = std::min(request.safety * alone.step, request.step.value_or(1e300));
    if (!(request.window / step <= max_window_steps)) refuse_count(request.window, step, request.step.has_value());
    int substeps = std::max(1, static_cast<int>(std::ceil(choice.dt / step * (1 - 1e-9))));
    if (substeps == 1 && choice.dt > request.safety * rocks.of(rock, true).step) substeps = 2;
    (choice.*rock.place)[rock.k] = substeps;
    choice.min_substeps = std::min(choice.min_substeps, substeps);
    choice.max_substeps = std::max(choice.max_substeps, substeps);
  }
  choice.bond_step = choice.dt / choice.max_substeps;
  choice.limit = std::isfinite(stiffest.step) ? stiffest.step : choice.contact_limit;
  choice.limited_by = std::isfinite(stiffest.step) ? stiffest.by : choice.hold_limited_by;
}

}  // namespace

double smallest_radius(const RockLibrary& library, std::span<const NewRock> start) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const RockTemplate& rock : library.rocks)
    for (const double r : rock.radii) smallest = std::min(smallest, r);
  for (const NewRock& rock : start)
    for (const NewParticle& p : rock.particles) smallest = std::min(smallest, p.radius);
  return smallest;
}

StepChoice choose_step(const Setup& setup, const StepRequest& request) {
  check_scene(setup.scene);
  const RockLimits rocks(setup);
  const Limit sweep = sweep_limit(setup.scene, smallest_radius(setup.library, setup.start));
  const Limit undamped = rocks.loose(false);
  StepChoice choice;
  choice.contact_limit = undamped.step;
  if (request.rates.kind == Rates::Kind::uniform || rocks.bonded().empty()) {
    choose_uniform(setup, request, rocks, sweep, choice);
  } else {
    choose_hold(setup, request, undamped, sweep, choice);
    choose_substeps(setup, request, rocks, choice);
  }
  return choice;
}

StepChoice set_step(Setup& setup, const StepRequest& request) {
  const StepChoice choice = choose_step(setup, request);
  set_step(setup, choice);
  return choice;
}

void set_step(Setup& setup, const StepChoice& choice) {
  setup.scene.dt = choice.dt;
  setup.scene.substeps = choice.max_substeps;
  setup.steps_per_window = choice.steps_per_window;
  for (std::size_t k = 0; k < choice.of_library.size(); ++k) setup.library.rocks[k].substeps = choice.of_library[k];
  for (std::size_t k = 0; k < choice.of_start.size(); ++k) setup.start[k].substeps = choice.of_start[k];
}

}  // namespace gyro
