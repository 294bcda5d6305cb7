// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/bonded.hpp"

#include "core/math/random.hpp"

#include <cmath>
#include <complex>

namespace gyro::verify {
namespace {

/// Amplitude of a frequency under a Hann window.
double amplitude(const Signal& s, double middle, double frequency) {
  std::complex<double> sum = 0;
  const double n = static_cast<double>(s.x.size());
  for (std::size_t k = 0; k < s.x.size(); ++k) {
    const double at = static_cast<double>(k);
    sum += (s.x[k] - middle) * (1 - std::cos(2 * pi * (at + 0.5) / n)) *
           std::polar(1.0, -2 * pi * std::fmod(frequency * s.dt * at, 1.0));
  }
  return std::abs(sum);
}

}  // namespace

BondParameters paper_bonds() {
  BondParameters bonds;
  bonds.normal_stiffness = 1.67e12;
  bonds.shear_stiffness = 6.67e11;
  bonds.tensile_strength = 36e6;
  bonds.shear_strength = 24e6;
  return bonds;
}

BondStiffness::BondStiffness(const BondParameters& bonds, double radius) {
  const double area = pi * radius * radius;
  normal = bonds.normal_stiffness * area;
  shear = bonds.shear_stiffness * area;
  bending = normal * radius * radius / 4;
  torsion = shear * radius * radius / 2;
}

Scene bonded_scene(double dt, const BondParameters& bonds, const PairProperties& pair) {
  Scene scene = scene_of(elastic(1.5e9, 0.35, rock_density), elastic(182e9, 0.3, 7800), pair, dt);
  scene.bonds = bonds;
  return scene;
}

NewRock chain(RockId id, int n, bool clamped, ParticleId first) {
  NewRock rock;
  rock.id = id;
  for (int k = 0; k <= n; ++k)
    rock.particles.push_back({first + static_cast<ParticleId>(k),
                              {k * grain, 0, 0},
                              {0, 0, 0},
                              {0, 0, 0},
                              grain / 2,
                              clamped && k == 0 ? immovable : rock_density});
  rock.colour_begin = {0};
  for (int odd = 0; odd < 2; ++odd) {
    for (int k = odd; k < n; k += 2) rock.bonds.push_back({k, k + 1, grain, bond_radius, 1});
    rock.colour_begin.push_back(static_cast<Index>(rock.bonds.size()));
  }
  return rock;
}

NewRock lattice(RockId id, int n, double section, ParticleId first) {
  NewRock rock;
  rock.id = id;
  const double middle = 0.5 * (n - 1);
  const int stride[3] = {1, n, n * n};
  for (int p = 0; p < n * n * n; ++p)
    rock.particles.push_back({first + static_cast<ParticleId>(p),
                              {grain * (p % n - middle), grain * (p / n % n - middle), grain * (p / n / n - middle)},
                              {0, 0, 0},
                              {0, 0, 0},
                              grain / 2,
                              rock_density});
  // Bonds along one axis that start at even (odd) places share no particle: six colours.
  rock.colour_begin = {0};
  for (int axis = 0; axis < 3; ++axis)
    for (int odd = 0; odd < 2; ++odd) {
      for (int p = 0; p < n * n * n; ++p) {
        const int along = p / stride[axis] % n;
        if (along % 2 == odd && along + 1 < n) rock.bonds.push_back({p, p + stride[axis], grain, section, 1});
      }
      rock.colour_begin.push_back(static_cast<Index>(rock.bonds.size()));
    }
  return rock;
}

void scatter_strength(NewRock& rock) {
  for (std::size_t b = 0; b < rock.bonds.size(); ++b) rock.bonds[b].strength = 1 + 0.6 * random_number(b, 100);
}

double random_number(std::uint64_t thing, std::uint32_t draw) {
  return 2 * uniform(11, Stream::place, thing, draw) - 1;
}

Quatd rotation_by(const Vec3d& rotation) {
  const double angle = norm(rotation);
  if (angle == 0) return {1, 0, 0, 0};
  const Vec3d v = (std::sin(angle / 2) / angle) * rotation;
  return {std::cos(angle / 2), v.x, v.y, v.z};
}

NewRock placed(NewRock rock, RockId id, ParticleId first, const Vec3d& to, const Quatd& orientation) {
  rock.id = id;
  for (NewParticle& p : rock.particles) {
    p.id += first;
    p.position = to + rotate(orientation, p.position);
    p.velocity = rotate(orientation, p.velocity);
    p.angular_velocity = rotate(orientation, p.angular_velocity);
  }
  return rock;
}

void add_rigid_motion(NewRock& rock, const Vec3d& velocity, const Vec3d& angular_velocity) {
  for (NewParticle& p : rock.particles) {
    p.velocity += velocity + cross(angular_velocity, p.position);
    p.angular_velocity += angular_velocity;
  }
}

Vec3d angular_momentum(const ParticleSnapshot& s) {
  Vec3d sum{0, 0, 0};
  for (std::size_t k = 0; k < s.size(); ++k)
    sum += s.mass[k] * cross(s.position[k], s.velocity[k]) +
           (0.4 * s.mass[k] * s.radius[k] * s.radius[k]) * s.angular_velocity[k];
  return sum;
}

double Signal::mean() const {
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double weight = std::pow(std::sin(pi * (static_cast<double>(k) + 0.5) / static_cast<double>(x.size())), 16);
    sum += weight * x[k];
    weights += weight;
  }
  return sum / weights;
}

double Signal::line_near(double guess) const {
  const double middle = mean(), reach = 1.5 / (dt * static_cast<double>(x.size()));
  double low = guess - reach, high = guess + reach;
  for (int k = 0; k < 40; ++k) {
    const double a = high - 0.618034 * (high - low), b = low + 0.618034 * (high - low);
    if (amplitude(*this, middle, a) < amplitude(*this, middle, b))
      low = a;
    else
      high = b;
  }
  return (low + high) / 2;
}

}  // namespace gyro::verify
