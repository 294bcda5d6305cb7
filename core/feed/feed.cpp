// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/feed.hpp"

#include "core/base/errors.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <numbers>

namespace gyro {
namespace {

double mass_of(const RockTemplate& rock) {
  double volume = 0;
  for (const double r : rock.radii) volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  return rock.particle_density * volume;
}

double largest_radius_of(const RockLibrary& library) {
  double largest = 0;
  for (const RockTemplate& rock : library.rocks) {
    for (const double r : rock.radii) largest = std::max(largest, r);
  }
  return largest;
}

double largest_bounding_radius(const RockLibrary& library) {
  double largest = 0;
  for (const RockTemplate& rock : library.rocks) largest = std::max(largest, rock.bounding_radius);
  return largest;
}

std::string in_mm(double length) {
  return std::to_string(1000 * length) + " mm";
}

void check_fits(const char* what, const FeedRegion& region, double size) {
  if (size <= region.narrowest()) return;
  throw BadInput(std::string(what) + " of " + in_mm(size) + " is larger than the region it is fed into (" +
                 in_mm(region.narrowest()) + "); use smaller rocks or a larger region");
}

}  // namespace

Feed::Feed(const RockLibrary& library, FeedPlan plan, std::span<const Wall> walls, BondStrength strength)
    : library_(library),
      plan_(std::move(plan)),
      strength_(std::move(strength)),
      largest_radius_(largest_radius_of(library)),
      walls_(walls, largest_radius_, plan_.clearance) {
  for (const RockTemplate& rock : library_.rocks) {
    masses_.push_back(mass_of(rock));
    cumulative_.push_back((cumulative_.empty() ? 0 : cumulative_.back()) + 1 / masses_.back());
  }
  for (double& c : cumulative_) c /= cumulative_.back();
  if (plan_.charge) charge_.emplace(*plan_.charge, walls);
  if (plan_.entry) entry_.emplace(*plan_.entry, walls);
  state_.of_template.assign(library_.rocks.size(), 0);
  check_plan();
}

void Feed::check_plan() const {
  if (library_.rocks.empty()) throw BadInput("the feed has no rocks; the library must have at least one");
  for (const double m : {plan_.initial, plan_.batch, plan_.rate, plan_.start}) {
    if (!(m >= 0)) throw BadInput("every feed mass, rate and start must be >= 0");
  }
  if (!(plan_.clearance > 0 && plan_.retry > 0 && plan_.positions > 0 && plan_.improvements >= 0)) {
    throw BadInput("the feed's clearance, retry time and number of positions must be > 0, its improvements >= 0");
  }
  if (plan_.initial > 0 && !charge_)
    throw BadInput("the feed has an initial mass but no region for it; give the region of the charge");
  if ((plan_.batch > 0 || plan_.rate > 0) && !entry_) {
    throw BadInput("the feed has a batch or a rate but no region where it enters; give the entry region");
  }
  // The mass fed is within half a rock of the mass owed, so less than half of the lightest rock would feed none.
  const double minimum = *std::min_element(masses_.begin(), masses_.end()) / 2;
  for (const double mass : {plan_.initial, plan_.batch}) {
    if (mass > 0 && mass <= minimum)
      throw BadInput("a feed of " + std::to_string(mass) + " kg is less than half of the lightest rock, " +
                     std::to_string(2 * minimum) + " kg; use a larger mass or smaller rocks");
  }
  if (plan_.initial > 0) check_fits("a particle", *charge_, 2 * largest_radius_);
  if (!entry_) return;
  // A rock that never fits would wait indefinitely and block all that follow.
  for (const RockTemplate& rock : library_.rocks) check_fits("a rock", *entry_, 2 * rock.bounding_radius);
}

double Feed::fed_mass() const {
  double mass = 0;
  for (std::size_t k = 0; k < masses_.size(); ++k) mass += static_cast<double>(state_.of_template[k]) * masses_[k];
  return mass;
}

Index Feed::next_kind() const {
  const auto number = static_cast<std::uint64_t>(plan_.first_rock + state_.rocks);
  const double u = uniform(plan_.seed, Stream::size, number, 0);
  const auto kind = std::lower_bound(cumulative_.begin(), cumulative_.end() - 1, u);
  return static_cast<Index>(kind - cumulative_.begin());
}

double Feed::owed(double time) const {
  return time >= plan_.start ? plan_.batch + plan_.rate * (time - plan_.start) : 0;
}

FeedAccount Feed::account() const {
  FeedAccount a{state_.rocks, state_.particles, 0, fed_mass(), state_.delayed, state_.waiting};
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    a.bonds += state_.of_template[k] * static_cast<std::int64_t>(library_.rocks[k].bonds.size());
  }
  return a;
}

