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

/// A field of the files of a frame.
struct SnapshotField {
  std::string kind;  ///< of file: "particles", "bonds", "walls"
  std::string row;   ///< what it has a value for: "particle"
  std::string name, units;
  int width;                ///< components
  std::string description;  ///< one line
};
std::vector<SnapshotField> snapshot_fields();

/// Writes snapshots/{particles,bonds,walls}_000123.vtp (VTK PolyData: appended, zlib, float32) and the
/// ParaView indices {particles,bonds,walls}.pvd, replaced after each frame.
///
/// particles: points with one vertex cell, all fields at the points. bonds: one line each with its own two points;
/// radius at the points, the other fields at the lines. walls: triangles with their fields.
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
