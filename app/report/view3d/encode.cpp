// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/view3d/encode.hpp"

#include "io/files/base64.hpp"

#include <array>
#include <cstdio>

namespace gyro::report {
namespace {

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string data(const char* name, std::size_t value) {
  return std::string(" data-") + name + "=\"" + std::to_string(value) + "\"";
}

}  // namespace

std::string html_frame(const ViewFrame& frame) {
  std::string bytes;
  append(bytes, frame.spheres);
  append(bytes, frame.walls.positions);
  append(bytes, frame.walls.corners);
  append(bytes, frame.colours);
  append(bytes, frame.walls.cut);
  std::array<char, 32> time;
  std::snprintf(time.data(), time.size(), "%.6g", frame.time);
  return "<script type=\"text/plain\" class=\"frame\" data-time=\"" + std::string(time.data()) + "\"" +
         data("spheres", frame.colours.size()) + data("particles", frame.particles) +
         data("corners", frame.walls.cut.size()) + data("triangles", frame.walls.corners.size() / 3) + ">" +
         base64(bytes) + "</script>\n";
}

}  // namespace gyro::report