/// The spheres that a rock in the region can touch; all of them without a region.
Bed Feed::bed_of(const ParticleSnapshot& present, const FeedRegion* near) const {
  Bed bed;
  const BoxRegion box = near ? near->bounds() : BoxRegion{};
  for (std::size_t k = 0; k < present.size(); ++k) {
    const Vec3d& p = present.position[k];
    const double reach = present.radius[k] + plan_.clearance;
    if (near && (p.x + reach < box.low.x || p.x - reach > box.high.x || p.y + reach < box.low.y ||
                 p.y - reach > box.high.y || p.z + reach < box.low.z || p.z - reach > box.high.z)) {
      continue;
    }
    bed.add(p, present.radius[k]);
  }
  return bed;
}

NewRock Feed::instance(Index kind, const RockPose& pose, Bed& bed) {
  const RockTemplate& rock = library_.rocks[static_cast<std::size_t>(kind)];
  NewRock made;
  made.id = plan_.first_rock + static_cast<RockId>(state_.rocks);
  const auto first = static_cast<ParticleId>(plan_.first_particle + state_.particles);
  made.particles.reserve(rock.centres.size());
  made.bonds.reserve(rock.bonds.size());
  for (std::size_t k = 0; k < rock.centres.size(); ++k) {
    const Vec3d centre = pose.position + rotate(pose.orientation, rock.centres[k]);
    const auto id = first + static_cast<ParticleId>(k);
    made.particles.push_back({id, centre, {0, 0, 0}, {0, 0, 0}, rock.radii[k], rock.particle_density});
    bed.add(centre, rock.radii[k]);
  }
  for (const TemplateBond& b : rock.bonds) {
    const auto i = first + static_cast<ParticleId>(b.i), j = first + static_cast<ParticleId>(b.j);
    made.bonds.push_back({b.i, b.j, b.length, b.radius, strength_ ? strength_(made.id, i, j) : 1.0});
  }
  made.colour_begin = rock.colour_begin;
  made.substeps = rock.substeps;
  made.load_table = rock.load_table;
  made.orientation = pose.orientation;
  ++state_.of_template[static_cast<std::size_t>(kind)];
  ++state_.rocks;
  state_.particles += static_cast<std::int64_t>(rock.centres.size());
  return made;
}

std::optional<NewRock> Feed::placed(const FeedRegion& region, Bed& bed, const Search& search) {
  const Index kind = next_kind();
  const Placement placement(region, walls_, bed, plan_.clearance);
  const std::optional<RockPose> pose = placement.lowest(library_.rocks[static_cast<std::size_t>(kind)], search);
  if (!pose) return std::nullopt;
  return instance(kind, *pose, bed);
}

