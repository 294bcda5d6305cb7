// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fragment_record.hpp"

#include <vector>

namespace gyro {

/// Fragments at one time, and where each comes from.
struct FragmentSnapshot {
  std::vector<FragmentRecord> record;
  std::vector<ParticleId> parent;  ///< number of the fragment that it broke off; its own if it is a rock as it was fed,
                                   ///< or broke before the first look at its rock
  std::vector<double> formed;  ///< time of the look that first found it as it is; of a whole rock, when it was fed [s]

  std::size_t size() const { return record.size(); }
};

/// Follows fragments from one look to the next. Bonds never heal, so a fragment with the same number (lowest particle
/// id) and as many particles is unchanged; another one is a part of the fragment that had its particles at the last
/// look.
class FragmentHistory {
 public:
  /// Everything that a checkpoint keeps: of the last look.
  struct State {
    std::vector<ParticleId> particle;  ///< ascending
    std::vector<ParticleId> label;     ///< number of the fragment of each
    std::vector<ParticleId> fragment;  ///< ascending
    std::vector<Index> particles;      ///< number of each
    std::vector<ParticleId> parent;    ///< of each
    std::vector<double> formed;        ///< of each [s]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("particle", s.particle...);
      f("label", s.label...);
      f("fragment", s.fragment...);
      f("particles", s.particles...);
      f("parent", s.parent...);
      f("formed", s.formed...);
    }
  };

  FragmentHistory() = default;
  explicit FragmentHistory(State state) : state_(std::move(state)) {}

  /// Looks at the fragments now. @param time  [s]  @param records  of fragments of these particles, not necessarily all
  FragmentSnapshot look(double time, std::vector<FragmentRecord> records, const ParticleSnapshot& particles);
  const State& state() const { return state_; }

 private:
  void note(const FragmentSnapshot& now, const ParticleSnapshot& particles);

  State state_;
};

}  // namespace gyro
