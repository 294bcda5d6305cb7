// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drivetrain_parameters.hpp"

#include <filesystem>
#include <string>

namespace gyro {

/// A drivetrain that is to be exported as an FMU.
struct DriveExport {
  DrivetrainParameters drive;
  std::string title, tool;            ///< of the case; name and version of this program
  double stop_time = 1, step = 1e-3;  ///< default experiment for masters [s]
  std::filesystem::path library;      ///< path of gyro_drivetrain_fmu.so
};

/// Writes an FMI 2.0 co-simulation FMU for linux64: the description, the library, and the parameters as
/// resources/drivetrain.txt. The same drive and library give the same bytes.
/// @throws BadInput if the drive cannot start; OutputError
void export_drive(const DriveExport& what, const std::filesystem::path& file);

}  // namespace gyro
