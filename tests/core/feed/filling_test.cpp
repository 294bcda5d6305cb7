// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces for the fragments of another run, and their places in a chamber.
#include "core/feed/filling.hpp"

#include "core/rocks/bonds.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <map>
#include <numeric>

using namespace gyro;

namespace {

double mass_of(const NewRock& rock) {
  double mass = 0;
  for (const NewParticle& p : rock.particles)
    mass += p.density * 4.0 / 3.0 * std::numbers::pi * p.radius * p.radius * p.radius;
  return mass;
}

/// Balls whose neighbours are bonded.
RockLibrary library_of(std::initializer_list<double> diameters, double ratio) {
  RockLibrary library;
  for (const double diameter : diameters) {
    RockTemplate rock = ball_rock(diameter, ratio);
    rock.bonds = make_bonds(rock.centres, rock.radii, {.gap = 0.1, .radius = RelativeBondRadius{0.5}});
    rock.colour_begin = colour_bonds(rock.bonds, static_cast<Index>(rock.centres.size()));
    library.rocks.push_back(std::move(rock));
  }
  return library;
}

/// Height below which a share of the mass of points lies.
double height_of(std::vector<std::pair<double, double>> by_height, double share) {
  std::ranges::sort(by_height);
  double all = 0, below = 0;
  for (const auto& [z, mass] : by_height) all += mass;
  for (const auto& [z, mass] : by_height)
    if ((below += mass) >= share * all) return z;
  return by_height.back().first;
}

/// The hold-up of a charge that lies in the chamber: every third rock whole, the others in parts or crumbled.
std::vector<SourceFragment> source(double mass, std::uint64_t seed) {
  const RockLibrary library = library_of({0.18, 0.22, 0.27}, 4);
  FeedPlan plan;
  plan.initial = mass;
  plan.charge = ChamberRegion{0, 1, 0.0, 3.2};
  plan.seed = seed;
  const std::vector<Wall> walls = chamber_walls();
  std::vector<SourceFragment> found;
  for (const NewRock& rock : Feed(library, plan, walls).initial(std::vector<WallPose>(2))) {
    const std::size_t count = rock.particles.size(), part = rock.id % 3 == 0 ? count : rock.id % 3 == 1 ? 8 : 1;
    for (std::size_t k = 0; k < count; k += part) {
      SourceFragment f{{0, 0, 0}, 0, 0, part == 1, part == count};
      double volume = 0;
      for (std::size_t n = k; n < std::min(k + part, count); ++n) {
        const NewParticle& p = rock.particles[n];
        const double r3 = std::pow(p.radius, 3), m = p.density * 4.0 / 3.0 * std::numbers::pi * r3;
        f.centre = f.centre + m * p.position;
        f.mass += m;
        volume += r3;
      }
      f.centre = (1 / f.mass) * f.centre;
      f.radius = std::cbrt(volume);
      f.single = f.single || k + 1 == count;
      found.push_back(f);
    }
  }
  return found;
}

double sum_of(const std::vector<SourceFragment>& fragments) {
  double mass = 0;
  for (const SourceFragment& f : fragments) mass += f.mass;
  return mass;
}

ChamberFilling filling_of(const RockLibrary& library, const std::vector<SourceFragment>& fragments,
                          std::uint64_t seed = 5) {
  ChamberFilling filling;
  filling.pieces = pieces_of(library, fragments, seed);
  filling.chamber = {0, 1, -0.1, 4};
  filling.seed = seed;
  return filling;
}

const std::vector<WallPose> rest(2);

}  // namespace

