// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/fmi/drive_variable.hpp"
#include "mbd/fmi/fmi2.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// A unit of a modelDescription.xml: SI value = factor x value + offset, with the exponents of kg, m, s, A, K, mol, cd
/// (rad is treated as a pure number).
struct FmuUnit {
  std::array<int, 7> exponents{};
  double factor = 1, offset = 0;
};

struct FmuVariable {
  std::string name;
  fmi2ValueReference reference = 0;
  std::string type;       ///< Real, Integer, Boolean, String or Enumeration
  std::string causality;  ///< such as parameter, input, output, local
  std::string unit;       ///< its name; empty: none is declared
  bool unit_known = false;
  FmuUnit si{};  ///< if unit_known
};

/// The contents of a modelDescription.xml that a master needs.
struct ModelDescription {
  std::string model_name, guid, identifier, generation_tool;
  bool variable_step = false, state = false, serialisation = false;  ///< capability flags of CoSimulation
  bool needs_tool = false;                                           ///< the FMU needs another program to run
  std::vector<FmuVariable> variables;

  const FmuVariable* find(std::string_view name) const;
};

/// Reads a modelDescription.xml. @throws BadInput if it is not that of an FMI 2.0 co-simulation FMU
ModelDescription read_model_description(const std::string& xml);

/// Name, identification and default experiment of an exported FMU.
struct ModelIdentity {
  std::string name;  ///< of the model, free text
  std::string identifier, guid, tool;
  double stop_time = 1, step = 1e-3;  ///< default experiment [s]
};

/// The modelDescription.xml of a list of variables. The value reference of a variable is its index in the list.
std::string write_model_description(const ModelIdentity& identity, const std::vector<DriveVariable>& variables);

}  // namespace gyro
