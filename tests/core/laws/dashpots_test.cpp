// SPDX-License-Identifier: GPL-3.0-or-later
// The cap on the dashpots of contacts.
#include "tests/catch.hpp"

#include "core/laws/contact/models.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace gyro;

namespace {

constexpr double hold = 20e-6;

double random_number(std::uint64_t k, std::uint64_t draw) {
  return uniform(7, Stream::shape, k, draw);
}

/// Spheres in contacts of random directions, with the dashpots that largest_dashpot() leaves.
struct Crowd {
  std::vector<double> mass, rate;
  struct Contact {
    std::size_t i, j;  ///< j = i: with a wall
    Vec3d normal;
    double c_n, c_t, own;
  };
  std::vector<Contact> contacts;

  explicit Crowd(std::size_t particles, std::size_t count) {
    for (std::size_t n = 0; n < particles; ++n) {
      mass.push_back(1e-3 * std::pow(10, 2 * random_number(n, 0)));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto pick = [&](std::uint64_t draw) {
        return static_cast<std::size_t>(random_number(k, draw) * static_cast<double>(particles));
      };
      Contact c{pick(1), pick(2), {}, 0, 0, 0};
      c.normal = unit({random_number(k, 3) - 0.5, random_number(k, 4) - 0.5, random_number(k, 5) - 0.5});
      c.c_n = 5e3 * random_number(k, 6);
      c.c_t = 5e3 * random_number(k, 7);
      c.own = std::max(c.c_n, 3.5 * c.c_t);
      contacts.push_back(c);
    }
    rate.assign(particles, 0);
    for (const Contact& c : contacts) {
      rate[c.i] += c.own / mass[c.i];
      if (c.j != c.i) rate[c.j] += c.own / mass[c.j];
    }
  }

