// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/assembly.hpp"

#include "app/assembly/bad_key.hpp"
#include "app/assembly/initial_from.hpp"
#include "app/assembly/levels.hpp"
#include "app/assembly/lid.hpp"
#include "app/assembly/mesh_checks.hpp"
#include "app/assembly/reach.hpp"
#include "app/assembly/rocks.hpp"
#include "io/rocks/library_cache.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gyro {
namespace {

/// A drive without a gyrating wall is an error; an undriven mantle is allowed.
void check_crusher(const Case& input, Assembly& out) {
  const bool driven = input.drivetrain || input.drivetrain_fmu;
  if (driven && gyrating_wall(out.setup.scene) == none)
    throw BadKey(
        "drivetrain",
        "the drive moves nothing, because no wall gyrates; give walls.mantle the motion gyration, or the crusher "
        "a profile");
  if (input.crusher && !driven) out.notes.push_back("the case has no drivetrain: the mantle does not move");
}

double mass_of(const NewRock& rock) {
  double mass = 0;
  for (const NewParticle& p : rock.particles)
    mass += p.density * 4 / 3 * std::numbers::pi * p.radius * p.radius * p.radius;
  return mass;
}

/// What a table of torques comes to, so that a wrong unit is seen.
void note_curve(Assembly& out, const Case& input) {
  const auto* curve = input.drivetrain ? std::get_if<CurveMotor>(&input.drivetrain->motor) : nullptr;
  if (curve == nullptr) return;
  double torque = 0, power = 0;
  for (std::size_t k = 0; k < curve->torques.size(); ++k) {
    torque = std::max(torque, curve->torques[k]);
    power = std::max(power, curve->torques[k] * curve->speeds[k]);
  }
  char text[160];
  std::snprintf(text, sizeof text, "motor curve: at most %.4g N m and %.4g kW, no load at %.4g rpm", torque,
                1e-3 * power, curve->no_load_speed() * 30 / std::numbers::pi);
  out.notes.push_back(text);
}

/// Notes times that are not a whole number of windows: a run acts at the ends of windows only.
void note_windows(Assembly& out, const Case& input, std::optional<double> until) {
  const auto note = [&](const char* key, double time) {
    const double windows = time / input.coupling_interval;
    if (std::abs(windows - std::round(windows)) < 1e-6 * windows) return;
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s of %g s is not a whole number of coupling intervals of %g s: taken at the end "
                  "of the interval in which it lies",
                  key, time, input.coupling_interval);
    out.notes.push_back(text);
  };
  until ? note("--until", *until) : note("time.duration", input.time.duration);
  note("output.series", input.output.series);
  if (input.output.snapshots > 0) note("output.snapshots", input.output.snapshots);
  if (input.output.liners) note("output.liners.interval", input.output.liners->interval);
}

/// The scene, except walls and step.
void set_scene(Scene& scene, const Case& input) {
  scene.materials = input.materials;
  scene.pairs = pair_table(input);
  scene.rock_material = input.rock_material;
  scene.gravity = input.gravity;
  scene.wall_impulses = input.output.liners.has_value();
  if (input.bonds) {
    scene.bonds = input.bonds->parameters;
    scene.bond_model = input.bonds->model;
  }
}

void set_walls(Assembly& out, const Case& input) {
  CaseWalls walls = make_walls(input);
  out.setup.scene.walls = std::move(walls.walls);
  out.liners = std::move(walls.liners);
  out.pictures = std::move(walls.pictures);
  out.notes = std::move(walls.notes);
}

void set_rock(Assembly& out, const Case& input, const AssemblyRequest& request) {
  Setup& setup = out.setup;
  if (input.rocks) {
    const LibraryRecipe recipe = library_recipe(input, setup.scene);
    setup.library = blaming("rocks", [&] {
      return cached_library(recipe, default_cache_folder(), request.threads, request.library_progress);
    });
    for (std::string& note : floor_notes(recipe, setup.library)) setup.library.notes.push_back(std::move(note));
    out.notes.insert(out.notes.end(), setup.library.notes.begin(), setup.library.notes.end());
  }
  setup.start = blaming("particles", [&] { return start_state(input); });
  setup.bond_strength = bond_strength(input);
  const double rock = removal_depth(setup.library, setup.start) / 2;
  for (std::string& note : size_notes(input, setup.scene.walls, rock)) out.notes.push_back(std::move(note));
  for (std::string& note : tiny_wall_notes(input, setup)) out.notes.push_back(std::move(note));
}