TEST_CASE("A piece is connected, has the wanted mass, and keeps the bonds between its particles", "[feed]") {
  const RockLibrary library = library_of({0.3}, 6);
  const double particle = library.rocks[0].particle_density * 4.0 / 3.0 * std::numbers::pi * std::pow(0.025, 3);
  std::vector<SourceFragment> fragments;
  for (int k = 0; k < 40; ++k) fragments.push_back({{0, 0, 0.1 * k}, (3.0 + k) * particle, 0.1});
  const std::vector<Piece> pieces = pieces_of(library, fragments, 1);
  REQUIRE(pieces.size() == fragments.size());
  std::vector<Index> seeds;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    CHECK(pieces[k].mass == Approx(fragments[k].mass).epsilon(1e-9));  // equal particles: exactly so many
    CHECK(pieces[k].particles.size() == k + 3);
    const RockTemplate part = template_of(library.rocks[0], pieces[k]);
    CHECK(largest_piece(part.bonds, static_cast<Index>(part.centres.size())).size() == part.centres.size());
    CHECK(static_cast<Index>(part.bonds.size()) == pieces[k].bonds);
    Vec3d centre{0, 0, 0};
    double reach = 0;
    for (std::size_t n = 0; n < part.centres.size(); ++n) {
      centre = centre + part.centres[n];
      reach = std::max(reach, norm(part.centres[n]) + part.radii[n]);
    }
    CHECK(norm(centre) < 1e-9);
    CHECK(part.bounding_radius == Approx(reach));
    for (const TemplateBond& b : part.bonds)
      CHECK(norm(part.centres[static_cast<std::size_t>(b.i)] - part.centres[static_cast<std::size_t>(b.j)]) ==
            Approx(b.length));
    seeds.push_back(pieces[k].particles.front());
  }
  std::ranges::sort(seeds);
  CHECK(std::unique(seeds.begin(), seeds.end()) - seeds.begin() > 5);  // not always the same part
}

TEST_CASE("Pieces have the masses of the fragments by height and by kind, whatever the size of particles", "[feed]") {
  const double ratio = GENERATE(3.0, 4.0, 7.0);  // coarser and finer than the source
  const RockLibrary library = library_of({0.2, 0.24}, ratio);
  const std::vector<SourceFragment> fragments = source(2000, 3);
  const std::vector<Piece> pieces = pieces_of(library, fragments, 9);
  double heaviest = 0;
  for (const RockTemplate& rock : library.rocks) heaviest = std::max(heaviest, 2600 * rock.solid_volume);
  for (double z = 0.2; z < 2; z += 0.2) {
    INFO(z);
    double wanted = 0, made = 0;
    for (const SourceFragment& f : fragments) wanted += f.centre.z < z ? f.mass : 0;
    for (const Piece& piece : pieces) made += piece.target.z < z ? piece.mass : 0;
    CHECK(std::abs(made - wanted) < 1.5 * heaviest);  // half a piece of each kind, and parts beside their centre
  }
  std::map<bool, double> wanted, made;
  for (const SourceFragment& f : fragments) wanted[f.single] += f.mass;
  for (const Piece& piece : pieces) made[piece.bonds == 0] += piece.mass;
  CHECK(made[true] == Approx(wanted[true]).epsilon(ratio < 4 ? 0.2 : 0.03));  // coarse: small parts are one particle
  CHECK(made[true] + made[false] == Approx(sum_of(fragments)).epsilon(0.01));
  std::size_t whole = 0;
  for (const Piece& piece : pieces) whole += piece.particles.empty() ? 1 : 0;
  const auto rocks = static_cast<std::size_t>(std::ranges::count_if(fragments, &SourceFragment::whole));
  CHECK((whole > rocks / 2 && whole < 2 * rocks));
}

TEST_CASE("A fragment heavier than all rocks becomes several, and one lighter than a particle is carried over",
          "[feed]") {
  const RockLibrary library = library_of({0.2}, 4);
  const double rock = 2600 * library.rocks[0].solid_volume,
               particle = rock / static_cast<double>(library.rocks[0].radii.size());
  const std::vector<SourceFragment> large{{{0, 0, 1}, 2.4 * rock, 0.2}};
  const std::vector<Piece> parts = pieces_of(library, large, 1);
  REQUIRE(parts.size() == 3);
  CHECK((parts[0].particles.empty() && parts[1].particles.empty()));
  CHECK(parts[2].mass == Approx(0.4 * rock).margin(particle));
  std::vector<SourceFragment> dust;
  for (int k = 0; k < 1000; ++k) dust.push_back({{0, 0, 0.001 * k}, 0.013 * particle, 0.001, true});
  const std::vector<Piece> grains = pieces_of(library, dust, 1);
  CHECK(grains.size() == 13);
  for (std::size_t k = 0; k < grains.size(); ++k) CHECK(grains[k].target.z == Approx((k + 0.5) / 13).margin(0.002));
}

TEST_CASE("Single particles are drawn as crumbled rock gives them", "[feed]") {
  RockLibrary library;  // two rocks of equal weight in the feed: of 1 and of 8 particles
  library.rocks.push_back(sphere_rock(0.05));
  library.rocks.push_back(library_of({0.1}, 2.2).rocks[0]);
  std::vector<SourceFragment> fragments;
  for (int k = 0; k < 4000; ++k) fragments.push_back({{0, 0, 1e-3 * k}, 0.4, 0.03, true});
  double of_first = 0, all = 0;
  for (const Piece& piece : pieces_of(library, fragments, 4)) {
    all += piece.mass;
    if (piece.rock == 0) of_first += piece.mass;
  }
  CHECK(all == Approx(1600).epsilon(1e-3));
  CHECK(of_first / all == Approx(0.5).margin(0.05));
}

