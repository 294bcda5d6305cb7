// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/load_columns.hpp"

#include <bit>
#include <cstddef>

namespace gyro {

/// A ContactSum in two registers, for two additions a contact.
/// @tparam few_touch  true: a branch for each listed contact, so that only loads of touching ones are read. false: no
///                    branch, because a processor cannot predict which contacts touch when many of them do.
template <bool few_touch>
class ContactSumRow {
 public:
  /// @param force, torque  three numbers each
  ContactSumRow(const Four<double>& force, const Four<double>& torque)
      : first_(__builtin_shufflevector(force, torque, 0, 1, 2, 4)), last_(torque) {}
  void take(const LostWork& lost) {
    static_assert(offsetof(LostWork, contact_damping) == 16 && offsetof(LostWork, contact_slip) == 24);
    last_ = __builtin_shufflevector(last_, whole_row(&lost, 0), 1, 2, 6, 7);
  }
  void give(LostWork& lost) const {
    const auto damped_slipped = __builtin_shufflevector(last_, last_, 2, 3);
    store_vector(&lost.contact_damping, 0, damped_slipped);
  }
  template <template <class> class Contact, class Real>
  void add(std::int8_t touches, const Contact<Real>& contact, const Real& dashpot) {
    using C = Contact<Real>;
    static_assert(std::is_standard_layout_v<C> && offsetof(C, force) == 0 && offsetof(C, torque) == 3 * sizeof(Real) &&
                  offsetof(C, damped) == 6 * sizeof(Real) && offsetof(C, slipped) == 7 * sizeof(Real));
    if (few_touch && !touches) return;
    const auto first = first_ + half<0>(contact), last = last_ + half<1>(contact),
               dashpots = dashpots_ + static_cast<double>(dashpot);
    const Four<std::int64_t> mask = Four<std::int64_t>{} - std::int64_t{few_touch ? std::int8_t{1} : touches};
    first_ = mask ? first : first_;
    last_ = mask ? last : last_;
    dashpots_ = mask ? dashpots : dashpots_;
  }
  Four<double> force() const { return first_; }
  Four<double> torque() const { return __builtin_shufflevector(first_, last_, 3, 4, 5, 5); }
  double dashpots() const { return dashpots_[0]; }

 private:
  template <int which, template <class> class Contact, class Real>
  static Four<double> half(const Contact<Real>& contact) {
    return pack_cast<double>(Pack<Real, 4>{vector_at<Four<Real>>(&contact, which)}).v;
  }
  Four<double> first_, last_;  ///< force, torque, damped and slipped, as in a contact
  Four<double> dashpots_{};    ///< the same number four times
};

/// N neighbouring particles from any `first` on: the twin of OneParticle (particle_lane.hpp) for a CPU core. N is 4
/// or 8.
template <int N>
struct PackOfParticles {
  template <class T>
  using Number = Pack<T, N>;
  using D = Pack<double, N>;
  static constexpr int count = N;
  Index first;

  D load(const double* column) const { return D{vector_at<typename D::Vector>(column + first)}; }
  Quat<D> load(const Quatd* column) const {
    fetch_ahead(column);
    const ParticleRow<D> c = neighbour_columns<N>(column + first);
    return {c.vector.x, c.vector.y, c.vector.z, c.number};
  }
  ForceAndTorque<D> load(const Load* column) const {
    fetch_ahead(column);
    return load_columns<N>(column + first);
  }
  template <class Row>
  ParticleRow<D> load(const Row* column) const {
    fetch_ahead(column);
    return neighbour_columns<N>(column + first);
  }

  void store(double* column, const D& value) const { store_vector(column + first, 0, value.v); }
  void store(Quatd* column, const Quat<D>& q) const { store_neighbours<N>(column + first, {{q.w, q.x, q.y}, q.z}); }
  void store(Load* column, const ForceAndTorque<D>& load) const { store_loads<N>(column + first, load); }
  template <class Row>
  void store(Row* column, const ParticleRow<D>& row) const {
    store_neighbours<N>(column + first, row);
  }
  void clear(Load* column) const {
    for (int k = 0; k < 2 * N; ++k) store_vector(column + first, k, Four<double>{});
  }

  template <class T>
  bool any(const PackMask<T, N>& m) const {
    return any_bit(m.v);
  }
  Index particle(int lane) const { return first + lane; }

  /// Contacts are added particle by particle, because particles differ in their number.
  template <class Adder>
  D add_contacts(const Adder& adder, ForceAndTorque<D>& load) const {
    D dashpots(0);
    const Index listed = adder.listed(first, first + N), touching = touching_of(adder);
    if (touching == 0) return dashpots;
    Four<double> force[N], torque[N];
    double dashpot[N];
    store_neighbours<N>(force, {load.force, D(0)});
    store_neighbours<N>(torque, {load.torque, D(0)});
    const auto add = [&]<class Sum>(int k, Sum sum) {
      adder.add_contacts_of(first + k, sum);
      force[k] = sum.force();
      torque[k] = sum.torque();
      dashpot[k] = sum.dashpots();
    };
    if (4 * touching < listed)
      for (int k = 0; k < N; ++k) add(k, ContactSumRow<true>(force[k], torque[k]));
    else
      for (int k = 0; k < N; ++k) add(k, ContactSumRow<false>(force[k], torque[k]));
    load.force = row_columns<double, N>([&](int k) { return force[k]; }).vector;
    load.torque = row_columns<double, N>([&](int k) { return torque[k]; }).vector;
    dashpots = D{vector_at<typename D::Vector>(dashpot)};
    return dashpots;
  }

 private:
  /// Brings the rows of the pack after the next one into the cache: more columns are read than a processor follows.
  template <class Row>
  void fetch_ahead(const Row* column) const {
    const char* at = reinterpret_cast<const char*>(column) + (first + 2 * N) * static_cast<std::ptrdiff_t>(sizeof(Row));
    for (std::size_t line = 0; line < N * sizeof(Row); line += 64) __builtin_prefetch(at + line, 1);
  }
  template <class Adder>
  Index touching_of(const Adder& adder) const {
    const auto ones = [&](const std::int8_t* column, const Index* row_begin) {
      return number_of_ones(column + row_begin[first], column + row_begin[first + N]);
    };
    return ones(adder.pairs.loaded, adder.pairs.row_begin) + ones(adder.walls.touching, adder.walls.row_begin);
  }
  /// Of bytes that are 0 or 1.
  static Index number_of_ones(const std::int8_t* at, const std::int8_t* end) {
    Index ones = 0;
    for (; end - at >= 8; at += 8) ones += std::popcount(vector_at<std::uint64_t>(at, 0));
    for (; at < end; ++at) ones += *at;
    return ones;
  }
};

}  // namespace gyro
