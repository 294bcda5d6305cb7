// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/models.hpp"
#include "core/state/contacts.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// The particle whose contacts leave the step least room.
struct StiffestContacts {
  double share2 = 0;  ///< square of the step over the stability limit of what it touches [-]
  ParticleId particle = 0;
  std::int32_t count = 0;  ///< of its contacts

  GYRO_HD friend StiffestContacts operator+(const StiffestContacts& a, const StiffestContacts& b) {
    return a.share2 >= b.share2 ? a : b;
  }
};

/// Compares the step with the stability limit of what a particle touches, whose stiffnesses are added up as the choice
/// of the step assumes them of a bed: each averaged over directions, twice for a partner that moves in counterphase,
/// once for a wall; of translations and rotations the stiffer.
///
///   w^2 = (2 sum over partners + sum over walls) max((S_n + 2 S_t)/3, 2/3 S_t m R^2/I) / m
///   limit = sqrt(4 - 2 b)/w,  b = min(beta, 2 H Q/m)     H the step, beta and Q as in largest_dashpot()
///
/// A map for Exec::reduce. No kernel of the step depends on it.
template <class Real>
struct FindStiffestContacts {
  ConstParticleView p;
  ConstPairView<Real> pairs;
  ConstWallPairView<Real> near;
  ContactConstants<Real> rock;            ///< of rock against rock
  const ContactConstants<Real>* on_wall;  ///< of rock against each wall
  ContactModel rock_model, wall_model;
  double dt;           ///< step of the scene [s]
  double damping_cap;  ///< beta [-]

  GYRO_HD StiffestContacts operator()(Index n) const {
    double sum = 0;
    StiffestContacts s;
    s.particle = p.id[n];
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e) {
      const Index pair = pairs.ends[e].pair;
      if (!pairs.touching[pair]) continue;
      const double a = p.position[pairs.pair[pair].i].radius, b = p.position[pairs.pair[pair].j].radius;
      sum += 2 * stiffness(rock_model, rock, a * b / (a + b), pairs.history[pair]);
      ++s.count;
    }
    for (Index e = near.row_begin[n]; e < near.row_begin[n + 1]; ++e)
      for (int k = 0; near.touching[e] && k < near.history[e].count; ++k, ++s.count)
        sum += stiffness(wall_model, on_wall[near.entry[e].wall], p.position[n].radius,
                         near.history[e].contact[k].history);
    const double damped = smaller(damping_cap, 2 * dt * p.damping_rate[n]);
    s.share2 = dt * dt * sum / p.motion[n].mass / (4 - 2 * smaller(damped, 1.9));
    return s;
  }

 private:
  GYRO_HD static double stiffness(ContactModel model, const ContactConstants<Real>& law, double radius,
                                  const ContactHistory<Real>& history) {
    ContactConstants<double> constants{};
    constants.youngs = static_cast<double>(law.youngs);
    constants.shear = static_cast<double>(law.shear);
    constants.unloading = static_cast<double>(law.unloading);
    const ContactStiffness s = contact_stiffness(model, constants, radius, static_cast<double>(history.overlap));
    constexpr double spin = 2.5;  // m R^2/I of a sphere
    return larger(s.normal / s.margin + 2 * s.tangential, 2 * spin * s.tangential) / 3;
  }
};

}  // namespace gyro
