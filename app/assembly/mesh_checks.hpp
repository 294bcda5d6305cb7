// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/walls/mesh_setting.hpp"
#include "io/case/case.hpp"

#include <string>
#include <vector>

// Checks of what mesh files do not contain: unit, frame, position. Meshes are in metres, z upwards along the machine's
// axis.

namespace gyro {

/// Name of a wall and its file, as the beginning of notes about it.
std::string name_of(const CaseWall& wall, const MeshFile& file);

/// @throws BadInput for a mesh of more than 1 km or less than 0.01 mm, with its extents
void check_extent(const TriangleMesh& mesh, const MeshFile& file);

/// Notes if a liner seems not to be upright on the machine's axis, each with the key that corrects it.
std::vector<std::string> frame_notes(const CaseWall& wall, const MeshFile& file, const TriangleMesh& liner);

/// Notes if the mantle seems not to fit the concave as drawn.
/// @param height  of the concave above the discharge plane [m]
std::vector<std::string> setting_notes(const MeshSetting& setting, const GyrationMotion& motion, double height);

/// Notes on meshes and profiles larger than 100 m, or than 1000 times the largest rock.
/// @param rock  extent of the largest rock; 0 if there is none [m]
std::vector<std::string> size_notes(const Case& input, const std::vector<Wall>& walls, double rock);

}  // namespace gyro
