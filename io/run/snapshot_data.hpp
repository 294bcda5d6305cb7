// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/snapshots.hpp"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <span>

namespace gyro {

/// The parts of a frame as VTK data with the fields of snapshot_fields(); see SnapshotWriter for their form.
vtkNew<vtkPolyData> particle_data(const ParticleSnapshot& particles);
vtkNew<vtkPolyData> bond_data(const BondSnapshot& bonds, const ParticleSnapshot& particles);
vtkNew<vtkPolyData> wall_data(std::span<const PosedWall> walls);

}  // namespace gyro
