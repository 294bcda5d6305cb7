// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/time_step.hpp"

#include "app/simulation/bad_key.hpp"
#include "core/laws/contact/constants.hpp"
#include "core/laws/contact/models.hpp"
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

BondParameters bond_parameters(const CaseBonds& bonds) {
  BondParameters p;
  if (const auto* area = std::get_if<StiffnessPerArea>(&bonds.stiffness)) {
    p.normal_stiffness = area->normal;
    p.shear_stiffness = area->shear;
  } else {
    const auto& modulus = std::get<StiffnessFromModulus>(bonds.stiffness);
    p.normal_modulus = modulus.modulus;
    p.shear_modulus = modulus.modulus / modulus.ratio;
  }
  p.tensile_strength = bonds.tensile_strength;
  p.shear_strength = bonds.shear_strength;
  p.damping = bonds.damping;
  return p;
}

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

namespace {

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
  const auto see_particle = [&](double radius, double rho) {
    if (radius * std::sqrt(rho) < smallest * std::sqrt(density > 0 ? density : rho)) {
      smallest = radius;
      density = rho;
    }
  };
  for (const RockTemplate& rock : library.rocks) {
    if (scene.bonds) limit.consider(rock.critical_step, "bonds of rock " + rock.name);
    for (const double r : rock.radii) see_particle(r, rock.particle_density);
  }
  for (const NewRock& rock : start) {
    if (scene.bonds && !rock.bonds.empty()) {
      const std::string name = std::to_string(rock.id);
      limit.consider(critical_step(as_template(rock, name), *scene.bonds, bed), "bonds of rock " + name);
    }
    for (const NewParticle& p : rock.particles) see_particle(p.radius, p.density);
  }
  if (density > 0) {
    std::ostringstream what;
    what << "contacts of particles of radius " << smallest * 1e3 << " mm";
    limits.contacts = loose_critical_step(smallest, density, bed);
    limit.consider(limits.contacts, what.str());
  }
  return limits;
}

/// Held forces are a leapfrog of the contacts with a step of the whole hold. @throws BadKey
void check_hold(double held, double contact_limit, double step) {
  constexpr double share = 0.5;
  if (held <= share * contact_limit) return;
  std::ostringstream message;
  message << "numerics.substeps would hold contact forces for " << held << " s; at most half their stability limit of "
          << contact_limit << " s is accepted, which is " << std::max(1, static_cast<int>(share * contact_limit / step))
          << " sub-steps of " << step << " s";
  throw BadKey("numerics.substeps", message.str());
}

/// The step in which the fastest wall sweeps the allowed share of the smallest radius.
Limit sweep_limit(const Scene& scene, double smallest_radius) {
  Limit limit;
  for (const Wall& wall : scene.walls) {
    const double speed = sweep_speed(wall, extent_of(wall), pose_of(wall, 0, {}));
    if (speed > 0) limit.consider(scene.limits.speed_ratio * smallest_radius / speed, "motion of wall " + wall.name);
  }
  return limit;
}

double smallest_radius(const RockLibrary& library, std::span<const NewRock> start) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const RockTemplate& rock : library.rocks)
    for (const double r : rock.radii) smallest = std::min(smallest, r);
  for (const NewRock& rock : start)
    for (const NewParticle& p : rock.particles) smallest = std::min(smallest, p.radius);
  return smallest;
}

[[noreturn]] void refuse_step(double wanted, const std::string& what, double maximum, const std::string& remedy) {
  std::ostringstream message;
  message << "time.step " << wanted << " s is above " << what << "; at most " << maximum << " s" << remedy
          << ", or auto, is accepted";
  throw BadKey("time.step", message.str());
}

void check_step(double wanted, const Limit& stable, double safety, const Limit& sweep) {
  constexpr double rounding = 1 + 1e-9;
  std::ostringstream what;
  if (wanted > rounding * safety * stable.step) {
    what << safety << " of the stability limit of " << stable.step << " s (" << stable.by << ")";
    refuse_step(wanted, what.str(), safety * stable.step, " at this time.safety");
  }
  if (wanted > rounding * sweep.step) {
    what << "the step in which no wall moves by more than 0.2 of the smallest radius (" << sweep.by << ")";
    refuse_step(wanted, what.str(), sweep.step, "");
  }
}

}  // namespace

StepChoice choose_step(const Case& input, const Scene& scene, const RockLibrary& library,
                       std::span<const NewRock> start) {
  const Limits limits = stability_limits(scene, library, start);
  const Limit& stable = limits.minimum;
  const int hold = input.numerics.substeps;
  Limit sweep = sweep_limit(scene, smallest_radius(library, start));
  sweep.step /= hold;  // contacts are looked at once a hold
  StepChoice choice;
  const bool swept = sweep.step < input.time.safety * stable.step;
  choice.limit = swept ? sweep.step : stable.step;
  choice.limited_by = swept ? sweep.by : stable.by;
  double wanted = std::min({input.time.safety * stable.step, sweep.step, input.coupling_interval});
  if (input.time.step) {
    wanted = *input.time.step;
    check_step(wanted, stable, input.time.safety, sweep);
  }
  choice.per_window = hold * static_cast<int>(std::ceil(input.coupling_interval / wanted / hold * (1 - 1e-9)));
  choice.dt = input.coupling_interval / choice.per_window;
  if (hold > 1) check_hold(hold * choice.dt, limits.contacts, choice.dt);
  return choice;
}

}  // namespace gyro
