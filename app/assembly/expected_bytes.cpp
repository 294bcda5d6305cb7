// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/expected_bytes.hpp"

#include "core/scene/new_rock.hpp"
#include "core/scene/snapshot.hpp"
#include "core/state/bonds.hpp"
#include "core/state/contacts.hpp"
#include "core/state/particles.hpp"

#include <algorithm>
#include <type_traits>

namespace gyro {
namespace {

// Of loose spheres that fall together, S1 of bench speed:
constexpr double pairs_of_loose = 3.3;    // a particle
constexpr double bytes_near_loose = 270;  // of a particle: candidates, and entries near walls with their history
constexpr double bytes_near_bonded = 20;  // of a particle inside a rock: an empty row of candidates

/// Adds up the sizes of a row in all columns that are visited.
struct AddSizes {
  double& bytes;
  template <class T>
  void operator()(const char*, T* const&) const {
    bytes += sizeof(T);
  }
};

/// What is there from the start on.
double particle_bytes(bool bonded) {
  double columns = 0;
  const ParticleView none{};
  ParticleView::for_each_common_column(AddSizes{columns}, none);
  if (bonded) ParticleView::for_each_bonded_column(AddSizes{columns}, none);
  constexpr double bounds = 2 * sizeof(Sphere), row_begins = 6 * sizeof(Index);
  return columns + bounds + row_begins;
}

template <class Real>
double bond_bytes() {
  double columns = 0;
  const BondView<Real> none{};
  BondView<Real>::for_each_column(AddSizes{columns}, none);
  constexpr double in_rows = 2 * 2 * sizeof(Index);  // BondIndex: bond and partner at each end
  return columns + in_rows;
}

/// Without the column that few contact laws have. The present list and the last one have pairs, histories and ends, one
/// of them has loads.
template <class Real>
double pair_bytes() {
  constexpr double in_each = sizeof(Pair) + sizeof(ContactHistory<Real>) + sizeof(std::int8_t) + 2 * sizeof(PairEnd);
  constexpr double in_one = sizeof(PairEnds) + 2 * (sizeof(EndLoad<Real>) + sizeof(std::int8_t) + sizeof(Real));
  return 2 * in_each + in_one;
}

/// What comes with the steps.
template <class Real>
double running_bytes(double particles, double bonds) {
  constexpr double snapshot = 3 * sizeof(Index) + 4 * sizeof(Vec3d) + 2 * sizeof(double);
  const double held = bonds > 0 ? sizeof(Load) : 0;
  const double pairs = std::max(0.0, pairs_of_loose * particles - bonds), loose = pairs / pairs_of_loose;
  return particles * (snapshot + held) + bytes_near_loose * loose + bytes_near_bonded * (particles - loose) +
         pairs * pair_bytes<Real>();
}

template <class Real>
double bytes_of(double particles, double bonds) {
  const double start = particles * sizeof(NewParticle) + bonds * sizeof(NewBond);
  return particles * particle_bytes(bonds > 0) + bonds * bond_bytes<Real>() +
         std::max(start, running_bytes<Real>(particles, bonds));
}

}  // namespace

double expected_bytes(double particles, double bonds, Precision precision) {
  return precision == Precision::mixed ? bytes_of<float>(particles, bonds) : bytes_of<double>(particles, bonds);
}

}  // namespace gyro
