// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/start_check.hpp"

#include "core/base/errors.hpp"
#include "core/feed/bed.hpp"
#include "core/feed/wall_distance.hpp"
#include "core/laws/contact/models.hpp"
#include "core/laws/contact/scene_contacts.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace gyro {
namespace {

/// Largest speed at which a contact of the start state may throw its two bodies apart [m/s]. Beds of rock that have
/// settled under one metre of the same rock stay below 0.1 m/s.
constexpr double max_speed = 0.2;

/// A contact of two bodies at rest: the energy of its normal spring becomes 1/2 m* v^2.
struct Contact {
  ContactModel model;
  ContactConstants<double> constants;
  double radius;   ///< R* [m]
  double mass;     ///< m* [kg]
  double overlap;  ///< [m]

  double speed_at(double depth) const {
    const ExtraHistory<double> fresh{};
    return std::sqrt(2 * contact_energy(model, constants, radius, depth, {{0, 0, 0}, depth, {0, 0, 0}}, &fresh) / mass);
  }
  double speed() const { return speed_at(overlap); }
  /// By bisection: the speed rises with the overlap.
  double max_overlap() const {
    double low = 0, high = overlap;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (speed_at(middle) > max_speed ? high : low) = middle;
    }
    return low;
  }
};

void expect_gentle(const Contact& contact, double smaller_radius, const std::string& bodies) {
  if (!(contact.speed() > max_speed)) return;
  std::ostringstream message;
  message.precision(3);
  message << bodies << " by " << contact.overlap * 1e3 << " mm, " << contact.overlap / smaller_radius
          << " of the radius, and would be thrown apart at " << contact.speed() << " m/s; an overlap of up to "
          << contact.max_overlap() * 1e3 << " mm is possible";
  throw BadInput(message.str());
}

/// A particle of the start state and where it comes from.
struct Placed {
  const NewParticle* particle;
  std::size_t rock;
  Index number;  ///< in its rock
};

/// Pairs of a rock that bonds join, as (smaller number, larger number), sorted.
std::vector<std::pair<Index, Index>> bonded_pairs(const NewRock& rock) {
  std::vector<std::pair<Index, Index>> pairs;
  pairs.reserve(rock.bonds.size());
  for (const NewBond& b : rock.bonds) pairs.emplace_back(std::min(b.i, b.j), std::max(b.i, b.j));
  std::ranges::sort(pairs);
  return pairs;
}

void check_pairs(const Scene& scene, std::span<const NewRock> rocks) {
  const ContactModel model = rock_model(scene);
  const auto constants = contact_constants<double>(scene, scene.rock_material, scene.rock_material);
  Bed bed;
  std::vector<Placed> placed;
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const auto bonded = bonded_pairs(rocks[r]);
    for (std::size_t k = 0; k < rocks[r].particles.size(); ++k) {
      const NewParticle& p = rocks[r].particles[k];
      const auto number = static_cast<Index>(k);
      for (const Index other : bed.overlapped(p.position, p.radius)) {
        const Placed& q = placed[static_cast<std::size_t>(other)];
        if (q.rock == r && std::ranges::binary_search(bonded, std::pair(q.number, number))) continue;
        const double a = p.radius, b = q.particle->radius, m = mass_of(p), n = mass_of(*q.particle);
        const Contact contact{model, constants, a * b / (a + b), m * n / (m + n),
                              a + b - norm(p.position - q.particle->position)};
        expect_gentle(contact, std::min(a, b),
                      "particles " + std::to_string(q.particle->id) + " and " + std::to_string(p.id) + " overlap");
      }
      bed.add(p.position, p.radius);
      placed.push_back({&p, r, number});
    }
  }
}

void check_wall(const Scene& scene, const Wall& wall, std::span<const NewRock> rocks, double largest) {
  const WallDistance distance(wall, 2 * largest);
  const WallPose pose = pose_of(wall, 0, {});
  const ContactModel model = wall_model(scene);
  const auto constants = contact_constants<double>(scene, scene.rock_material, wall.material);
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles) {
      const double overlap = p.radius - distance.at(pose, p.position);
      if (overlap <= 0) continue;
      const std::string name = "particle " + std::to_string(p.id);
      if (overlap > p.radius)
        throw BadInput(name + " lies behind wall " + wall.name + "; move it in front of the wall");
      expect_gentle({model, constants, p.radius, mass_of(p), overlap}, p.radius, name + " overlaps wall " + wall.name);
    }
}

}  // namespace

void check_start(const Scene& scene, std::span<const NewRock> rocks) {
  double largest = 0;
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles) largest = std::max(largest, p.radius);
  if (!(largest > 0)) return;
  check_pairs(scene, rocks);
  for (const Wall& wall : scene.walls) check_wall(scene, wall, rocks, largest);
}

}  // namespace gyro
