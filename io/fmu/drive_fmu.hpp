// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fmu/model_description.hpp"
#include "mbd/fmi/fmu_process.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace gyro {

/// A drivetrain FMU as a case requests it: its description is read and its variables are connected, but none of its
/// native code has run.
struct DriveFmu {
  std::filesystem::path file;  ///< absolute
  std::string model_name, generation_tool, guid, identifier;
  bool variable_step = false, state = false, serialisation = false, needs_tool = false;
  FmuLinks links{};
  std::optional<FmuHistory> history;
  std::vector<FmuStart> starts;
};

/// The name of a quantity in cases, and the dimension of its unit.
struct FmuQuantityInfo {
  std::string_view name;
  std::array<int, 7> exponents;  ///< of kg, m, s, A, K, mol, cd
  bool required = false;
};
const FmuQuantityInfo& info_of(FmuQuantity quantity);

/// Reads the description of an FMU and checks that it has a library for this platform.
/// @throws BadInput for a file that is not an FMI 2.0 co-simulation FMU for linux64
ModelDescription read_fmu(const std::filesystem::path& file);

/// The variable of an FMU for a quantity. @param wanted  its name; a leading minus reverses its sign
/// @throws BadInput if it does not exist (the message lists the existing ones), or has a wrong type, causality or unit
FmuLink link_to(const ModelDescription& model, FmuQuantity quantity, std::string wanted);

/// The variables in which an exported drivetrain stores its events: events, event_time[1], event_kind[1] and so on.
/// Empty if the FMU does not have them.
std::optional<FmuHistory> history_of(const ModelDescription& model);

/// An FMU with its description, whose variables are not connected yet. @param file  absolute
DriveFmu unconnected(const std::filesystem::path& file, const ModelDescription& model);

/// A parameter and its start value. @throws BadInput if it does not exist or cannot have this value
FmuStart start_of(const ModelDescription& model, const std::string& name, double value);

/// Unpacks an FMU, loads its library, which is native code, in a separate process, and initialises it.
/// @param patience  longest time that one call may take
/// @throws BadInput, OutputError
std::unique_ptr<Drive> open_drive(const DriveFmu& fmu,
                                  std::chrono::milliseconds patience = FmuProcess::default_patience);

}  // namespace gyro
