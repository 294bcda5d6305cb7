// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/feed/feed.hpp"
#include "core/feed/filling.hpp"
#include "core/fragments/concave_outline.hpp"
#include "core/fragments/fines_law.hpp"
#include "core/fragments/sieve_curve.hpp"
#include "core/rocks/rock_template.hpp"
#include "core/scene/new_rock.hpp"
#include "core/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// Where rock leaves: a fragment that lies wholly below z = 0 is discharged and counted as product, unless it has
/// escaped over the rim of the concave (core/fragments/product.hpp).
struct Discharge {
  double removal_depth = 0;  ///< a fragment that has left is removed once it lies wholly below z = -this [m], >= 0
  std::optional<ConcaveOutline> concave = {};   ///< none: all that falls below z = 0 is product
  std::vector<double> sieves = sieve_series();  ///< of product and hold-up, increasing [m]
  std::optional<FinesLaw> fines = {};           ///< of what is finer than particles; none: it is not estimated
};

/// What a coupled run is made of, in SI units. Plain data: a program may fill it by hand, app/assembly fills it from a
/// case file. Only materials, pairs and the step are needed; what is left out does not exist and costs nothing.
///
///   Setup setup;
///   setup.scene.materials = {{"rock", 2600, 557e6, 0.35}};   setup.scene.pairs = {{0.5, 0.2, 0}};
///   setup.scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}}};
///   setup.start = {...};   set_step(setup);
///   Simulation run(setup, make_cpu_dem(setup.scene, Precision::mixed, 4));
///   while (run.time() < 1) run.advance();
struct Setup {
  Scene scene;                 ///< `dt` and `substeps` included
  int steps_per_window = 1;    ///< of the longest window
  std::vector<NewRock> start;  ///< rocks at t = 0, besides those of the feed
  RockLibrary library;         ///< rocks that the feed draws from
  std::optional<ChamberFilling>
      filling;  ///< pieces of the library's rocks at t = 0, placed after `start`; not a part of the feed
  std::optional<FeedPlan> feed;  ///< needs the library
  BondStrength bond_strength;    ///< of the rocks that are fed; empty: all bonds have strength 1
  std::optional<Discharge> discharge;
  /// Simulated time between two inspections: of fragments, product, and particles that touch through a mesh wall [s].
  /// They happen at the ends of windows; 0: only when Simulation::inspect() is called.
  double inspection_interval = 1e-3;
  /// The guard stops a run whose energy residual exceeds this share of the work done (ledger.hpp) [-]. The limits of a
  /// single step are scene.limits.
  double max_energy_residual = 0.05;
};

/// The first wall that the eccentric moves; none without one.
Index gyrating_wall(const Scene& scene);

/// The parts of a setup, for errors.
enum class SetupPart { scene, step, start, feed };

/// A setup that cannot be run, and the part to blame.
struct BadSetup : BadInput {
  BadSetup(SetupPart blamed, const std::string& problem) : BadInput(problem), part(blamed) {}
  SetupPart part;
};

/// Checks sizes and ranges of materials, pairs and walls. set_step() and Simulation call it. @throws BadSetup
void check_scene(const Scene& scene);
/// Checks scene and step. Simulation calls it. @throws BadSetup
void check_setup(const Setup& setup);

}  // namespace gyro
