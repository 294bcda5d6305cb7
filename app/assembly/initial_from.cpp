// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/initial_from.hpp"

#include "app/simulation/setup.hpp"
#include "app/simulation/time_step.hpp"
#include "core/fragments/product.hpp"
#include "core/state/bonds.hpp"
#include "core/state/fragment_labels.hpp"
#include "io/run/state_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace gyro {
namespace {

/// The columns of a saved run that its fragments follow from.
struct SavedRock {
  std::vector<Vec3d> centre, velocity;
  std::vector<double> radius, mass;
  std::vector<ParticleId> id;
  std::vector<Index> block;  ///< of each particle
  std::vector<Block> blocks;
  std::vector<Index> fragment;      ///< of each particle: the first particle of its fragment
  std::vector<std::uint8_t> place;  ///< Product::State

  explicit SavedRock(const SavedState& s)
      : centre(s.get<Vec3d>("particles/position/centre")),
        velocity(s.get<Vec3d>("particles/motion/velocity", centre.size())),
        radius(s.get<double>("particles/position/radius", centre.size())),
        mass(s.get<double>("particles/motion/mass", centre.size())),
        id(s.get<ParticleId>("particles/id", centre.size())),
        block(s.get<Index>("particles/block", centre.size())),
        blocks(s.get<Block>("blocks")),
        place(s.get_one<Product::State>("product").place) {
    const std::vector<Index> i = s.get<Index>("bonds/i"), j = s.get<Index>("bonds/j", i.size());
    const std::vector<std::int32_t> state = s.get<std::int32_t>("bonds/state", i.size());
    std::vector<Index> a, b;
    for (std::size_t k = 0; k < i.size(); ++k)
      if (state[k] == bond_intact) a.push_back(i[k]), b.push_back(j[k]);
    fragment = fragment_labels(static_cast<Index>(centre.size()), a, b);
  }

