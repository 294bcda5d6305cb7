// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/fmu_library.hpp"

#include "core/base/errors.hpp"

#include <dlfcn.h>
#include <string>

namespace gyro {

FmuLibrary::FmuLibrary(const std::filesystem::path& file) {
  // RTLD_NOW reports missing symbols here; RTLD_LOCAL keeps the symbols of two FMUs apart.
  void* const opened = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (opened == nullptr) {
    const char* reason = dlerror();
    const std::string text = reason != nullptr ? reason : "unknown reason";
    // Some FMUs rely on a host program that contains an interpreter.
    const bool lacks = text.find("undefined symbol") != std::string::npos;
    throw BadInput(
        "its library cannot be loaded: " + text +
        (lacks ? "; if another library has it, start the command with LD_PRELOAD=LIBRARY (a PythonFMU needs libpython3)"
               : ""));
  }
  handle = std::shared_ptr<void>(opened, [](void* library) { dlclose(library); });
  const auto find = [&](auto*& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(opened, name));
    if (function == nullptr) throw BadInput("its library has no " + std::string(name) + "; FMI 2.0 requires it");
  };
  find(get_version, "fmi2GetVersion");
  find(instantiate, "fmi2Instantiate");
  find(free_instance, "fmi2FreeInstance");
  find(setup_experiment, "fmi2SetupExperiment");
  find(enter_initialisation, "fmi2EnterInitializationMode");
  find(exit_initialisation, "fmi2ExitInitializationMode");
  find(terminate, "fmi2Terminate");
  find(get_real, "fmi2GetReal");
  find(set_real, "fmi2SetReal");
  find(set_integer, "fmi2SetInteger");
  find(set_boolean, "fmi2SetBoolean");
  find(do_step, "fmi2DoStep");
  // FMUs without this capability may lack these functions, against the standard; if they declare it, FmuDrive checks.
  const auto find_if_there = [&](auto*& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(opened, name));
  };
  find_if_there(get_integer, "fmi2GetInteger");
  find_if_there(get_boolean, "fmi2GetBoolean");
  find_if_there(get_state, "fmi2GetFMUstate");
  find_if_there(set_state, "fmi2SetFMUstate");
  find_if_there(free_state, "fmi2FreeFMUstate");
  find_if_there(serialised_size, "fmi2SerializedFMUstateSize");
  find_if_there(serialise, "fmi2SerializeFMUstate");
  find_if_there(deserialise, "fmi2DeSerializeFMUstate");
  if (const std::string version = get_version(); version != "2.0")
    throw BadInput("its library is of FMI " + version + "; it must be 2.0");
}

}  // namespace gyro
