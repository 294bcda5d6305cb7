// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/neighbour_lists.hpp"
#include "core/dem/scene_laws.hpp"
#include "core/kernels/accounts.hpp"
#include "core/kernels/stiffest_contacts.hpp"
#include "core/scene/accounts.hpp"

#include <cmath>
#include <limits>

namespace gyro {

/// Sums over a scene as it stands, for the ledger and the guard. Owns nothing; its kernels only read.
template <class Exec, class Real>
struct SceneSums {
  Exec& exec;
  const Scene& scene;
  const SceneLaws<Exec, Real>& laws;
  const ParticleStore<Exec, Real>& rock;
  const NeighbourLists<Exec, Real>& lists;
  WallsNow walls;

  ParticleSums particles() const {
    return exec.template reduce<ParticleSums>("sum particles", rock.count(),
                                              SumParticles{rock.read(), scene.gravity, scene.dt});
  }
  ContactSums contacts() const { return contacts(scene.dt); }
  /// @param dt  particles with a shorter step have the overlaps of their places, others those of the last evaluation
  /// [s]
  ContactSums contacts(double dt) const {
    return exec.template reduce<ContactSums>(
        "sum contacts", rock.count(),
        SumContacts<Real>{rock.read(), lists.pairs().read(), lists.walls().read(), walls, laws.rock(), laws.walls(),
                          laws.rock_model(), laws.wall_model(), dt});
  }
  BondSums bonds() const {
    if (!rock.has_bonds()) return {};
    return exec.template reduce<BondSums>(
        "sum bonds", rock.bond_count(),
        SumBonds<Real>{rock.read(), rock.read_bonds(), laws.bond(), laws.bond_model(), rock.blocks().data()});
  }

  StiffestContacts stiffest_contacts() const {
    return exec.template reduce<StiffestContacts>(
        "sum contacts", rock.count(),
        FindStiffestContacts<Real>{rock.read(), lists.pairs().read(), lists.walls().read(), laws.rock(), laws.walls(),
                                   laws.rock_model(), laws.wall_model(), scene.dt, scene.damping_cap});
  }

  /// @param booked  energies of what has left, of events and of walls
  EnergyTerms energy(const EnergyTerms& booked) const { return energy(booked, particles(), contacts(), bonds()); }
  /// Kinetic, potential and elastic energy, overlaps from the places of all particles: before and after some are moved.
  double energy_in_places() const {
    const ParticleSums sums = particles();
    return sums.kinetic + sums.potential + contacts(std::numeric_limits<double>::infinity()).elastic + bonds().elastic;
  }
  static EnergyTerms energy(const EnergyTerms& booked, const ParticleSums& sums, const ContactSums& contact,
                            const BondSums& bond) {
    EnergyTerms e = booked;
    e.kinetic = sums.kinetic;
    e.potential = sums.potential;
    e.contact_elastic = contact.elastic;
    e.bond_elastic = bond.elastic;
    e.contact_damping += sums.lost.contact_damping;
    e.friction += sums.lost.contact_slip + sums.lost.bond_slip;
    e.bond_damping += sums.lost.bond_damping;
    return e;
  }

  /// @param bond  none: their rotation is not looked at
  Extremes extremes(const ParticleSums& sums, const ContactSums& contact, const BondSums& bond = {}) const {
    Extremes x;
    x.finite = sums.not_finite == 0;
    x.culprit = x.finite ? contact.culprit : sums.culprit;
    x.partner = contact.partner;
    x.wall = contact.wall;
    x.overlap_ratio = contact.overlap_ratio;
    x.speed_ratio = sums.overspeed;
    x.fastest = sums.fastest;
    x.rotation = sums.rotation;
    x.fastest_rotating = sums.fastest_rotating;
    const StiffestContacts stiffest = stiffest_contacts();
    x.contact_step = std::sqrt(stiffest.share2);
    x.crowded = stiffest.particle;
    x.crowd = stiffest.count;
    x.bond_rotation = bond.rotation;
    x.twisted = bond.twisted;
    return x;
  }
};

}  // namespace gyro
