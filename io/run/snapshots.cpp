// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshots.hpp"

#include "core/base/errors.hpp"
#include "io/run/snapshot_data.hpp"

#include <array>
#include <cstdio>
#include <optional>

namespace gyro {
namespace {

std::string frame_file(const std::string& kind, std::size_t frame) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "_%06zu.vtp", frame);
  return "snapshots/" + kind + number.data();
}

PolyData at(double time, PolyData data) {
  data.time = time;
  return data;
}

constexpr const char* fixed_file = "snapshots/walls_fixed.vtp";

}  // namespace

SnapshotWriter::SnapshotWriter(std::filesystem::path directory, std::vector<double> earlier)
    : directory_(std::move(directory)),
      times_(std::move(earlier)),
      has_fixed_(!times_.empty() && std::filesystem::exists(directory_ / fixed_file)),
      particles_{"particles", FrameIndex(directory_ / "particles.pvd")},
      bonds_{"bonds", FrameIndex(directory_ / "bonds.pvd")},
      walls_{"walls", FrameIndex(directory_ / "walls.pvd")},
      fragments_{"fragments", FrameIndex(directory_ / "fragments.pvd")} {
  std::error_code error;
  std::filesystem::create_directories(directory_ / "snapshots", error);
  if (error) throw OutputError((directory_ / "snapshots").string() + ": cannot make the directory: " + error.message());
  drop_later_frames();
}

/// Files of a frame, relative to the directory. @param numbered  whether it has a file of its own
std::vector<std::string> SnapshotWriter::parts(const std::string& kind, std::size_t frame, bool numbered) const {
  std::vector<std::string> files;
  if (numbered) files.push_back(frame_file(kind, frame));
  if (kind == walls_.name && has_fixed_) files.emplace_back(fixed_file);
  return files;
}

/// Removes frames that an earlier run has left. The indices are changed first, so that they never name a missing file.
void SnapshotWriter::drop_later_frames() {
  for (Kind* kind : {&particles_, &bonds_, &walls_, &fragments_}) {
    const auto file = [&](std::size_t frame) { return directory_ / frame_file(kind->name, frame); };
    if (!std::filesystem::exists(directory_ / (kind->name + ".pvd"))) continue;
    std::vector<std::vector<std::string>> kept;
    for (std::size_t frame = 0; frame < times_.size(); ++frame)
      kept.push_back(parts(kind->name, frame, std::filesystem::exists(file(frame))));
    kind->index.write(times_, kept);
    std::error_code error;
    for (std::size_t frame = times_.size(); std::filesystem::remove(file(frame), error); ++frame) {
    }
    if (error) throw OutputError(file(times_.size()).string() + ": cannot remove: " + error.message());
  }
}

void SnapshotWriter::write_fixed(std::span<const PosedWall> walls) {
  if (walls.empty() || has_fixed_) return;
  write_vtp(directory_ / fixed_file, wall_data(walls));
  has_fixed_ = true;
}

void SnapshotWriter::write(const SnapshotFrame& frame) {
  const std::size_t number = times_.size();
  const auto file = [&](const Kind& kind) { return directory_ / frame_file(kind.name, number); };
  if (frame.particles) write_vtp(file(particles_), at(frame.time, particle_data(*frame.particles)));
  if (frame.bonds) write_vtp(file(bonds_), at(frame.time, bond_data(*frame.bonds, *frame.particles)));
  if (!frame.walls.empty()) write_vtp(file(walls_), at(frame.time, wall_data(frame.walls)));
  if (frame.fragments) write_vtp(file(fragments_), at(frame.time, fragment_data(*frame.fragments)));
  times_.push_back(frame.time);
  // The indices are changed last, so that they never name a missing file.
  if (frame.particles) add_to_index(particles_, true);
  if (frame.bonds) add_to_index(bonds_, true);
  if (frame.fragments) add_to_index(fragments_, true);
  if (!frame.walls.empty() || has_fixed_) add_to_index(walls_, !frame.walls.empty());
}

void SnapshotWriter::add_to_index(Kind& kind, bool numbered) {
  kind.index.add(times_.back(), parts(kind.name, times_.size() - 1, numbered));
}

}  // namespace gyro
