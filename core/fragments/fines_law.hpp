// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <variant>

// How much of a fragment is finer than its particles. Pure functions of values in SI units.

namespace gyro {

/// Fines from the energy that broke the rock: the t10 law of drop-weight tests (Napier-Munn, Morrell, Morrison &
/// Kojovic, Mineral Comminution Circuits, JKMRC 1996).
///
///   t10 = A (1 - exp(-b E))
///
/// t10 is the share of the mass of a broken rock that is finer than a tenth of its size, E the energy that a rock takes
/// up / its mass. A and b are measured for each ore: A b is 30 to 40 % t/kWh for very hard, 40 to 55 for medium and
/// above 100 for soft ores.
///
/// Departures: a test counts all energy that a rock takes up. A simulation knows which rock an energy broke only of the
/// elastic energy that bonds release when they break, which is a part of it: friction, damping and motion take the
/// rest. E is the released energy / released_share. With a share of 1 t10 is a lower bound, which falls with the
/// stiffness of the bonds, since a bond of strength s and stiffness k stores s^2/(2 k): bonds release 1.6 % of the work
/// of the walls in the quickstart, and 16 % of it with bonds of 1/33 of the stiffness. The energies of all breakages
/// since the rock was fed are added, as Shi & Kojovic (Int. J. Miner. Process. 82 (2007) 156) add those of repeated
/// impacts, but without the energy below which nothing breaks: bonds that do not break release none.
struct BreakageFines {
  double A = 0;               ///< largest t10 [-]
  double b = 0;               ///< [kg/J]
  double released_share = 1;  ///< energy that bonds release / energy that a test counts [-]
};

/// Fines as a tail of the distribution of Gates, Gaudin and Schuhmann (Schuhmann, AIME Techn. Publ. 1189, 1940):
/// of a particle that has broken off a rock, the share (x/d)^m is finer than x, d its own size. Fragments of several
/// particles have no fines.
struct SchuhmannFines {
  double m = 0;  ///< exponent [-]
};

using FinesLaw = std::variant<BreakageFines, SchuhmannFines>;

/// What a law of fines needs to know of a fragment.
struct FragmentOrigin {
  double rock_size = 0;   ///< of its rock when that was fed, equal-mass diameter [m]
  double resolution = 0;  ///< equal-mass diameter of its heaviest particle [m]
  double energy = 0;      ///< elastic energy that its bonds released / its mass [J/kg]
  bool single = false;    ///< it is one particle

  friend bool operator==(const FragmentOrigin&, const FragmentOrigin&) = default;
};

/// t10 [-]. @param energy  released [J/kg]; below 0 as 0: the last half step of a bond that breaks may take more than
/// it stored
double t10_of(const BreakageFines& ore, double energy);

/// Shares of the mass finer than size/n for the n of `n_values`, which one t10 belongs to [-].
///
///   t_n = I_t10(alpha_n, beta_n)
///
/// with alpha, beta 0.51, 11.95 (n = 1.2); 1.07, 13.87 (1.5); 1.01, 8.09 (2); 1.08, 3.03 (4); 1.01, 0.53 (25);
/// 1.03, 0.36 (50); 1.03, 0.30 (75) after Carvalho & Tavares (Miner. Eng. 43-44 (2013) 91), as in the breakage models
/// of Rocky and EDEM. A t10 of 20 % gives t4 = 46, t25 = 10.9 and t75 = 6.1 %. Ores differ little in their family
/// (Narayanan & Whiten, Trans. IMM 97 (1988) C115), so that a case cannot give another.
///
/// Departure: where the fits cross, for t10 below 2e-5, t_n is at least that of the next larger n.
struct TnFamily {
  static constexpr std::array n_values{1.2, 1.5, 2.0, 4.0, 10.0, 25.0, 50.0, 75.0};
  std::array<double, n_values.size()> t;
};
/// @param t10  from 0 to 1
TnFamily tn_family(double t10);

/// Share of the mass finer than size/n [-]. Between the values of the family, ln t_n is linear in ln n, so that pieces
/// of the curve are Gates-Gaudin-Schuhmann distributions. Beyond n = 75 the last interval is extrapolated; below n
/// = 1.2 the value is t_1.2.
/// @param n  >= 1
double tn_of(const TnFamily& family, double n);

/// The curve of one fragment below its resolution.
class FragmentFines {
 public:
  FragmentFines(const FinesLaw& law, const FragmentOrigin& origin);

  /// Share of the fragment's mass that is finer than a size [-]; at the resolution and above the share that is finer
  /// than the resolution: only that part of the law is taken, and the rest stays where the particles are.
  ///
  /// With energies, that is t_n with n = rock_size/size: the tests compare all pieces with the rock that was broken,
  /// and the energy of a fragment is that of all breakages since its rock was fed. Rejected: n = size of the
  /// fragment/size, which would call the breakage that made a particle small the breakage of that particle.
  double finer_than(double size) const;
  /// t10 of its energy [-]; none with another law.
  std::optional<double> t10() const { return t10_; }
  bool any() const { return any_; }  ///< whether it has fines at all
  const FragmentOrigin& origin() const { return origin_; }

 private:
  FragmentOrigin origin_;
  std::optional<double> t10_;
  TnFamily family_{};
  double exponent_ = 0;
  bool any_ = false;
};

}  // namespace gyro