  /// Whether H M^-1 C, with six degrees of freedom a sphere, has an eigenvalue above a limit.
  bool has_eigenvalue_above(double limit, double beta) const {
    std::vector<std::vector<double>> rest(6 * mass.size(), std::vector<double>(6 * mass.size(), 0));
    for (std::size_t n = 0; n < rest.size(); ++n) rest[n][n] = limit;
    for (const Contact& c : contacts) {
      const Vec3d t1 = unit(cross(c.normal, std::abs(c.normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
      const Vec3d t2 = cross(c.normal, t1);
      const double cap = capped(c, beta);
      subtract(rest, c, c.normal, std::min(c.c_n, cap));
      for (const Vec3d& t : {t1, t2}) subtract(rest, c, t, std::min(c.c_t, cap / spin_share));
    }
    return !is_positive(rest);
  }

 private:
  static Vec3d unit(const Vec3d& v) { return (1 / norm(v)) * v; }

  double capped(const Contact& c, double beta) const {
    ContactConstants<double> law{};
    law.max_rate = beta / hold;
    ContactMotion<double> motion{};
    const bool wall = c.j == c.i;
    motion.mass = wall ? mass[c.i] : mass[c.i] * mass[c.j] / (mass[c.i] + mass[c.j]);
    motion.damping_rate = rate[c.i] + (wall ? 0 : rate[c.j]);
    return largest_dashpot(law, motion, c.own, c.own);
  }

  /// Subtracts H times one dashpot, scaled by the roots of masses and moments of inertia so that it is symmetric.
  void subtract(std::vector<std::vector<double>>& from, const Contact& c, const Vec3d& direction,
                double damping) const {
    std::vector<double> motion(from.size(), 0);
    const auto move = [&](std::size_t n, double sign) {
      const Vec3d shift = (sign / std::sqrt(mass[n])) * direction;
      const Vec3d spin = (1 / std::sqrt(0.4 * mass[n])) * cross(c.normal, direction);
      const std::array<double, 6> all{shift.x, shift.y, shift.z, spin.x, spin.y, spin.z};
      for (std::size_t k = 0; k < 6; ++k) motion[6 * n + k] += all[k];
    };
    move(c.i, 1);
    if (c.j != c.i) move(c.j, -1);
    for (std::size_t a = 0; a < motion.size(); ++a)
      for (std::size_t b = 0; b < motion.size(); ++b) from[a][b] -= hold * damping * motion[a] * motion[b];
  }

  /// Whether a symmetric matrix has a Cholesky factor.
  static bool is_positive(std::vector<std::vector<double>> m) {
    for (std::size_t k = 0; k < m.size(); ++k) {
      if (!(m[k][k] > 0)) return false;
      for (std::size_t row = k + 1; row < m.size(); ++row) {
        const double factor = m[row][k] / m[k][k];
        for (std::size_t column = k; column < m.size(); ++column) m[row][column] -= factor * m[k][column];
      }
    }
    return true;
  }
};

}  // namespace

TEST_CASE("Capped dashpots have no eigenvalue above beta, whatever touches whatever", "[contact][dashpots]") {
  for (const std::size_t count : {1u, 5u, 40u, 200u}) {
    const Crowd crowd(12, count);
    INFO(count << " contacts");
    REQUIRE(crowd.has_eigenvalue_above(2, 1e9));  // explicit dashpots would add energy
    for (const double beta : {1.0, 0.5}) CHECK_FALSE(crowd.has_eigenvalue_above(beta * (1 + 1e-9), beta));
    CHECK(crowd.has_eigenvalue_above(0.2, 1));  // and the cap leaves most of what is allowed
  }
}

TEST_CASE("A dashpot of which the step resolves the decay is not capped", "[contact][dashpots]") {
  ContactConstants<double> law{};
  law.max_rate = 1 / hold;
  ContactMotion<double> c{};
  c.mass = 2e-3;
  const double own = 0.9 * c.mass / hold;
  CHECK(largest_dashpot(law, c, own, 0.0) == Approx(c.mass / hold));  // alone, and new
  c.damping_rate = own / c.mass;
  CHECK(largest_dashpot(law, c, own, own) == Approx(c.mass / hold));      // alone, and old
  CHECK(largest_dashpot(law, c, own, 0.0) == Approx(c.mass / hold / 2));  // beside an equal one
}

TEST_CASE("A capped contact damps less, and tells its whole dashpot", "[contact][dashpots]") {
  const Material rock{"rock", 2600, 557e6, 0.35};
  const double mass = 1e-3, radius = 5e-3, overlap = 1e-4;
  ContactMotion<double> c{};
  c.normal = {0, 0, 1};
  c.overlap = overlap;
  c.velocity = {0.1, 0, 0.05};
  c.radius = radius / 2;
  c.mass = mass / 2;
  ExtraHistory<double> none{};
  const ContactHistory<double> history{{0, 0, 0}, overlap, {0, 0, 0}};
  using Law = ContactLaw<Hertz, NoRolling>;
  const PairProperties pair{.friction = 1e9, .restitution = 0.2, .rolling_friction = 0};

  const auto fine = contact_constants<double>(rock, rock, pair, 1e-9),
             coarse = contact_constants<double>(rock, rock, pair, 1e-3);
  const ContactLoad<double> free = Law::load(fine, c, history, none);
  CHECK(free.dashpot > 0);
  c.damping_rate = free.dashpot / c.mass;
  const ContactLoad<double> capped = Law::load(coarse, c, history, none);
  CHECK(capped.dashpot == free.dashpot);
  // c_n = m*/H
  const double spring = 2.0 / 3 * 2 * fine.youngs * std::sqrt(c.radius * overlap) * overlap;
  CHECK(-capped.force.z == Approx(spring + c.mass / coarse.dt * c.velocity.z).epsilon(1e-9));
  CHECK(-free.force.z > -capped.force.z);
  CHECK(capped.history.drag.x == Approx(-c.mass / coarse.dt / 3.5 * c.velocity.x).epsilon(1e-9));

  // q is the larger of c_n and 3.5 c_t, c = 2 sqrt(5/6) zeta sqrt(S m*).
  const double root = std::sqrt(c.radius * overlap);
  const auto dashpot = [&](double stiffness) {
    return 2 * std::sqrt(5.0 / 6) * fine.damping * std::sqrt(stiffness * c.mass);
  };
  CHECK(free.dashpot == Approx(std::max(dashpot(2 * fine.youngs * root), 3.5 * dashpot(8 * fine.shear * root))));

  // At a sixteenth of the overlap q was half as large: the sum of the last step is brought up to now.
  const ContactHistory<double> shallow{{0, 0, 0}, overlap / 16, {0, 0, 0}};
  c.damping_rate = 0.5 * free.dashpot / c.mass;
  CHECK(Law::load(coarse, c, shallow, none).force.z == Approx(capped.force.z).epsilon(1e-9));
}
