// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

/// Particles that are not in the scene, because they have not been fed yet or were taken out, get NaN.
void read_probes(const ParticleSnapshot& s, std::span<const std::uint32_t> probes, SeriesReading& reading) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t id : probes) {
    const auto found = std::lower_bound(s.id.begin(), s.id.end(), id);
    const bool there = found != s.id.end() && *found == id;
    const auto k = static_cast<std::size_t>(found - s.id.begin());
    const auto value = [&](const std::vector<Vec3d>& all) { return there ? all[k] : Vec3d{nan, nan, nan}; };
    reading.probe_positions.push_back(value(s.position));
    reading.probe_velocities.push_back(value(s.velocity));
    reading.probe_spins.push_back(value(s.angular_velocity));
  }
}

}  // namespace

OutputForm output_form(const Case& input, const Assembly& assembly) {
  OutputForm form;
  form.levels = input.numerics.rigid.has_value();
  form.drive = input.drivetrain || input.drivetrain_fmu;
  if (input.drivetrain_fmu) form.drive_knows = knowledge_of(input.drivetrain_fmu->links);
  const Scene& scene = assembly.setup.scene;
  const Index gyrating = gyrating_wall(scene);
  form.mantle = gyrating != none;
  form.feed = input.feed.has_value();
  form.product = input.crusher.has_value();
  form.bonds = input.bonds.has_value();
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    if (static_cast<Index>(w) != gyrating) form.walls.push_back(scene.walls[w].name);
  for (const std::uint32_t id : input.output.probes) form.probes.push_back(std::to_string(id));
  form.liners = input.output.liners.has_value();
  form.fines = input.output.fines.has_value();
  form.t10 = form.fines && std::holds_alternative<BreakageFines>(*input.output.fines);
  form.wear = form.liners && input.output.liners->wear_coefficient;
  return form;
}

WindowReading read_window(const WindowResult& result, const Simulation& simulation) {
  const Index gyrating = gyrating_wall(simulation.setup().scene);
  WindowReading reading;
  reading.length = result.window.length();
  reading.crushing_power = result.crushing_power;
  reading.mantle_force = result.mantle_force;
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    if (static_cast<Index>(w) != gyrating) reading.wall_forces.push_back(result.walls[w].force);
  if (simulation.drivetrain()) reading.drive = simulation.drivetrain()->means();
  return reading;
}

SeriesReading read_series(const Simulation& simulation, std::span<const std::uint32_t> probes) {
  SeriesReading reading;
  reading.time = simulation.time();
  if (const auto& drive = simulation.drivetrain()) {
    reading.motor_speed = drive->motor_speed();
    reading.eccentric_speed = drive->state().speed;
    reading.eccentric_angle = drive->state().angle;
    reading.mantle_spin = drive->state().spin;
  }
  reading.feed_mass = simulation.fed().mass;
  reading.discharged_mass = simulation.discharged_mass();
  reading.escaped_mass = simulation.escaped_mass();
  reading.holdup_mass = simulation.holdup();
  reading.counts = simulation.dem().counts();
  reading.fragments = simulation.fragments();
  reading.largest_fragment = simulation.largest_fragment();
  reading.max_overlap_ratio = simulation.ledger().extremes().overlap_ratio;
  if (!probes.empty()) read_probes(simulation.dem().particles(), probes, reading);
  return reading;
}

bool is_finite(const WindowResult& result, const Simulation& simulation) {
  const EnergyTerms& energy = simulation.ledger().energy();
  double sum =
      energy.residual() + energy.kinetic + energy.potential + result.crushing_power + simulation.momentum().residual();
  for (const WallLoad& wall : result.walls) sum += norm(wall.force);
  return simulation.ledger().extremes().finite && std::isfinite(sum);
}

LedgerReading read_ledger(const Simulation& simulation) {
  return {.time = simulation.time(),
          .energy = simulation.ledger().energy(),
          .momentum_residual = simulation.momentum().residual(),
          .mass_residual = simulation.mass_count().residual()};
}

}  // namespace gyro
