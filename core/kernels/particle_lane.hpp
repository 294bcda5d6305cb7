// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/particle_row.hpp"
#include "core/state/contacts.hpp"
#include "core/state/walls.hpp"

// Lanes: how the kernels of particles read and write their columns. OneParticle is one particle, for a GPU thread, for
// what does not fill a pack and for tests; PackOfParticles (particle_pack.hpp) is N neighbouring ones, for a CPU core.
// Both do the same arithmetic in the same order for every particle, so their results agree to the bit.

namespace gyro {

/// What acts on one particle or on each of a pack of them.
template <class T>
struct ForceAndTorque {
  Vec3<T> force, torque;
};

/// Loads of one particle, to which those of its contacts are added one after the other.
struct ContactSum {
  ForceAndTorque<double> load;
  double damped, slipped;  ///< what contacts have lost so far [J]
  double dashpots;         ///< of contacts [N s/m]

  GYRO_HD void take(const LostWork& lost) {
    damped = lost.contact_damping;
    slipped = lost.contact_slip;
  }
  GYRO_HD void give(LostWork& lost) const {
    lost.contact_damping = damped;
    lost.contact_slip = slipped;
  }
  /// @param touches   0: nothing is added
  /// @tparam Contact  EndLoad or WallResult
  template <class Contact, class Real>
  GYRO_HD void add(std::int8_t touches, const Contact& contact, const Real& dashpot) {
    if (!touches) return;
    load.force += cast<double>(contact.force);
    load.torque += cast<double>(contact.torque);
    damped += static_cast<double>(contact.damped);
    slipped += static_cast<double>(contact.slipped);
    dashpots += static_cast<double>(dashpot);
  }
};

/// One particle.
struct OneParticle {
  template <class T>
  using Number = T;
  static constexpr int count = 1;
  Index n;

  GYRO_HD double load(const double* column) const { return column[n]; }
  GYRO_HD Quatd load(const Quatd* column) const { return column[n]; }
  GYRO_HD ForceAndTorque<double> load(const Load* column) const { return {column[n].force, column[n].torque}; }
  template <class Row>
  GYRO_HD ParticleRow<double> load(const Row* column) const {
    return row_of(column[n]);
  }

  GYRO_HD void store(double* column, double value) const { column[n] = value; }
  GYRO_HD void store(Quatd* column, const Quatd& value) const { column[n] = value; }
  GYRO_HD void store(Load* column, const ForceAndTorque<double>& load) const {
    column[n] = {.force = load.force, .torque = load.torque};
  }
  template <class Row>
  GYRO_HD void store(Row* column, const ParticleRow<double>& row) const {
    column[n] = {row.vector, row.number};
  }
  GYRO_HD void clear(Load* column) const { column[n] = Load{}; }

  GYRO_HD bool any(bool m) const { return m; }
  GYRO_HD Index particle(int) const { return n; }

  /// @return the sum of the dashpots of the contacts that were added
  template <class Adder>
  GYRO_HD double add_contacts(const Adder& adder, ForceAndTorque<double>& load) const {
    ContactSum sum{load, 0, 0, 0};
    adder.add_contacts_of(n, sum);
    load = sum.load;
    return sum.dashpots;
  }
};

template <int N>
struct PackOfParticles;

}  // namespace gyro
