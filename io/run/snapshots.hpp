// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// A wall as it stands in the world at the time of a snapshot.
struct PosedWall {
  TriangleMesh mesh;  ///< world frame
  Index wall;         ///< number in Scene::walls
};

/// What a frame shows; an empty part writes no file and gets no index.
struct SnapshotFrame {
  double time = 0;
  const ParticleSnapshot* particles = nullptr;
  const BondSnapshot* bonds = nullptr;  ///< needs particles
  std::span<const PosedWall> walls = {};
};

/// Writes snapshots/{particles,bonds,walls}_000123.vtp (VTK PolyData: appended, zlib, float32) and the
/// ParaView indices {particles,bonds,walls}.pvd, replaced after each frame.
///
/// particles: points with one vertex cell; id, rock, fragment (id of the fragment's first particle, so that
/// it stays the same over frames), radius, mass, velocity, force.
/// bonds: one line each with its own two points; cell data normal_force, stress_ratio; point data radius
/// (the Tube filter needs it there). walls: triangles; cell data wall.
/// @throws OutputError when a file cannot be written
class SnapshotWriter {
 public:
  /// @param directory the run's directory
  /// @param earlier times of frames that a resumed run keeps; later ones are removed, numbering continues after them
  explicit SnapshotWriter(std::filesystem::path directory, std::vector<double> earlier = {});
  void write(const SnapshotFrame& frame);
  const std::vector<double>& times() const { return times_; }

 private:
  void write_index(const std::string& kind) const;
  void drop_later_frames() const;

  std::filesystem::path directory_;
  std::vector<double> times_;
};

}  // namespace gyro
