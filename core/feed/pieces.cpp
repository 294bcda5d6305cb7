// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/pieces.hpp"

#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace gyro {
namespace {

/// Draws of Stream::size for one number: the feed takes the first for the kind of a rock.
enum Draw : std::uint32_t { draw_rock = 1, draw_particle, draw_single_rock, draw_single, draw_spread };

double mass_of(const RockTemplate& rock, std::size_t particle) {
  const double r = rock.radii[particle];
  return rock.particle_density * 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

/// A rock of the library with what is needed to cut it.
struct Source {
  const RockTemplate* rock;
  double mass = 0;                         ///< [kg]
  std::vector<std::vector<Index>> bonded;  ///< partners of each particle

  explicit Source(const RockTemplate& t) : rock(&t), bonded(t.centres.size()) {
    for (std::size_t k = 0; k < t.centres.size(); ++k) mass += mass_of(t, k);
    for (const TemplateBond& b : t.bonds) {
      bonded[static_cast<std::size_t>(b.i)].push_back(b.j);
      bonded[static_cast<std::size_t>(b.j)].push_back(b.i);
    }
  }
};

/// The particles that grow from one of them, nearest first, until the mass is as near to the wanted one as it gets.
std::vector<Index> grown(const Source& source, Index from, double wanted) {
  const RockTemplate& rock = *source.rock;
  const auto at = [](auto& v, Index k) -> auto& {
    return v[static_cast<std::size_t>(k)];
  };
  std::vector<char> seen(rock.centres.size(), 0);
  std::set<std::pair<double, Index>> edge{{0.0, from}};  // by the square of the distance
  at(seen, from) = 1;
  std::vector<Index> taken;
  double mass = 0;
  while (!edge.empty()) {
    const Index next = edge.begin()->second;
    const double more = mass_of(rock, static_cast<std::size_t>(next));
    if (!taken.empty() && mass + more / 2 > wanted) break;
    edge.erase(edge.begin());
    taken.push_back(next);
    mass += more;
    for (const Index other : at(source.bonded, next)) {
      if (at(seen, other)) continue;
      at(seen, other) = 1;
      edge.insert({norm2(at(rock.centres, other) - at(rock.centres, from)), other});
    }
  }
  std::ranges::sort(taken);
  return taken;
}

/// Cuts pieces and carries over what they are too heavy or too light.
class Cutter {
 public:
  Cutter(const RockLibrary& library, std::uint64_t seed, std::uint64_t first) : seed_(seed), first_(first) {
    for (const RockTemplate& rock : library.rocks) {
      rocks_.emplace_back(rock);
      const auto particles = static_cast<double>(rock.centres.size());
      // Equal masses of all rocks give particles in proportion to particles / mass of the rock.
      crumbled_.push_back((crumbled_.empty() ? 0 : crumbled_.back()) + particles / rocks_.back().mass);
      mean_single_ += rocks_.back().mass / particles / static_cast<double>(library.rocks.size());
      lightest_ = std::min(lightest_, rocks_.back().mass);
      heaviest_ = std::max(heaviest_, rocks_.back().mass);
      for (std::size_t k = 0; k < rock.radii.size(); ++k)
        heaviest_single_ = std::max(heaviest_single_, mass_of(rock, k));
    }
    for (double& share : crumbled_) share /= crumbled_.back();
  }

  void add(const SourceFragment& fragment) { fragment.single ? add_singles(fragment) : add_pieces(fragment); }
  std::vector<Piece> pieces() && { return std::move(pieces_); }

 private:
  double draw(std::uint64_t thing, std::uint32_t number) const { return uniform(seed_, Stream::size, thing, number); }
  std::uint64_t number() const { return first_ + pieces_.size(); }
  static std::size_t pick(double u, std::size_t count) {
    return std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
  }

  void add_singles(const SourceFragment& fragment) {
    owed_singles_ += fragment.mass;
    for (;;) {
      // Keyed by the count of singles: the next one waits for its mass and is not drawn again.
      const double u = draw(first_ + singles_, draw_single_rock);
      const auto share = std::lower_bound(crumbled_.begin(), crumbled_.end() - 1, u);
      const auto kind = static_cast<std::size_t>(share - crumbled_.begin());
      const RockTemplate& rock = *rocks_[kind].rock;
      const std::size_t particle = pick(draw(first_ + singles_, draw_single), rock.centres.size());
      const double mass = mass_of(rock, particle);
      if (owed_singles_ < mass / 2) return;
      owed_singles_ -= mass;
      ++singles_;
      const double room = std::max(0.0, fragment.radius - rock.radii[particle]);  // of a larger one it replaces
      pieces_.push_back({static_cast<Index>(kind),
                         rock.centres.size() == 1 ? std::vector<Index>{} : std::vector{static_cast<Index>(particle)},
                         fragment.centre + room * in_ball(number()), mass, 0, fragment.velocity});
    }
  }

  /// A random point of the unit ball.
  Vec3d in_ball(std::uint64_t thing) const {
    const double z = 2 * draw(thing, draw_spread) - 1, t = 2 * std::numbers::pi * draw(thing, draw_spread + 1),
                 r = std::cbrt(draw(thing, draw_spread + 2)), s = std::sqrt(1 - z * z);
    return r * Vec3d{s * std::cos(t), s * std::sin(t), z};
  }

  void add_pieces(const SourceFragment& fragment) {
    double& owed = fragment.whole ? owed_rocks_ : owed_parts_;
    const double least = fragment.whole ? lightest_ / 2 : mean_single_ / 2,
                 rest = fragment.whole ? lightest_ / 2 : heaviest_single_ / 2;
    owed += fragment.mass;
    if (owed < least) return;
    Vec3d target = fragment.centre;
    do {
      Piece piece = fragment.whole ? whole_rock(owed) : part(owed);
      const RockTemplate& rock = *rocks_[static_cast<std::size_t>(piece.rock)].rock;
      for (const TemplateBond& b : rock.bonds) piece.bonds += has(piece, b.i) && has(piece, b.j) ? 1 : 0;
      piece.target = target;
      piece.velocity = fragment.velocity;
      owed -= piece.mass;
      target = fragment.centre + fragment.radius * in_ball(number());
      pieces_.push_back(std::move(piece));
    } while (owed > rest);  // of a fragment that is heavier than the heaviest rock
  }

  static bool has(const Piece& piece, Index particle) {
    return piece.particles.empty() || std::ranges::binary_search(piece.particles, particle);
  }

  Piece whole_rock(double mass) const {
    const auto nearest =
        std::ranges::min_element(rocks_, {}, [&](const Source& source) { return std::abs(source.mass - mass); });
    return {.rock = static_cast<Index>(nearest - rocks_.begin()), .mass = nearest->mass};
  }

  Piece part(double wanted) const {
    std::vector<std::size_t> heavy;  // enough; each stands for the same share of the feed's mass
    for (std::size_t k = 0; k < rocks_.size(); ++k)
      if (rocks_[k].mass >= std::min(wanted, heaviest_)) heavy.push_back(k);
    const std::size_t kind = heavy[pick(draw(number(), draw_rock), heavy.size())];
    const Source& source = rocks_[kind];
    const std::size_t count = source.rock->centres.size();
    Piece piece{.rock = static_cast<Index>(kind), .particles = grown(source, start(*source.rock, wanted), wanted)};
    for (const Index k : piece.particles) piece.mass += mass_of(*source.rock, static_cast<std::size_t>(k));
    if (piece.particles.size() == count) piece.particles.clear();
    return piece;
  }

  /// A random particle that is not much heavier than the piece; the lightest where all are.
  Index start(const RockTemplate& rock, double wanted) const {
    std::vector<Index> light;
    std::size_t lightest = 0;
    for (std::size_t k = 0; k < rock.radii.size(); ++k) {
      if (mass_of(rock, k) / 2 <= wanted) light.push_back(static_cast<Index>(k));
      if (rock.radii[k] < rock.radii[lightest]) lightest = k;
    }
    return light.empty() ? static_cast<Index>(lightest) : light[pick(draw(number(), draw_particle), light.size())];
  }

  std::uint64_t seed_, first_, singles_ = 0;
  std::vector<Source> rocks_;
  std::vector<double> crumbled_;  ///< share of the numbers of particles up to each rock, ends with 1
  double mean_single_ = 0;        ///< of the rocks [kg]
  double heaviest_single_ = 0;    ///< [kg]
  double lightest_ = std::numeric_limits<double>::infinity(), heaviest_ = 0;  ///< of the rocks [kg]
  double owed_rocks_ = 0, owed_parts_ = 0, owed_singles_ = 0;                 ///< carried over [kg]
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> pieces_of(const RockLibrary& library, std::span<const SourceFragment> fragments, std::uint64_t seed,
                             std::uint64_t first) {
  std::vector<std::size_t> order(fragments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return fragments[k].centre.z; });
  Cutter cutter(library, seed, first);
  for (const std::size_t k : order) cutter.add(fragments[k]);
  return std::move(cutter).pieces();
}

RockTemplate template_of(const RockTemplate& rock, const Piece& piece) {
  if (piece.particles.empty()) return rock;
  RockTemplate part;
  part.name = rock.name;
  part.particle_density = rock.particle_density;
  part.substeps = rock.substeps;  // with fewer bonds the limit of the step is higher
  std::vector<Index> place(rock.centres.size(), none);
  Vec3d centre{0, 0, 0};
  for (const Index k : piece.particles) {
    const auto n = static_cast<std::size_t>(k);
    place[n] = static_cast<Index>(part.centres.size());
    part.centres.push_back(rock.centres[n]);
    part.radii.push_back(rock.radii[n]);
    centre = centre + (mass_of(rock, n) / piece.mass) * rock.centres[n];
  }
  for (std::size_t k = 0; k < part.centres.size(); ++k) {
    part.centres[k] = part.centres[k] - centre;
    part.bounding_radius = std::max(part.bounding_radius, norm(part.centres[k]) + part.radii[k]);
  }
  part.colour_begin = {0};  // bonds keep their colours
  for (std::size_t c = 0; c + 1 < rock.colour_begin.size(); ++c) {
    for (Index n = rock.colour_begin[c]; n < rock.colour_begin[c + 1]; ++n) {
      const TemplateBond& b = rock.bonds[static_cast<std::size_t>(n)];
      const Index i = place[static_cast<std::size_t>(b.i)], j = place[static_cast<std::size_t>(b.j)];
      if (i != none && j != none) part.bonds.push_back({i, j, b.length, b.radius});
    }
    if (const auto end = static_cast<Index>(part.bonds.size()); end > part.colour_begin.back())
      part.colour_begin.push_back(end);
  }
  return part;
}

}  // namespace gyro
