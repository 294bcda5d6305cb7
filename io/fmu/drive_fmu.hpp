// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fmu/model_description.hpp"
#include "mbd/fmi/fmu_process.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace gyro {

/// A drivetrain FMU as a case asks for it: described and connected, but none of its native code has run.
struct DriveFmu {
  std::filesystem::path file;  ///< absolute
  std::string model_name, generation_tool, guid, identifier;
  bool variable_step = false, state = false, serialisation = false, needs_tool = false;
  FmuLinks links{};
  std::optional<FmuHistory> history;
  std::vector<FmuStart> starts;
};

/// A quantity's name in cases, and what its unit must be.
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
/// @throws BadInput when it does not exist (the message lists those that do), has another type or causality, or another
/// unit
FmuLink link_to(const ModelDescription& model, FmuQuantity quantity, std::string wanted);

/// Where an exported drivetrain remembers its events: variables events, event_time[1], event_kind[1] and so on.
std::optional<FmuHistory> history_of(const ModelDescription& model);

/// An FMU as described, not yet linked. @param file  absolute
DriveFmu unconnected(const std::filesystem::path& file, const ModelDescription& model);

/// A parameter and its start value. @throws BadInput when it does not exist or cannot have this value
FmuStart start_of(const ModelDescription& model, const std::string& name, double value);

/// Unpacks an FMU, loads its library, which is native code, in a process of its own, and initialises it.
/// @param patience  how long one call may take
/// @throws BadInput, OutputError
std::unique_ptr<Drive> open_drive(const DriveFmu& fmu,
                                  std::chrono::milliseconds patience = FmuProcess::default_patience);

}  // namespace gyro