TEST_CASE("Pieces lie near their fragments, free of overlap between the liners", "[feed]") {
  const double ratio = GENERATE(3.0, 5.0);
  const RockLibrary library = library_of({0.17, 0.21, 0.25}, ratio);
  const std::vector<SourceFragment> fragments = source(2500, 3);
  const ChamberFilling filling = filling_of(library, fragments);
  const std::vector<Wall> walls = chamber_walls();
  const Filled filled = fill(library, filling, walls, rest);
  CHECK(filled.lost == 0);
  CHECK(smallest_gap(filled.rocks) >= 1e-4 * (1 - 1e-6));
  double mass = 0, wall_gap = 1;
  WallSet set(walls, 0.1, 1e-4);
  set.move(rest);
  std::vector<std::pair<double, double>> wanted, found;
  std::vector<ParticleId> ids;
  for (const NewRock& rock : filled.rocks) {
    mass += mass_of(rock);
    CHECK((rock.id == none) == (rock.particles.size() == 1));
    double z = 0;
    for (const NewParticle& p : rock.particles) {
      wall_gap = std::min(wall_gap, set.distance(p.position) - p.radius);
      z += p.position.z / static_cast<double>(rock.particles.size());
      ids.push_back(p.id);
    }
    found.emplace_back(z, mass_of(rock));
  }
  for (const SourceFragment& f : fragments) wanted.emplace_back(f.centre.z, f.mass);
  CHECK(wall_gap >= 1e-4 * (1 - 1e-6));
  CHECK(filled.mass == Approx(mass).epsilon(1e-9));
  CHECK(mass == Approx(sum_of(fragments)).epsilon(0.01));
  CHECK((std::ranges::is_sorted(ids) && std::ranges::adjacent_find(ids) == ids.end()));
  // Heights below which tenths of the mass lie: within 3 cm, an eighth of the largest rock.
  for (double share = 0.1; share < 0.95; share += 0.1) {
    INFO(share);
    CHECK(height_of(found, share) == Approx(height_of(wanted, share)).margin(0.03));
  }
  INFO(filled.rise << " " << filled.shift);
  CHECK(std::abs(filled.rise) < 0.025);
  CHECK(filled.shift < 0.06);
}

TEST_CASE("The seed decides all draws of a filling, whose pieces move with their fragments", "[feed]") {
  const RockLibrary library = library_of({0.2}, 4);
  std::vector<SourceFragment> fragments = source(600, 3);
  for (SourceFragment& f : fragments) f.velocity = {0, 1, -f.centre.z};
  const auto first_of = [&](std::uint64_t seed) {
    const Filled filled = fill(library, filling_of(library, fragments, seed), chamber_walls(), rest);
    std::vector<double> heights;
    for (const NewRock& rock : filled.rocks) {
      heights.push_back(rock.particles[0].position.z);
      for (const NewParticle& p : rock.particles) {
        CHECK(p.velocity.y == 1);
        CHECK(p.velocity.z == rock.particles[0].velocity.z);
      }
      CHECK(rock.particles[0].velocity.z < 0);
    }
    return heights;
  };
  CHECK(first_of(5) == first_of(5));
  CHECK(first_of(5) != first_of(6));
}

TEST_CASE("What finds no room lies above, and is lost where there is none", "[feed]") {
  const RockLibrary library = library_of({0.2}, 3);
  std::vector<SourceFragment> fragments;  // all at one point
  const double rock = 2600 * library.rocks[0].solid_volume;
  for (int k = 0; k < 400; ++k) fragments.push_back({{1.0, 0, 0.3}, rock, 0.1, false, true});
  ChamberFilling filling = filling_of(library, fragments);
  filling.chamber.high = 1.2;
  const Filled filled = fill(library, filling, chamber_walls(), rest);
  CHECK(filled.rise > 0.1);
  CHECK((filled.lost > 0 && filled.lost < 400));
  CHECK(filled.lost_mass == Approx(static_cast<double>(filled.lost) * filling.pieces[0].mass));
  CHECK(filled.mass + filled.lost_mass == Approx(counts_of(filling, library).mass));
  CHECK(smallest_gap(filled.rocks) >= 1e-4 * (1 - 1e-6));
}
