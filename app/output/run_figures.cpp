// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/run_figures.hpp"

#include "app/output/steady_state.hpp"

namespace gyro {
namespace {

void add_product(Summary& s, const Case& input, const Assembly& assembly, const Simulation& simulation,
                 const RunOutput& output) {
  s.holdup_mass = simulation.holdup();
  s.escaped_mass = simulation.escaped_mass();
  s.escaped_fraction = simulation.escaped_fraction();
  const ProductRow row = simulation.product()->row(simulation.time());
  s.discharged_mass = row.mass;
  if (simulation.time() > 0) s.throughput_tph = row.mass / simulation.time() * 3.6;
  if (!(row.mass > 0)) return;
  s.specific_energy_kwh_per_t = output.crushing_work() / 3.6e6 / (row.mass / 1000);
  s.p80 = row.p80;
  s.p50 = row.p50;
  s.product_below_css = passing_at(row.passing, input.crusher->closed_side_setting);
  s.product_below_oss = passing_at(row.passing, open_side_setting(*input.crusher));
  s.singles_share = row.singles_share;
  if (input.bonds && !assembly.setup.library.rocks.empty())
    s.swell_of_crumbled = swell_of_crumbled(assembly.setup.library);
}

void add_drive(Summary& s, const Simulation& simulation, const RunOutput& output) {
  if (simulation.feed()) s.choked = simulation.choked();
  if (const auto steady = steady_state(output.gyrations()); steady && simulation.product())
    s.steady = SteadyFigures{steady->from, steady->power, steady->throughput * 3.6, steady->residence_time};
  s.stalled = simulation.drivetrain()->stalled();
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
  s.bonds_broken = counts.broken_tension + counts.broken_shear;
  s.energy_residual_fraction = simulation.ledger().residual_fraction();
  s.momentum_residual_fraction = simulation.momentum().residual_fraction();
  s.mass_residual_fraction = mass.fed > 0 ? static_cast<double>(mass.residual()) / static_cast<double>(mass.fed) : 0;
  s.max_overlap_ratio = simulation.ledger().worst_overlap();
  if (simulation.feed()) {
    s.feed_mass = simulation.fed().mass;
    s.feed_waiting = simulation.fed().waiting;
  }
  if (gyrating_wall(assembly.setup.scene) != none) s.mean_crushing_power = output.mean_crushing_power();
  if (simulation.product()) add_product(s, input, assembly, simulation, output);
  if (simulation.drivetrain()) add_drive(s, simulation, output);
}

}  // namespace gyro
