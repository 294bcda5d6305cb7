// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/tables/tables.hpp"

namespace gyro {

const Table<LedgerReading, WindowReading>& ledger_table() {
  using Row = LedgerReading;
  static const Table<LedgerReading, WindowReading> table{
      .group = "/ledger",
      .rows = "one row with each row of /series",
      .presence = always,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Row& r) { return r.time; },
           .description = "simulated time at the end of the row's interval"},
          {.name = "kinetic",
           .units = "J",
           .value = [](const Row& r) { return r.energy.kinetic; },
           .description = "kinetic energy of the particles"},
          {.name = "potential",
           .units = "J",
           .value = [](const Row& r) { return r.energy.potential; },
           .description = "potential energy of the particles in gravity"},
          {.name = "contact_elastic",
           .units = "J",
           .value = [](const Row& r) { return r.energy.contact_elastic; },
           .description = "elastic energy of the contacts"},
          {.name = "bond_elastic",
           .units = "J",
           .value = [](const Row& r) { return r.energy.bond_elastic; },
           .description = "elastic energy of the bonds"},
          {.name = "contact_damping",
           .units = "J",
           .value = [](const Row& r) { return r.energy.contact_damping; },
           .description = "energy lost to damping in contacts since the start"},
          {.name = "friction",
           .units = "J",
           .value = [](const Row& r) { return r.energy.friction; },
           .description = "energy lost to sliding and rolling friction since the start"},
          {.name = "bond_damping",
           .units = "J",
           .value = [](const Row& r) { return r.energy.bond_damping; },
           .description = "energy lost to damping in bonds since the start"},
          {.name = "bond_breakage",
           .units = "J",
           .value = [](const Row& r) { return r.energy.bond_breakage; },
           .description = "elastic energy released by breaking bonds since the start"},
          {.name = "wall_work",
           .units = "J",
           .value = [](const Row& r) { return r.energy.wall_work; },
           .description = "work of the walls on the rock since the start"},
          {.name = "exchanged",
           .units = "J",
           .value = [](const Row& r) { return r.energy.exchanged; },
           .description = "energy of the particles put in less that of those taken out since the start"},
          {.name = "switched",
           .units = "J",
           .value = [](const Row& r) { return r.energy.switched; },
           .description = "elastic energy and inner motion lost since the start where rocks became rigid bodies, "
                          "and where broken bonds that press next to nothing became contacts (`numerics.levels`)",
           .presence = with_levels},
          {.name = "energy_residual",
           .units = "J",
           .value = [](const Row& r) { return r.energy.residual(); },
           .description = "sum of the energies above less wall work and exchange: the error of the time integration"},
          {.name = "momentum_residual",
           .units = "N s",
           .value = [](const Row& r) { return r.momentum_residual; },
           .description = "magnitude of the rock's linear momentum less the impulses of gravity and walls"},
          {.name = "mass_residual",
           .units = "1",
           .value = [](const Row& r) { return r.mass_residual; },
           .description = "particles fed less particles discharged, escaped and inside"},
          {.name = "power_residual",
           .units = "W",
           .value = [](const WindowReading& m) { return m.drive.power_residual; },
           .description =
               "motor power less losses, crushing power and gain of kinetic energy: the error of the coupling; "
               "0 without a drivetrain, NaN for one that does not know its losses"},
      }};
  return table;
}

const Table<PerformanceReading>& performance_table() {
  using Row = PerformanceReading;
  static const Table<PerformanceReading> table{
      .group = "/performance",
      .rows = "one row with each row of /series",
      .presence = always,
      .columns = {
          {.name = "time",
           .units = "s",
           .value = [](const Row& r) { return r.time; },
           .description = "simulated time at the end of the row's interval"},
          {.name = "wall_seconds",
           .units = "s",
           .value = [](const Row& r) { return r.wall_seconds; },
           .description = "wall-clock time since the start of the run, with its earlier parts"},
          {.name = "particle_steps",
           .units = "1",
           .value = [](const Row& r) { return r.counts.particle_steps; },
           .description = "particles in the scene, summed over the steps since the start"},
          {.name = "bond_steps",
           .units = "1",
           .value = [](const Row& r) { return r.counts.bond_steps; },
           .description = "intact bonds, summed over the sub-steps since the start"},
          {.name = "list_rebuilds",
           .units = "1",
           .value = [](const Row& r) { return r.counts.rebuilds; },
           .description = "searches in space for neighbours since the start"},
      }};
  return table;
}

}  // namespace gyro
