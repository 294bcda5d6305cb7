// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fragment_history.hpp"
#include "core/scene/dem.hpp"
#include "core/scene/scene.hpp"
#include "io/run/frame_index.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Loads of the rock on the triangles of a wall since the start of the run, one number for each triangle.
struct WallLoads {
  std::vector<double> pressure;      ///< mean [Pa]
  std::vector<double> sliding_work;  ///< work of friction [J]
  std::vector<double> wear;          ///< depth [m]; empty without a wear coefficient
};

/// A wall in its position at the time of a snapshot.
struct PosedWall {
  TriangleMesh mesh;  ///< world frame
  Index wall;         ///< number in Scene::walls
  std::optional<WallLoads> loads = {};
};

/// The contents of a frame. For an empty part no file and no index are written.
struct SnapshotFrame {
  double time = 0;  ///< [s]
  const ParticleSnapshot* particles = nullptr;
  const BondSnapshot* bonds = nullptr;    ///< needs particles
  std::span<const PosedWall> walls = {};  ///< those that change from frame to frame
  const FragmentSnapshot* fragments = nullptr;
};

/// A field of the files of a frame.
struct SnapshotField {
  std::string kind;  ///< of the file: "particles", "bonds", "walls", "fragments"
  std::string row;   ///< object that has a value, such as "particle"
  std::string name, units;
  int width;                ///< components
  std::string description;  ///< one line
};
std::vector<SnapshotField> snapshot_fields();

/// Writes snapshots/{particles,bonds,walls,fragments}_000123.vtp (VTK PolyData: binary, zlib, float32),
/// snapshots/walls_fixed.vtp once, and the ParaView indices {particles,bonds,walls,fragments}.pvd.
///
/// particles and fragments: points with one vertex cell, all fields at the points. bonds: one line for each bond, with
/// two points of its own; the radius is a field of the points, the others of the lines. walls: triangles with their
/// fields.
/// @throws OutputError if a file cannot be written
class SnapshotWriter {
 public:
  /// @param directory  of the run
  /// @param earlier  times of the frames that a resumed run keeps [s]; later frames are removed, and numbers continue
  explicit SnapshotWriter(std::filesystem::path directory, std::vector<double> earlier = {});
  /// Writes the walls that are the same in all frames. To be called before the first frame.
  void write_fixed(std::span<const PosedWall> walls);
  void write(const SnapshotFrame& frame);
  const std::vector<double>& times() const { return times_; }

 private:
  struct Kind {
    std::string name;
    FrameIndex index;
  };
  void add_to_index(Kind& kind, bool numbered);
  std::vector<std::string> parts(const std::string& kind, std::size_t frame, bool numbered) const;
  void drop_later_frames();

  std::filesystem::path directory_;
  std::vector<double> times_;
  bool has_fixed_ = false;
  Kind particles_, bonds_, walls_, fragments_;
};

}  // namespace gyro
