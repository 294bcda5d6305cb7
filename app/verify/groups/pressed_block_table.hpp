// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace gyro::verify {

/// The pressed block at one time.
struct PressedBlock {
  double time = 0;                       ///< [s]
  double translation = 0, rotation = 0;  ///< kinetic energies of the spheres [J]
  double stretch = 0;                    ///< energy of the bonds' normal springs [J]
  double bottom = 0, top = 0;            ///< forces on the plates, positive outwards; means since the last row [N]
  double bonds = 0;                      ///< number of intact bonds
};

/// The results of LAMMPS in order of time: the rows of cases/verification/pressed_block/lammps.csv.
std::vector<PressedBlock> pressed_block_table();

}  // namespace gyro::verify
