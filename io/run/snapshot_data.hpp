// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/poly_data.hpp"
#include "io/run/snapshots.hpp"

#include <span>

namespace gyro {

/// The parts of a frame with the fields of snapshot_fields(), without the time. SnapshotWriter describes their form.
PolyData particle_data(const ParticleSnapshot& particles);
PolyData bond_data(const BondSnapshot& bonds, const ParticleSnapshot& particles);
PolyData fragment_data(const FragmentSnapshot& fragments);
PolyData wall_data(std::span<const PosedWall> walls);

}  // namespace gyro
