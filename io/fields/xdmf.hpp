// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fields/field_frame.hpp"

#include <string>

namespace gyro {

/// The text before and after the frames of an XDMF 3 file (xdmf.org): one collection over time.
extern const char* const xdmf_head;
extern const char* const xdmf_tail;

/// The grid of a frame, without its time. Its numbers lie in the HDF5 file.
/// A frame without cells becomes a point at the origin whose fields are 0: ParaView 5.11 aborts on an empty grid, and
/// shows the grid of another time where there is none.
/// @param name  of the grid  @param file  fields.h5, relative to the folder of the XDMF file
std::string xdmf_grid(const FieldFrame& frame, const std::string& name, const std::string& file);
/// Grids of the same time as one.
std::string xdmf_collection(double time, const std::string& grids);
/// A grid with its time.
std::string xdmf_timed(double time, std::string grid);

}  // namespace gyro
