// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshots.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/snapshot_data.hpp"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>
#include <array>
#include <cstdio>

namespace gyro {
namespace {

void write_data(const std::filesystem::path& path, vtkPolyData* data, double time) {
  vtkNew<vtkDoubleArray> stamp;
  stamp->SetName("TimeValue");
  stamp->InsertNextValue(time);
  data->GetFieldData()->AddArray(stamp);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  // Into memory, because VTK does not report every failed write to a file.
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw OutputError(path.string() + ": cannot write: VTK could not put the data together");
  replace_file(path, writer->GetOutputString());
}

std::string frame_file(const std::string& kind, std::size_t frame) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "_%06zu.vtp", frame);
  return "snapshots/" + kind + number.data();
}

}  // namespace

SnapshotWriter::SnapshotWriter(std::filesystem::path directory, std::vector<double> earlier)
    : directory_(std::move(directory)), times_(std::move(earlier)) {
  std::error_code error;
  std::filesystem::create_directories(directory_ / "snapshots", error);
  if (error) throw OutputError((directory_ / "snapshots").string() + ": cannot make it: " + error.message());
  drop_later_frames();
}

/// Frames that another run left behind: indices first, so that they never name a missing file.
void SnapshotWriter::drop_later_frames() const {
  const auto file = [this](const char* kind, std::size_t frame) { return directory_ / frame_file(kind, frame); };
  for (const char* kind : {"particles", "bonds", "walls"}) {
    if (!std::filesystem::exists(file(kind, times_.size()))) continue;
    write_index(kind);
    std::error_code error;
    for (std::size_t frame = times_.size(); std::filesystem::remove(file(kind, frame), error); ++frame) {
    }
    if (error) throw OutputError(file(kind, times_.size()).string() + ": cannot remove: " + error.message());
  }
}

void SnapshotWriter::write(const SnapshotFrame& frame) {
  const std::size_t number = times_.size();
  if (frame.particles)
    write_data(directory_ / frame_file("particles", number), particle_data(*frame.particles), frame.time);
  if (frame.bonds)
    write_data(directory_ / frame_file("bonds", number), bond_data(*frame.bonds, *frame.particles), frame.time);
  if (!frame.walls.empty()) write_data(directory_ / frame_file("walls", number), wall_data(frame.walls), frame.time);
  times_.push_back(frame.time);
  // The indices last: they never name a file that is not there.
  if (frame.particles) write_index("particles");
  if (frame.bonds) write_index("bonds");
  if (!frame.walls.empty()) write_index("walls");
}

void SnapshotWriter::write_index(const std::string& kind) const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (std::size_t frame = 0; frame < times_.size(); ++frame) {
    std::array<char, 32> time;
    std::snprintf(time.data(), time.size(), "%.12g", times_[frame]);
    text += "    <DataSet timestep=\"" + std::string(time.data()) + "\" part=\"0\" file=\"" + frame_file(kind, frame) +
            "\"/>\n";
  }
  replace_file(directory_ / (kind + ".pvd"), text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace gyro
