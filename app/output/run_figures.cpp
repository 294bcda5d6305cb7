// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/run_figures.hpp"

#include "app/output/steady_state.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace gyro {
namespace {

/// A figure of a run whose last window may not be finite.
std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

constexpr double kwh_per_t = 1000 / 3.6e6;  // in a J/kg

/// What is finer than particles.
FinesFigures fines_figures_of(const Fines& fines, const FinesLaw& law) {
  const FinesRow row = fines.product();
  return {.law = std::holds_alternative<BreakageFines>(law) ? "breakage" : "gates_gaudin_schuhmann",
          .p80 = row.p80,
          .p50 = row.p50,
          .share = row.share.value_or(0),
          .released_energy_kwh_per_t = row.energy.value_or(0) * kwh_per_t,
          .t10 = row.t10,
          .beyond_share = row.beyond_share};
}

void add_product(Summary& s, const Case& input, const Assembly& assembly, const Simulation& simulation,
                 const RunOutput& output) {
  s.holdup_mass = simulation.holdup();
  s.escaped_mass = simulation.escaped_mass();
  s.escaped_fraction = simulation.escaped_fraction();
  const ProductRow row = simulation.product()->row(simulation.time());
  s.discharged_mass = row.mass;
  if (assembly.resolution) {
    s.resolution = assembly.resolution->coarsest;
    s.finest_particle = assembly.resolution->finest;
  }
  if (simulation.time() > 0) s.throughput_tph = row.mass / simulation.time() * 3.6;
  if (!(row.mass > 0)) return;
  s.specific_energy_kwh_per_t = output.crushing_work() / 3.6e6 / (row.mass / 1000);
  s.p80 = row.p80;
  s.p50 = row.p50;
  s.product_below_css = passing_at(row.sieves, row.passing, input.crusher->closed_side_setting);
  s.product_below_oss = passing_at(row.sieves, row.passing, open_side_setting(*input.crusher));
  s.singles_share = row.singles_share;
  if (simulation.fines()) s.fines = fines_figures_of(*simulation.fines(), *input.output.fines);
  if (input.bonds && !assembly.setup.library.rocks.empty())
    s.swell_of_crumbled = swell_of_crumbled(assembly.setup.library);
}

constexpr double rounding = 1e-9;  // of sums of masses
constexpr double tph = 3.6;        // t/h in a kg/s

Estimate scaled(const Estimate& e, double factor) {
  return {e.value * factor, e.error * factor};
}

/// Whether the run is steady, and its figures since then.
void add_steady(Summary& s, const Case& input, const Simulation& simulation, const RunOutput& output) {
  const std::array sizes{input.crusher->closed_side_setting, open_side_setting(*input.crusher)};
  const std::optional<SteadyState> steady = steady_state(output.gyrations(), sizes, {}, simulation.product()->sieves());
  if (!steady) {
    s.not_steady = unsteady_reason(output.gyrations());
    return;
  }
  SteadyFigures& f = s.steady.emplace();
  f.from = steady->from;
  f.gyrations = static_cast<std::int64_t>(steady->gyrations);
  f.blocks = static_cast<std::int64_t>(steady->blocks);
  f.crushing_power = steady->power;
  if (simulation.drivetrain()->knows().motor_power) f.motor_power = steady->motor_power;
  f.throughput_tph = scaled(steady->throughput, tph);
  if (steady->specific_energy) f.specific_energy_kwh_per_t = scaled(*steady->specific_energy, kwh_per_t);
  f.p80 = steady->p80;
  f.p50 = steady->p50;
  f.product_below_css = steady->below[0];
  f.product_below_oss = steady->below[1];
  f.residence_time = steady->residence_time;
  if (output.gyrations_with_fines() == nullptr) return;
  // The same gyrations: whether they are steady does not depend on the sieves.
  const std::optional<SteadyState> with_fines =
      steady_state(*output.gyrations_with_fines(), {}, {}, simulation.product()->sieves());
  f.p80_with_fines = with_fines->p80;
  f.p50_with_fines = with_fines->p50;
}

/// Power on the motor's name plate [W]; none for a motor that has none, and for foreign drives.
std::optional<double> rated_power(const Case& input) {
  if (!input.drivetrain) return std::nullopt;
  const Motor& motor = input.drivetrain->motor;
  const double power = rated_torque_of(motor) * rated_speed(motor);
  return power > 0 ? std::optional(power) : std::nullopt;
}

void add_drive(Summary& s, const Case& input, const Simulation& simulation, const RunOutput& output) {
  if (simulation.feed()) s.choked = simulation.choked();
  if (simulation.product()) add_steady(s, input, simulation, output);
  if (simulation.drivetrain()->knows().motor_power)
    s.motor = output.motor().figures(s.steady ? s.steady->from : 0, rated_power(input));
  for (const DriveEvent& event : simulation.drivetrain()->events())
    s.drive_events.push_back({event.time, to_string(event.kind)});
}

}  // namespace

void add_figures(Summary& s, const Case& input, const Assembly& assembly, const Simulation& simulation,
                 const RunOutput& output) {
  const Counts counts = simulation.dem().counts();
  const MassCount mass = simulation.mass_count();
  s.simulated_seconds = simulation.time();
  s.particle_steps = counts.particle_steps;
  s.bond_steps = counts.bond_steps;
  s.particles = counts.particles;
  s.bonds_initial = simulation.bonds_initial();
  s.stalled = simulation.drivetrain() && simulation.drivetrain()->stalled();
  s.bonds_broken = counts.broken_tension + counts.broken_shear;
  s.energy_residual_fraction = if_finite(simulation.ledger().residual_fraction());
  s.momentum_residual_fraction = if_finite(simulation.momentum().residual_fraction());
  s.mass_residual_fraction = mass.fed > 0 ? static_cast<double>(mass.residual()) / static_cast<double>(mass.fed) : 0;
  s.max_overlap_ratio = simulation.ledger().worst_overlap();
  if (assembly.setup.filling) {
    s.start_mass = simulation.start_mass();
    const double missing = assembly.start_mass - simulation.start_mass();
    s.start_missing = missing > rounding * assembly.start_mass ? missing : 0;
  }
  if (simulation.feed()) {
    s.feed_mass = simulation.fed().mass;
    s.feed_waiting = simulation.fed().waiting;
  }
  if (gyrating_wall(assembly.setup.scene) != none) s.mean_crushing_power = output.mean_crushing_power();
  if (simulation.product()) add_product(s, input, assembly, simulation, output);
  if (simulation.drivetrain()) add_drive(s, input, simulation, output);
}

}  // namespace gyro
