// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fields/field_group.hpp"
#include "io/run/index_file.hpp"
#include "io/run/snapshots.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// fields.h5 of a run: the same snapshots as the .vtp files in one HDF5 file, compressed, with what does not change
/// stored once. Groups: /VTKHDF (particles), /fragments, /bonds, /liners (walls that change), /liners_fixed (FieldGroup
/// has their form). Beside it: fields.xdmf for ParaView 5.11 and older, and in the folder `fields` KIND.xdmf for one
/// kind alone and KIND.vtkhdf for ParaView 5.12 and newer, which are names for the groups of fields.h5.
///
/// Between frames the file is closed, so that any program can read it. If the process is killed while a frame is
/// written, the frames before it remain; programs then open the file after `h5clear -s --increment=0 fields.h5`, or
/// when the run was resumed.
/// @throws OutputError if a file cannot be written
class FieldsFile {
 public:
  /// @param directory  of the run
  /// @param earlier  times of the frames that a resumed run keeps [s]; later ones no longer count, and their rows
  /// remain unused
  /// @throws BadInput if the file is missing or damaged, or has other frames
  explicit FieldsFile(std::filesystem::path directory, const std::vector<double>& earlier = {});
  /// Takes the walls that are the same in all frames. To be called before the first frame.
  void take_fixed(std::span<const PosedWall> walls);
  void write(const SnapshotFrame& frame);
  /// Waits until all frames are on the disk.
  void sync() const;

 private:
  /// What a frame has of one kind.
  struct Part {
    std::string kind, group;
    PolyData data;
  };
  std::vector<Part> parts_of(const SnapshotFrame& frame) const;
  void create(const std::vector<Part>& parts);
  void add_to_indices(const hdf5::File& file, std::int64_t number);
  void keep_frames(const std::vector<double>& earlier);
  void count_frames(hdf5::File& counts, std::int64_t frames);
  IndexFile& index(const std::string& kind);
  std::filesystem::path file() const { return directory_ / "fields.h5"; }

  std::filesystem::path directory_;
  std::optional<PolyData> fixed_;
  std::int64_t frames_ = 0;
  std::map<std::string, FieldGroup> groups_;   ///< by kind
  std::map<std::string, IndexFile> of_kinds_;  ///< by kind
  IndexFile of_all_;
};

}  // namespace gyro
