// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fines_law.hpp"
#include "core/fragments/hold_up.hpp"
#include "core/fragments/product.hpp"
#include "core/fragments/rock_history.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gyro {

/// Largest t10 that is usual in crushers [-]: tests of rocks that crushers break give up to 30 or 40 % (Napier-Munn et
/// al. 1996). Above it a law of fines is an extrapolation.
inline constexpr double usual_t10 = 0.4;

/// A sieve analysis in which fines are estimated.
struct FinesRow {
  std::vector<double> passing = {};          ///< mass share finer than each sieve [-]; zeros without mass
  std::optional<double> p80 = {}, p50 = {};  ///< sizes that 80 % and 50 % of the mass pass [m]; none without mass
  std::optional<double> share = {};  ///< of the mass that the law calls finer than the particles [-]; none without mass
  std::optional<double> t10 = {};    ///< mean over the mass [-]; none without mass or with a law without t10
  std::optional<double> energy = {};        ///< released by bonds / mass [J/kg]; none without mass
  std::optional<double> beyond_share = {};  ///< of the mass with a t10 above usual_t10 [-]; none as t10
};

/// Mass by sieve, with fines.
struct FinesTally {
  std::vector<double> sieve_mass;  ///< as that of SieveTally [kg]
  double mass = 0;                 ///< [kg]
  double fines = 0;                ///< finer than the particles of its fragments [kg]
  double t10_mass = 0;             ///< sum of t10 x mass [kg]
  double beyond = 0;               ///< mass with a t10 above usual_t10 [kg]
  double energy = 0;               ///< released [J]

  template <class F, class... T>
  static constexpr void for_each_field(F&& f, T&... t) {
    f("sieve_mass", t.sieve_mass...);
    f("mass", t.mass...);
    f("fines", t.fines...);
    f("t10_mass", t.t10_mass...);
    f("beyond", t.beyond...);
    f("energy", t.energy...);
  }

  /// Adds a fragment of this sieve size [m] and mass [kg]. What is finer than its resolution comes from its own class,
  /// so that the sum over the sieves is the mass.
  /// @param sieves  the same in all calls
  void add(const std::vector<double>& sieves, const FragmentFines& curve, double size, double fragment_mass);
  FinesRow row(const std::vector<double>& sieves, const FinesLaw& law) const;
};

/// The estimate of product and hold-up finer than single particles. A fragment is counted with the energy that its
/// particles have when it is discharged, as it is with its size.
class Fines {
 public:
  /// Everything that a checkpoint keeps.
  struct State {
    RockHistory::State history;
    FinesTally product, hold_up;

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("history", s.history...);
      f("product", s.product...);
      f("hold_up", s.hold_up...);
    }
  };

  /// @param rock_density  of solid rock [kg/m3]
  /// @param sieves        of product and hold-up, increasing [m]
  Fines(const FinesLaw& law, double rock_density, std::vector<double> sieves)
      : Fines(law, rock_density, std::move(sieves), State{}) {}
  /// With the state of an earlier account of the same law on the same sieves.
  Fines(const FinesLaw& law, double rock_density, std::vector<double> sieves, State state);

  void feed(std::span<const NewRock> rocks) { history_.feed(rocks); }
  void add(std::span<const Breakage> broken) { history_.add(broken); }
  /// Counts what has left, and analyses what has not.
  /// @param table    of these particles
  /// @param left     what the update of the product returned for them
  /// @param product  after its update with them
  /// @param hold_up  likewise
  void update(const FragmentTable& table, const ParticleSnapshot& particles, std::span<const FragmentRecord> left,
              const Product& product, const HoldUp& hold_up);
  /// Forgets particles. @param gone, particles  as RockHistory::remove
  void remove(std::span<const ParticleId> gone, const ParticleSnapshot& particles) { history_.remove(gone, particles); }

  FinesRow product() const { return product_.row(sieves_, law_); }  ///< of all that was discharged
  FinesRow hold_up() const { return hold_up_.row(sieves_, law_); }  ///< of the last analysis
  /// As Product::State::sieve_mass, with fines [kg].
  const std::vector<double>& sieve_mass() const { return product_.sieve_mass; }
  State state() const { return {history_.state(), product_, hold_up_}; }

 private:
  /// The curve of a fragment of the hold-up. Its family of t_n takes most of the time of an update, and few fragments
  /// change between two updates.
  struct Known {
    ParticleId first;
    FragmentFines fines;
  };

  FragmentOrigin origin_of(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles,
                           const std::vector<double>& energies) const;

  FinesLaw law_;
  double rock_density_;
  std::vector<double> sieves_;
  RockHistory history_;
  FinesTally product_, hold_up_;
  std::vector<Known> known_;  ///< of the last update, by ascending id; no result depends on it
};

}  // namespace gyro
