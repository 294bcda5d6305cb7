// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/frame_index.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace gyro {
namespace {

constexpr const char* head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "  <Collection>\n";
constexpr const char* tail = "  </Collection>\n</VTKFile>\n";

std::string lines_of(double time, std::span<const std::string> parts) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "%.12g", time);
  std::string lines;
  for (std::size_t part = 0; part < parts.size(); ++part)
    lines += "    <DataSet timestep=\"" + std::string(number.data()) + "\" part=\"" + std::to_string(part) +
             "\" file=\"" + parts[part] + "\"/>\n";
  return lines;
}

}  // namespace

FrameIndex::FrameIndex(std::filesystem::path file) : file_(std::move(file), head, tail) {}

void FrameIndex::write(std::span<const double> times, std::span<const std::vector<std::string>> parts) {
  std::vector<std::string> frames;
  for (std::size_t frame = 0; frame < times.size(); ++frame) frames.push_back(lines_of(times[frame], parts[frame]));
  file_.write(frames);
}

void FrameIndex::add(double time, std::span<const std::string> parts) {
  file_.add(lines_of(time, parts));
}

}  // namespace gyro