  bool has_left(std::size_t k) const { return id[k] < place.size() && place[id[k]] != FragmentRecord::in_chamber; }
  /// Whether so many particles are all of an unbroken rock, of which this is one.
  bool is_whole(std::size_t k, Index particles) const {
    if (block[k] == none) return false;
    const Block& rock = blocks.at(static_cast<std::size_t>(block[k]));
    return rock.state == block_intact && rock.end_particle - rock.first_particle == particles;
  }
};

Vec3d turned(const Vec3d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// Angle by which the source's mantle must be turned back to where the new run's starts [rad].
double turn_of(const SavedState& state, const Case& input) {
  const double start = input.drivetrain ? input.drivetrain->start_angle : 0;
  const bool driven = state.columns().contains("drivetrain/angle");
  return driven ? start - state.get_one<double>("drivetrain/angle") : 0;
}

/// @throws BadInput for a source whose rock is not that of the case
void require_same_rock(const Case& input, const SavedState& state) {
  const std::string resolved = state.get_text("case/resolved");
  if (!has_key(resolved, "crusher")) throw BadInput("is of a run without a crusher; give one of a crusher");
  if (const auto differs = difference_in("materials.rock", input.resolved, resolved))
    throw BadInput("is of a run with other rock: " + differs->key + " is " + differs->other + " there and " +
                   differs->value + " here; use a run of the same rock");
}

/// The room of the filling: the chamber, and above it as high as the source's rock lies, but not above a lid.
ChamberRegion chamber_of(const Case& input, const Scene& scene, const RockLibrary& library,
                         std::span<const SourceFragment> fragments) {
  const Wall& outer = scene.walls[static_cast<std::size_t>(input.feed->above)];
  double low = 0, high = RadiusByHeight(outer, RadiusByHeight::Side::outer).high(), largest = 0;
  for (const RockTemplate& rock : library.rocks) largest = std::max(largest, 2 * rock.bounding_radius);
  for (const SourceFragment& f : fragments) {
    low = std::min(low, f.centre.z - f.radius);
    high = std::max(high, f.centre.z + f.radius + largest);
  }
  if (input.crusher->lid) high = std::min(high, *input.crusher->lid);
  return {input.feed->above, gyrating_wall(scene), low, high};
}

std::string note_on(const std::filesystem::path& file, double time, std::span<const SourceFragment> fragments,
                    const FillingCounts& counts, std::size_t pieces, const std::string& digest) {
  double mass = 0, singles = 0, height = 0;
  for (const SourceFragment& f : fragments) {
    mass += f.mass;
    height += f.mass * f.centre.z;
    if (f.single) singles += f.mass;
  }
  char text[400];
  std::snprintf(
      text, sizeof text,
      " at t = %.4g s (digest %s): %.6g kg in %zu fragments, %.3g %% of it single particles, centre of mass at "
      "z = %.4g m; this run begins with %.6g kg in %zu pieces of %lld particles and %lld bonds, %.3g %% of it "
      "single particles",
      time, digest.c_str(), mass, fragments.size(), mass > 0 ? 100 * singles / mass : 0.0,
      mass > 0 ? height / mass : 0.0, counts.mass, pieces, static_cast<long long>(counts.particles),
      static_cast<long long>(counts.bonds), counts.mass > 0 ? 100 * counts.singles_mass / counts.mass : 0.0);
  return "feed.initial_from: the hold-up of " + file.string() + text;
}

/// The digest of a file in Case::inputs.
std::string digest_in(const std::string& inputs, const std::filesystem::path& file) {
  std::istringstream lines(inputs);
  for (std::string line; std::getline(lines, line);)
    if (line.ends_with(" " + file.string())) return line.substr(0, line.find(' '));
  return {};
}

}  // namespace

std::vector<SourceFragment> hold_up_of(const SavedState& state, double angle) {
  const SavedRock rock(state);
  std::vector<SourceFragment> fragments;
  std::vector<Index> row(rock.centre.size(), none), particles;
  std::vector<double> volume;
  for (std::size_t k = 0; k < rock.centre.size(); ++k) {
    if (rock.has_left(k)) continue;  // all of a fragment, or nothing of it
    Index& mine = row[static_cast<std::size_t>(rock.fragment[k])];
    if (mine == none) {
      mine = static_cast<Index>(fragments.size());
      fragments.push_back({{0, 0, 0}, 0, 0});
      particles.push_back(0);
      volume.push_back(0);
    }
    const auto n = static_cast<std::size_t>(mine);
    SourceFragment& f = fragments[n];
    f.centre = f.centre + rock.mass[k] * rock.centre[k];
    f.velocity = f.velocity + rock.mass[k] * rock.velocity[k];
    f.mass += rock.mass[k];
    volume[n] += std::pow(rock.radius[k], 3);
    f.single = ++particles[n] == 1;
    f.whole = rock.is_whole(k, particles[n]) && particles[n] > 1;
  }
  for (std::size_t n = 0; n < fragments.size(); ++n) {
    SourceFragment& f = fragments[n];
    f.centre = turned((1 / f.mass) * f.centre, angle);
    f.velocity = turned((1 / f.mass) * f.velocity, angle);
    f.radius = std::cbrt(volume[n]);
  }
  return fragments;
}

FillingOfCase filling_of(const Case& input, const Scene& scene, const RockLibrary& library,
                         std::span<const NewRock> start) {
  const std::filesystem::path& file = input.feed->initial_from;
  const SavedState state = read_state(file, "give the directory of another run");
  try {
    require_same_rock(input, state);
    const std::vector<SourceFragment> fragments = hold_up_of(state, turn_of(state, input));
    if (fragments.empty()) throw BadInput("has no rock in its chamber; give a run that holds some");
    FillingOfCase made;
    ChamberFilling& filling = made.filling;
    filling.chamber = chamber_of(input, scene, library, fragments);
    filling.seed = input.identity.seed;
    filling.clearance = std::min(filling.clearance, smallest_radius(library, start));
    for (const NewRock& rock : start) {
      filling.first_rock = std::max(filling.first_rock, static_cast<RockId>(rock.id + 1));
      for (const NewParticle& p : rock.particles) filling.first_particle = std::max(filling.first_particle, p.id + 1);
    }
    filling.pieces = pieces_of(library, fragments, filling.seed, static_cast<std::uint64_t>(filling.first_rock));
    made.note = note_on(file, state.get_one<double>("output/time"), fragments, counts_of(filling, library),
                        filling.pieces.size(), digest_in(input.inputs, file));
    return made;
  } catch (const BadInput& problem) {
    throw BadInput(file.string() + " " + problem.what());
  }
}

}  // namespace gyro
