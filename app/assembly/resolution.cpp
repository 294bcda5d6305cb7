// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/resolution.hpp"

#include "core/fragments/fragment_table.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace gyro {
namespace {

/// Widens the resolution by a particle.
void add(std::optional<Resolution>& sizes, double radius, double density, double rock_density) {
  const double mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  const double size = equal_mass_diameter(mass, rock_density);
  if (!sizes) sizes = Resolution{size, size};
  sizes->coarsest = std::max(sizes->coarsest, size);
  sizes->finest = std::min(sizes->finest, size);
}

/// Whether the feed makes rocks of a template.
bool is_fed(const FeedPlan& feed, std::size_t rock) {
  return feed.initial > 0 || feed.batch > 0 || feed.rate > 0 ||
         std::ranges::any_of(feed.fixed, [&](const FixedRock& f) { return f.rock == static_cast<Index>(rock); });
}

}  // namespace

std::optional<Resolution> resolution_of(const Setup& setup) {
  if (!setup.scene.bonds) return std::nullopt;
  const double rock_density = setup.scene.materials[static_cast<std::size_t>(setup.scene.rock_material)].density;
  std::optional<Resolution> sizes;
  for (std::size_t k = 0; setup.feed && k < setup.library.rocks.size(); ++k) {
    const RockTemplate& rock = setup.library.rocks[k];
    if (rock.bonds.empty() || !is_fed(*setup.feed, k)) continue;
    for (const double radius : rock.radii) add(sizes, radius, rock.particle_density, rock_density);
  }
  for (const NewRock& rock : setup.start)
    if (!rock.bonds.empty())
      for (const NewParticle& p : rock.particles) add(sizes, p.radius, p.density, rock_density);
  return sizes;
}

std::string to_string(const Resolution& resolution) {
  char text[60];
  if (resolution.coarsest > 1.001 * resolution.finest)
    std::snprintf(text, sizeof text, "%.3g to %.3g mm", resolution.finest * 1e3, resolution.coarsest * 1e3);
  else
    std::snprintf(text, sizeof text, "%.3g mm", resolution.coarsest * 1e3);
  return text;
}

}  // namespace gyro
