// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/expected_counts.hpp"

#include "app/assembly/bad_key.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

constexpr double max_particles_of_run = 2e9;  // ids have 32 bits, indices a sign besides
constexpr double many_particles = 1e7;        // [-]; a run of them takes weeks on a CPU
constexpr double max_steps = 1e15;            // counted exactly by 64 bits and by doubles
constexpr double share_of_memory = 0.9;       // the rest is for walls, output and the system
constexpr const char* advice =
    "; raise the smallest size of the rock (check its unit), feed less, or use fewer particles a rock";

/// Rock that the feed draws on average: kinds are drawn with probability proportional to 1/mass.
struct MeanRock {
  double mass = 0, particles = 0, bonds = 0;
};

MeanRock mean_rock(const RockLibrary& library, double density) {
  MeanRock mean;
  double weights = 0;
  for (const RockTemplate& rock : library.rocks) {
    const double mass = density * rock.solid_volume, weight = 1 / mass;
    weights += weight;
    mean.mass += weight * mass;
    mean.particles += weight * static_cast<double>(rock.centres.size());
    mean.bonds += weight * static_cast<double>(rock.bonds.size());
  }
  if (!(weights > 0)) return {};
  return {mean.mass / weights, mean.particles / weights, mean.bonds / weights};
}

void add_start(ExpectedCounts& counts, const std::vector<NewRock>& start) {
  for (const NewRock& rock : start) {
    counts.rocks += 1;
    counts.particles += static_cast<double>(rock.particles.size());
    counts.bonds += static_cast<double>(rock.bonds.size());
  }
}

void add_filling(ExpectedCounts& counts, const ChamberFilling& filling, const RockLibrary& library) {
  const FillingCounts pieces = counts_of(filling, library);
  counts.rocks += static_cast<double>(filling.pieces.size());
  counts.particles += static_cast<double>(pieces.particles);
  counts.bonds += static_cast<double>(pieces.bonds);
}

void add_feed(ExpectedCounts& counts, const FeedPlan& plan, const RockLibrary& library, const MeanRock& mean,
              double duration) {
  for (const FixedRock& fixed : plan.fixed) {
    const RockTemplate& rock = library.rocks[static_cast<std::size_t>(fixed.rock)];
    counts.rocks += 1;
    counts.particles += static_cast<double>(rock.centres.size());
    counts.bonds += static_cast<double>(rock.bonds.size());
  }
  if (!(mean.mass > 0)) return;
  const double at_start = (plan.initial + plan.batch) / mean.mass;
  counts.rocks += at_start;
  counts.particles += at_start * mean.particles;
  counts.bonds += at_start * mean.bonds;
  counts.fed_rocks = plan.rate * std::max(0.0, duration - plan.start) / mean.mass;
  counts.fed_particles = counts.fed_rocks * mean.particles;
  counts.fed_bonds = counts.fed_rocks * mean.bonds;
}

std::string counted(const ExpectedCounts& counts) {
  char text[160];
  std::snprintf(text, sizeof text, "%.3g rocks with %.3g particles and %.3g bonds at the start, about %.3g GB",
                counts.rocks, counts.particles, counts.bonds, counts.bytes_at_start / 1e9);
  return text;
}

std::string sizes_of(const RockLibrary& library) {
  if (library.rocks.empty()) return {};
  const auto [small, large] = std::ranges::minmax(library.rocks, {}, &RockTemplate::diameter);
  char text[100];
  std::snprintf(text, sizeof text, " (rocks of %.4g to %.4g mm)", 1e3 * small.diameter, 1e3 * large.diameter);
  return text;
}

std::string in_words(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

/// @param found  what the start has, in words
std::vector<std::string> check_memory(const ExpectedCounts& counts, const Setup& setup, const std::string& found,
                                      const FreeMemory& memory) {
  const double allowed = share_of_memory * memory.bytes;
  const std::string too_much = "more than 0.9 of " + memory.what + ", " + in_words(memory.bytes / 1e9) + " GB";
  if (counts.window_bytes > allowed)
    throw BadKey("coupling.interval", "the positions of the walls in the steps of a coupling interval take " +
                                          in_words(counts.window_bytes / 1e9) + " GB: " + too_much + "; shorten it");
  if (counts.bytes_at_start + counts.window_bytes > allowed)
    throw BadKey(setup.feed ? "feed" : "particles", found + ": " + too_much + advice);
  if (!(counts.bytes > allowed)) return {};
  const std::string at_end = "by the end of the run the feed adds " + in_words(counts.fed_particles) +
                             " particles, about " + in_words(counts.bytes / 1e9) +
                             " GB in all, if all of it finds room";
  return {at_end + (setup.discharge ? " and nothing is discharged: " : " (without a crusher nothing is removed): ") +
          too_much + "; the run ends with exit code 6 if the scene holds that much at a time"};
}

}  // namespace

ExpectedCounts expected_counts(const Setup& setup, const StepChoice& step, Precision precision, double duration) {
  const Scene& scene = setup.scene;
  ExpectedCounts counts;
  counts.steps = duration / step.dt;
  constexpr double copies = 2;  // of the host and of the device
  counts.window_bytes =
      copies * sizeof(WallPose) * static_cast<double>(scene.walls.size()) * static_cast<double>(step.steps_per_window);
  add_start(counts, setup.start);
  if (setup.filling) add_filling(counts, *setup.filling, setup.library);
  if (setup.feed) {
    const double density = scene.materials[static_cast<std::size_t>(scene.rock_material)].density;
    add_feed(counts, *setup.feed, setup.library, mean_rock(setup.library, density), duration);
  }
  if (!scene.bonds) counts.bonds = counts.fed_bonds = 0;  // rocks fall apart
  counts.bytes_at_start = expected_bytes(counts.particles, counts.bonds, precision);
  counts.bytes = expected_bytes(counts.particles + counts.fed_particles, counts.bonds + counts.fed_bonds, precision);
  return counts;
}

void check_steps(const ExpectedCounts& counts, const Case& input, const StepChoice& step, std::optional<double> until) {
  const double steps = counts.steps * step.max_substeps;
  if (steps <= max_steps) return;
  const std::string found = "the run has " + in_words(steps) + " steps, more than 1e15; ";
  const double end = until.value_or(input.time.duration);
  const double usual = std::min(input.time.safety * step.limit, 1e-3);  // the limit is infinite without rock
  if (end / usual <= max_steps) {
    const std::string key = input.time.step ? "time.step" : "coupling.interval";
    throw BadKey(key, found + "lengthen " + key + " (check its unit)");
  }
  if (until) throw BadInput("--until: " + found + "give an earlier end (check its unit)");
  throw BadKey("time.duration", found + "shorten it (check its unit)");
}

std::vector<std::string> check_counts(const ExpectedCounts& counts, const Setup& setup, const FreeMemory& memory) {
  const std::string key = setup.feed ? "feed" : "particles";
  const std::string found = counted(counts) + sizes_of(setup.library);
  if (!(counts.particles <= max_particles_of_run)) throw BadKey(key, found + ": more than 2e9 particles" + advice);
  if (!(counts.particles + counts.fed_particles <= max_particles_of_run))
    throw BadKey(key,
                 found + ", and the feed adds more than 2e9 particles over the run, if all of it finds room" + advice);
  std::vector<std::string> notes = check_memory(counts, setup, found, memory);
  if (counts.particles > many_particles) notes.push_back("large case: " + found);
  return notes;
}

}  // namespace gyro
