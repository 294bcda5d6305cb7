// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace gyro::report {

/// Triangles of the walls, corners by index.
struct WallMesh {
  std::vector<float> positions;        ///< x, y, z of the corners [m]
  std::vector<std::uint32_t> corners;  ///< three for each triangle
  std::vector<std::uint8_t> cut;       ///< of each corner: 1 if the half before the axis is taken away
};

/// Particles and walls at one time, as many as the page can hold.
struct ViewFrame {
  double time = 0;                    ///< [s]
  std::vector<float> spheres;         ///< x, y, z, radius of each particle [m]
  std::vector<std::uint8_t> colours;  ///< of its fragment, 1 to 12; 0: a single particle
  std::size_t particles = 0;          ///< in the snapshot, of which the largest are here
  WallMesh walls;
};

struct ViewLimits {
  std::size_t frames = 8, particles = 30'000;
  std::size_t wall_cells = 36;  ///< cells across the largest extent of the walls, see simplified()
};

/// Numbers of at most so many frames, evenly chosen, with the first and the last. @param frames  that there are
std::vector<std::size_t> chosen_frames(std::size_t frames, std::size_t limit);

/// Frames of the snapshots of a run; none where it has no snapshots.
/// @throws BadInput with the path of a snapshot that cannot be read
std::vector<ViewFrame> read_frames(const std::filesystem::path& run, const ViewLimits& limits);

/// A mesh with one corner, the mean of all, for each cell of a grid: 60 sectors about the z axis, and cells of height
/// and distance from the axis. Triangles between fewer than three cells vanish. @param cell  [m]
WallMesh simplified(const WallMesh& mesh, double cell);

}  // namespace gyro::report