void Feed::check_fixed(const FixedRock& fixed, const Bed& bed) const {
  if (fixed.rock < 0 || static_cast<std::size_t>(fixed.rock) >= library_.rocks.size()) {
    throw BadInput("a fixed rock is not in the library; its number must be between 0 and " +
                   std::to_string(library_.rocks.size() - 1));
  }
  const RockTemplate& rock = library_.rocks[static_cast<std::size_t>(fixed.rock)];
  for (std::size_t k = 0; k < rock.centres.size(); ++k) {
    const Vec3d centre = fixed.position + rotate(fixed.orientation, rock.centres[k]);
    // Contact is allowed: a rock may stand on a platen. The tolerance is for rounding of the input.
    const double radius = rock.radii[k] * (1 - 1e-9);
    if (bed.raised(centre, radius, 0) > centre.z) {
      throw BadInput("a fixed rock overlaps particles of the scene; move it");
    }
    if (walls_.distance(centre) < radius) {
      throw BadInput("a fixed rock overlaps a wall or lies behind it; move it in front of all walls");
    }
  }
}

std::vector<NewRock> Feed::initial(std::span<const WallPose> poses, const ParticleSnapshot& present) {
  walls_.move(poses);
  Bed bed = bed_of(present, nullptr);
  std::vector<NewRock> rocks;
  for (const FixedRock& fixed : plan_.fixed) {
    check_fixed(fixed, bed);
    rocks.push_back(instance(fixed.rock, {fixed.position, fixed.orientation}, bed));
  }
  if (plan_.initial > 0) charge(bed, rocks);
  state_.charged = fed_mass();
  return rocks;
}

void Feed::charge(Bed& bed, std::vector<NewRock>& rocks) {
  const double before = fed_mass();
  double top = charge_->low();
  BedSurface surface(charge_->bounds(), charge_->low(), 2 * largest_bounding_radius(library_));
  for (;;) {
    const Index kind = next_kind();
    const double charged = fed_mass() - before;
    if (charged + masses_[static_cast<std::size_t>(kind)] / 2 >= plan_.initial) return;
    const double reach = library_.rocks[static_cast<std::size_t>(kind)].bounding_radius;
    Search search{plan_.seed,
                  static_cast<std::uint64_t>(plan_.first_rock + state_.rocks),
                  plan_.positions,
                  plan_.improvements,
                  0,
                  std::min(top + 2 * reach, charge_->high()),
                  &surface};
    std::optional<NewRock> rock = placed(*charge_, bed, search);
    if (!rock) {
      search.positions *= 20;
      search.expected_top = charge_->high();
      search.surface = nullptr;  // room may be left deep below the surface
      rock = placed(*charge_, bed, search);
    }
    if (!rock) {
      throw BadInput("the initial charge of " + std::to_string(plan_.initial) + " kg does not fit below " +
                     std::to_string(charge_->high()) + " m (placed " + std::to_string(charged) +
                     " kg); use less mass or a higher limit");
    }
    for (const NewParticle& p : rock->particles) {
      top = std::max(top, p.position.z);
      surface.add(p.position, p.radius);
    }
    rocks.push_back(std::move(*rock));
  }
}

bool Feed::wants(double time) const {
  if (time < plan_.start || time < state_.next_try || !entry_) return false;
  return owed(time) - (fed_mass() - state_.charged) > masses_[static_cast<std::size_t>(next_kind())] / 2;
}

std::vector<NewRock> Feed::due(double time, std::span<const WallPose> poses, const ParticleSnapshot& present) {
  std::vector<NewRock> rocks;
  if (!wants(time)) return rocks;
  walls_.move(poses);
  Bed bed = bed_of(present, &*entry_);
  state_.waiting = 0;
  while (wants(time)) {
    const auto number = static_cast<std::uint64_t>(plan_.first_rock + state_.rocks);
    std::optional<NewRock> rock =
        placed(*entry_, bed, {plan_.seed, number, plan_.positions, 0, state_.attempts, entry_->high()});
    if (!rock) {
      if (state_.attempts++ == 0) ++state_.delayed;
      state_.waiting = owed(time) - (fed_mass() - state_.charged);
      state_.next_try = time + plan_.retry;
      break;
    }
    state_.attempts = 0;
    rocks.push_back(std::move(*rock));
  }
  return rocks;
}

}  // namespace gyro
