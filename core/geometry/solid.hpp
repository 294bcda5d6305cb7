// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace gyro {

/// A mesh and its repairs, one sentence each, for the log.
struct RepairedMesh {
  TriangleMesh mesh;
  std::vector<std::string> notes;
};

/// Prepares a mesh that was read from a file. Welds vertices that coincide within 1e-7 of the mesh's diagonal; drops
/// triangles without area and repeated triangles, with a note. Open meshes stay open.
/// @throws BadInput if no triangle is left, or coordinates are too large
RepairedMesh repaired_surface(const TriangleMesh& given);

/// Prepares a mesh that must be one closed body, such as a rock. Repairs the usual faults of scans and notes each
/// repair: welds vertices up to 1e-4 of the diagonal apart if that closes the surface, drops floating specks (below 1 %
/// of the volume), flips triangles so that all normals point outwards, closes holes of up to 1 % of the surface.
/// @throws BadInput as repaired_surface; for larger holes, edges of more than two triangles, several bodies, no volume
RepairedMesh repaired_solid(const TriangleMesh& given);

}  // namespace gyro
