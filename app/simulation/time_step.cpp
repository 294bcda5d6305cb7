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
};

struct Limits {
  Limit minimum;
  double contacts = std::numeric_limits<double>::infinity();  ///< of the smallest loose particle [s]
};

Limits stability_limits(const Scene& scene, const RockLibrary& library, std::span<const NewRock> start) {
  const BedContacts bed = bed_contacts(scene);
  Limits limits;
  Limit& limit = limits.minimum;
  double smallest = 1e300, density = 0;
  const auto consider_particle = [&](double radius, double rho) {
    if (radius * std::sqrt(rho) < smallest * std::sqrt(density > 0 ? density : rho)) {
      smallest = radius;
      density = rho;
    }
  };
  for (const RockTemplate& rock : library.rocks) {
    if (scene.bonds) limit.consider(rock.critical_step, "bonds of rock " + rock.name);
    for (const double r : rock.radii) consider_particle(r, rock.particle_density);
  }
  for (const NewRock& rock : start) {
    if (scene.bonds && !rock.bonds.empty()) {
      const std::string name = std::to_string(rock.id);
      limit.consider(critical_step(as_template(rock, name), *scene.bonds, bed), "bonds of rock " + name);
    }
    for (const NewParticle& p : rock.particles) consider_particle(p.radius, p.density);
  }
  if (density > 0) {
    std::ostringstream what;
    what << "contacts of particles of radius " << smallest * 1e3 << " mm";
    limits.contacts = loose_critical_step(smallest, density, bed);
    limit.consider(limits.contacts, what.str());
  }
  return limits;
}

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

void check_step(double wanted, const Limit& stable, double safety, const Limit& sweep, double speed_ratio) {
  constexpr double rounding = 1 + 1e-9;
  std::ostringstream what;
  if (wanted > rounding * safety * stable.step) {
    what << safety << " of the stability limit of " << stable.step << " s (" << stable.by << ")";
    refuse_step(wanted, what.str(), safety * stable.step, " at this safety factor");
  }
  if (wanted > rounding * sweep.step) {
    what << "the step in which no wall moves by more than " << speed_ratio << " of the smallest radius (" << sweep.by
         << ")";
    refuse_step(wanted, what.str(), sweep.step, "");
  }
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
  const Scene& scene = setup.scene;
  check_scene(scene);
  const Limits limits = stability_limits(scene, setup.library, setup.start);
  const Limit& stable = limits.minimum;
  const int hold = scene.substeps;
  Limit sweep = sweep_limit(scene, smallest_radius(setup.library, setup.start));
  sweep.step /= hold;  // contacts are evaluated once per hold
  StepChoice choice;
  const bool swept = sweep.step < request.safety * stable.step;
  choice.limit = swept ? sweep.step : stable.step;
  choice.limited_by = swept ? sweep.by : stable.by;
  choice.contact_limit = limits.contacts;
  double wanted = std::min({request.safety * stable.step, sweep.step, request.window});
  if (request.step) {
    wanted = *request.step;
    check_step(wanted, stable, request.safety, sweep, scene.limits.speed_ratio);
  }
  if (!(request.window / wanted <= 1e9)) {
    std::ostringstream message;
    message << "a coupling interval of " << request.window << " s has more than 1e9 steps of " << wanted << " s; "
            << (request.step ? "lengthen time.step or shorten coupling.interval" : "shorten coupling.interval");
    throw BadInput(message.str());
  }
  choice.steps_per_window = hold * static_cast<int>(std::ceil(request.window / wanted / hold * (1 - 1e-9)));
  choice.dt = request.window / choice.steps_per_window;
  return choice;
}

void check_hold(const StepChoice& choice, int substeps) {
  constexpr double share = 0.5;
  const double held = substeps * choice.dt, maximum = share * choice.contact_limit;
  if (substeps == 1 || held <= maximum) return;
  std::ostringstream message;
  message << substeps << " sub-steps would hold contact forces for " << held
          << " s; at most half their stability limit of " << choice.contact_limit << " s is possible, which is "
          << std::max(1, static_cast<int>(maximum / choice.dt)) << " sub-steps of " << choice.dt << " s";
  throw BadInput(message.str());
}

StepChoice set_step(Setup& setup, const StepRequest& request) {
  const StepChoice choice = choose_step(setup, request);
  check_hold(choice, setup.scene.substeps);
  set_step(setup, choice);
  return choice;
}

void set_step(Setup& setup, const StepChoice& choice) {
  setup.scene.dt = choice.dt;
  setup.steps_per_window = choice.steps_per_window;
}

}  // namespace gyro
