// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/view3d/frames.hpp"

#include <string>

namespace gyro::report {

/// A frame as an HTML element with its bytes in base64, which view3d.js reads: x, y, z, radius of each particle
/// (float32), x, y, z of each corner of the walls (float32), three corners of each triangle (uint32), colour of each
/// particle and cut of each corner (uint8). Attributes say how many there are.
std::string html_frame(const ViewFrame& frame);

/// A slice of a frame through the axis as inline SVG, for print and for browsers without WebGL: the rock behind the
/// plane y = 0, and the outlines of the walls in it.
std::string slice_picture(const ViewFrame& frame);

}  // namespace gyro::report
