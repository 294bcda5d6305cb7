// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/fmi/fmi2.hpp"

#include <filesystem>
#include <memory>

namespace gyro {

/// The functions of an FMU's shared library that a co-simulation master calls. Loading it runs its native code.
struct FmuLibrary {
  /// @throws BadInput if the file cannot be loaded or lacks a required function
  explicit FmuLibrary(const std::filesystem::path& file);

  std::shared_ptr<void> handle;  ///< closes the library when it is destroyed; functions are invalid after that
  fmi2GetVersionTYPE* get_version;
  fmi2InstantiateTYPE* instantiate;
  fmi2FreeInstanceTYPE* free_instance;
  fmi2SetupExperimentTYPE* setup_experiment;
  fmi2EnterInitializationModeTYPE* enter_initialisation;
  fmi2ExitInitializationModeTYPE* exit_initialisation;
  fmi2TerminateTYPE* terminate;
  fmi2GetRealTYPE* get_real;
  fmi2SetRealTYPE* set_real;
  fmi2SetIntegerTYPE* set_integer;
  fmi2SetBooleanTYPE* set_boolean;
  fmi2DoStepTYPE* do_step;
  // Null if the library lacks them:
  fmi2GetIntegerTYPE* get_integer;
  fmi2GetBooleanTYPE* get_boolean;
  fmi2GetFMUstateTYPE* get_state;
  fmi2SetFMUstateTYPE* set_state;
  fmi2FreeFMUstateTYPE* free_state;
  fmi2SerializedFMUstateSizeTYPE* serialised_size;
  fmi2SerializeFMUstateTYPE* serialise;
  fmi2DeSerializeFMUstateTYPE* deserialise;

  bool has_state() const { return get_state != nullptr && set_state != nullptr && free_state != nullptr; }
  bool has_serialisation() const {
    return serialised_size != nullptr && serialise != nullptr && deserialise != nullptr;
  }
};

}  // namespace gyro