/// Where rock leaves. The opening and the rim are distinguished only if a concave is closed around the axis.
void set_discharge(Assembly& out, const Case& input) {
  if (!input.crusher) return;
  Setup& setup = out.setup;
  setup.discharge.emplace();
  setup.discharge->sieves = sieves_of(input);
  setup.discharge->fines = input.output.fines;
  setup.discharge->removal_depth = input.crusher->removal_depth.value_or(removal_depth(setup.library, setup.start));
  std::string why = "no fixed profile or mesh is called concave";
  try {
    setup.discharge->concave = concave_outline(setup.scene.walls);
  } catch (const BadInput& problem) {
    why = std::string("wall concave: ") + problem.what();
  }
  if (!setup.discharge->concave)
    out.notes.push_back(why + ": all rock that falls below z = 0 counts as product, also rock that left over the rim");
}

void set_step(Assembly& out, const Case& input) {
  const CaseNumerics& numerics = input.numerics;
  StepRequest request{input.coupling_interval, input.time.step, input.time.safety};
  request.rates.substeps = numerics.substeps;
  if (numerics.hold) {
    request.rates.kind = *numerics.hold > 0 ? Rates::Kind::given : Rates::Kind::automatic;
    request.rates.hold = *numerics.hold;
  }
  out.step = blaming("time.step", [&] {
    try {
      return choose_step(out.setup, request);
    } catch (const BadHold& problem) {
      throw BadKey(numerics.hold ? "numerics.hold" : "numerics.substeps", problem.what());
    }
  });
  set_step(out.setup, out.step);
}

/// The filling of the chamber and the feed, whose rocks have numbers after those of the filling.
void set_feed(Assembly& out, const Case& input) {
  Setup& setup = out.setup;
  for (const NewRock& rock : setup.start) out.start_mass += mass_of(rock);
  if (!input.feed->initial_from.empty()) {
    FillingOfCase made =
        blaming("feed.initial_from", [&] { return filling_of(input, setup.scene, setup.library, setup.start); });
    setup.filling = std::move(made.filling);
    out.start_mass += counts_of(*setup.filling, setup.library).mass;
    out.notes.push_back(std::move(made.note));
  }
  setup.feed = blaming("feed", [&] {
    FeedPlan plan = feed_plan(input, setup.scene, setup.library, setup.start);
    if (!setup.filling) return plan;
    plan.first_rock = setup.filling->first_rock + static_cast<RockId>(setup.filling->pieces.size());
    plan.first_particle =
        setup.filling->first_particle + static_cast<ParticleId>(counts_of(*setup.filling, setup.library).particles);
    return plan;
  });
}

std::optional<Drivetrain> make_drivetrain(const Case& input) {
  if (input.drivetrain) return blaming("drivetrain", [&] { return Drivetrain(*input.drivetrain); });
  if (!input.drivetrain_fmu) return std::nullopt;
  const CaseFmu& fmu = *input.drivetrain_fmu;
  return blaming("drivetrain.fmu", [&] {
    return Drivetrain(open_drive(fmu), {fmu.residual_limit, fmu.bushing_depth});
  });
}

/// The key of a case file that a part of a setup comes from.
std::string key_of(SetupPart part) {
  switch (part) {
    case SetupPart::step:
      return "time.step";
    case SetupPart::start:
      return "particles";
    case SetupPart::feed:
      return "feed";
    case SetupPart::scene:
      break;
  }
  return "walls";
}

}  // namespace

const std::vector<double>& sieves_of(const Case& input) {
  return input.output.sieves.empty() ? sieve_series() : input.output.sieves;
}

Assembly assemble(const Case& input, const AssemblyRequest& request) {
  if (input.drivetrain) blaming("drivetrain", [&] { check_drivetrain(*input.drivetrain); });
  const double end = request.until.value_or(input.time.duration);
  Assembly out;
  set_walls(out, input);
  check_crusher(input, out);
  note_curve(out, input);
  set_scene(out.setup.scene, input);
  set_rock(out, input, request);
  set_discharge(out, input);
  set_step(out, input);
  if (std::string note = set_levels(out.setup, input, request.threads); !note.empty())
    out.notes.push_back(std::move(note));
  note_windows(out, input, request.until);
  out.setup.inspection_interval = input.output.series;
  if (input.feed) set_feed(out, input);
  if (input.crusher) out.resolution = resolution_of(out.setup);
  if (input.crusher && input.crusher->lid) check_lid(*input.crusher->lid, out.setup);
  for (std::string& note : reach_notes(input, out.setup, end)) out.notes.push_back(std::move(note));
  out.expected = expected_counts(out.setup, out.step, input.numerics.precision, end);
  check_steps(out.expected, input, out.step, request.until);
  for (std::string& note : check_counts(out.expected, out.setup)) out.notes.push_back(std::move(note));
  return out;
}

std::unique_ptr<Simulation> make_simulation(const Case& input, Setup setup, std::unique_ptr<Dem> dem,
                                            const SavedState* saved) {
  std::optional<Drivetrain> drivetrain = make_drivetrain(input);
  try {
    return std::make_unique<Simulation>(std::move(setup), std::move(dem), std::move(drivetrain), saved);
  } catch (const BadSetup& bad) {
    throw BadKey(key_of(bad.part), bad.what());
  }
}

}  // namespace gyro
