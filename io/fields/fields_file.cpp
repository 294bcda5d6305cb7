// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/fields_file.hpp"

#include "core/base/errors.hpp"
#include "io/fields/xdmf.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/snapshot_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gyro {
namespace {

constexpr const char* folder = "fields";  // of the files for one kind
constexpr const char* seen_from_folder = "../fields.h5";

/// A kind of data: its name, its group, and its name in the table of fields.
struct Kind {
  const char *name, *group, *in_table;
};

/// In the order in which their frames are counted. Particles are last, so that a frame of particles has all else that
/// belongs to it.
constexpr Kind kinds[] = {{"bonds", "/bonds", "bonds"},
                          {"liners", "/liners", "walls"},
                          {"liners_fixed", "/liners_fixed", "walls"},
                          {"fragments", "/fragments", "fragments"},
                          {"particles", "/VTKHDF", "particles"}};
constexpr const Kind& bonds = kinds[0];
constexpr const Kind& liners = kinds[1];
constexpr const Kind& liners_fixed = kinds[2];
constexpr const Kind& fragments = kinds[3];
constexpr const Kind& particles = kinds[4];

std::vector<SnapshotField> fields_of(const Kind& kind) {
  std::vector<SnapshotField> fields = snapshot_fields();
  std::erase_if(fields, [&](const SnapshotField& field) { return field.kind != kind.in_table; });
  return fields;
}

constexpr const char* advice = "restore the file, or use --overwrite to start the run again";

/// @throws BadInput unless a file has the frames that a resumed run keeps
void require_frames(const hdf5::File& file, const std::vector<double>& earlier) {
  const std::int64_t written = frame_count(file, particles.group);
  const std::vector<double> times = file.dataset(std::string(particles.group) + "/Steps/Values").read();
  if (written < static_cast<std::int64_t>(earlier.size()) || times.size() < earlier.size())
    throw BadInput("has " + std::to_string(written) + " frames, not the " + std::to_string(earlier.size()) +
                   " before the checkpoint");
  for (std::size_t frame = 0; frame < earlier.size(); ++frame)
    if (times[frame] != earlier[frame])
      throw BadInput("has a frame at " + std::to_string(times[frame]) + " s, which this run did not write");
}

/// A name for a group of fields.h5 that VTK opens by itself.
void write_link(const std::filesystem::path& path, const char* group) {
  const std::filesystem::path made = path.string() + ".tmp";
  hdf5::File file = hdf5::File::create(made);
  file.link_to_file("/VTKHDF", seen_from_folder, group);
  file.close();
  put_in_place(path);
}

}  // namespace

FieldsFile::FieldsFile(std::filesystem::path directory, const std::vector<double>& earlier)
    : directory_(std::move(directory)), of_all_(directory_ / "fields.xdmf", xdmf_head, xdmf_tail) {
  std::error_code error;
  std::filesystem::create_directories(directory_ / folder, error);
  if (error) throw OutputError((directory_ / folder).string() + ": cannot make the directory: " + error.message());
  std::filesystem::remove(file().string() + ".tmp", error);
  if (earlier.empty())
    std::filesystem::remove(file(), error);
  else
    keep_frames(earlier);
}

IndexFile& FieldsFile::index(const std::string& kind) {
  return of_kinds_.try_emplace(kind, directory_ / folder / (kind + ".xdmf"), xdmf_head, xdmf_tail).first->second;
}

void FieldsFile::take_fixed(std::span<const PosedWall> walls) {
  if (!walls.empty()) fixed_ = wall_data(walls);
}

std::vector<FieldsFile::Part> FieldsFile::parts_of(const SnapshotFrame& frame) const {
  std::vector<Part> parts;
  const auto add = [&](const Kind& kind, PolyData data) {
    data.time = frame.time;
    parts.push_back({kind.name, kind.group, std::move(data)});
  };
  if (frame.bonds) add(bonds, bond_data(*frame.bonds, *frame.particles));
  if (!frame.walls.empty()) add(liners, wall_data(frame.walls));
  if (fixed_) add(liners_fixed, *fixed_);
  if (frame.fragments) add(fragments, fragment_data(*frame.fragments));
  if (frame.particles) add(particles, particle_data(*frame.particles));
  return parts;
}

void FieldsFile::create(const std::vector<Part>& parts) {
  const std::filesystem::path made = file().string() + ".tmp";
  hdf5::File created = hdf5::File::create(made);
  for (const Part& part : parts)
    for (const Kind& kind : kinds)
      if (kind.name == part.kind) FieldGroup::create(created, part.group, part.data, fields_of(kind));
  created.close();
  put_in_place(file());
  for (const Part& part : parts) write_link(directory_ / folder / (part.kind + ".vtkhdf"), part.group.c_str());
}

void FieldsFile::write(const SnapshotFrame& frame) {
  const std::vector<Part> parts = parts_of(frame);
  if (!std::filesystem::exists(file())) create(parts);
  hdf5::File rows = hdf5::File::append_to(file());
  for (const Part& part : parts)
    groups_.try_emplace(part.kind, part.group, part.data, frames_).first->second.append(rows, part.data);
  rows.close();
  hdf5::File counts = hdf5::File::change(file());
  for (const Part& part : parts) groups_.at(part.kind).count(counts);
  counts.close();
  add_to_indices(hdf5::File::open_closed(file()), frames_++);
}

void FieldsFile::sync() const {
  if (std::filesystem::exists(file())) sync_file(file());
}

/// Lets only the frames count that the run keeps, and writes the indices of these.
void FieldsFile::keep_frames(const std::vector<double>& earlier) {
  try {
    if (!std::filesystem::exists(file())) throw BadInput("is missing");
    hdf5::File::modify(file()).close();  // removes the mark of a writer that was killed
    hdf5::File counts = hdf5::File::change(file());
    require_frames(counts, earlier);
    count_frames(counts, static_cast<std::int64_t>(earlier.size()));
    counts.close();
  } catch (const BadInput& problem) {
    throw BadInput(file().string() + ": " + problem.what() + "; " + advice);
  } catch (const OutputError& problem) {
    throw BadInput(file().string() + ": is damaged (" + problem.what() + "); " + advice);
  }
}

void FieldsFile::count_frames(hdf5::File& counts, std::int64_t frames) {
  frames_ = frames;
  of_all_.write({});
  for (const Kind& kind : kinds) {
    if (!counts.contains(kind.group)) continue;
    counts.overwrite_integer(std::string(kind.group) + "/Steps", "NSteps", frames_);
    index(kind.name).write({});
  }
  for (std::int64_t frame = 0; frame < frames_; ++frame) add_to_indices(counts, frame);
}

void FieldsFile::add_to_indices(const hdf5::File& file, std::int64_t number) {
  std::string grids;
  double time = 0;
  for (const Kind& kind : kinds) {
    if (!file.contains(kind.group)) continue;
    const FieldFrame frame = read_frame(file, kind.group, number);
    index(kind.name).add(xdmf_timed(frame.time, xdmf_grid(frame, kind.name, seen_from_folder)));
    grids += xdmf_grid(frame, kind.name, "fields.h5");
    time = frame.time;
  }
  of_all_.add(xdmf_collection(time, grids));
}

}  // namespace gyro
