// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/check.hpp"

#include <string>
#include <vector>

namespace gyro::verify {

/// The precisions in which a verification runs. `double_only`: nothing in it depends on the precision, or it takes too
/// long to run twice; `mixed_only`: it takes too long to run twice.
enum class Precisions { both, double_only, mixed_only };

/// `nightly`: takes minutes and runs only with --nightly.
enum class When { always, nightly };

/// A scene whose answer is known. It runs on the engine that also runs crushers, and records what it measures.
struct Verification {
  std::string name;  ///< group/case
  void (*run)(Recorder&);
  Precisions precisions = Precisions::both;
  When when = When::always;

  std::string group() const { return name.substr(0, name.find('/')); }
};

/// All verifications, in the order of the list of groups in CMakeLists.txt.
std::vector<Verification> all_verifications();

/// Runs a verification in each of its precisions.
std::vector<Check> run(const Verification& verification);

}  // namespace gyro::verify
