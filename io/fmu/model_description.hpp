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
/// (rad counts as a number).
struct FmuUnit {
  std::array<int, 7> exponents{};
  double factor = 1, offset = 0;
};

struct FmuVariable {
  std::string name;
  fmi2ValueReference reference = 0;
  std::string type;       ///< Real, Integer, Boolean, String or Enumeration
  std::string causality;  ///< as parameter, input, output, local
  std::string unit;       ///< its name; empty: none is said
  bool unit_known = false;
  FmuUnit si{};  ///< where unit_known
};

/// What a modelDescription.xml says, as far as a master needs it.
struct ModelDescription {
  std::string model_name, guid, identifier, generation_tool;
  bool variable_step = false, state = false, serialisation = false;  ///< capability flags of CoSimulation
  bool needs_tool = false;                                           ///< says that it needs another program to run
  std::vector<FmuVariable> variables;

  const FmuVariable* find(std::string_view name) const;
};

/// Reads a modelDescription.xml. @throws BadInput unless it is of FMI 2.0 co-simulation
ModelDescription read_model_description(const std::string& xml);

/// What an exported FMU says of itself.
struct ModelIdentity {
  std::string name;  ///< of the model, free text
  std::string identifier, guid, tool;
  double stop_time = 1, step = 1e-3;  ///< proposed [s]
};

/// The modelDescription.xml of variables whose value references are their places.
std::string write_model_description(const ModelIdentity& identity, const std::vector<DriveVariable>& variables);

}  // namespace gyro
