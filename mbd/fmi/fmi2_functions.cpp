// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/fmi2_instance.hpp"

#include <cstring>
#include <exception>

// The functions of the shared library of an exported FMU: FMI 2.0 co-simulation over Fmi2Instance. They throw nothing.

#define GYRO_FMI extern "C" __attribute__((visibility("default")))

namespace {

using namespace gyro;

constexpr unsigned bit(SlaveMode mode) {
  return static_cast<unsigned>(mode);
}
constexpr unsigned before_steps = bit(SlaveMode::instantiated) | bit(SlaveMode::initialising);

/// Does `work` on an instance that is in one of these modes; an exception becomes a log message and fmi2Error.
template <class Work>
fmi2Status guarded(fmi2Component component, unsigned modes, const char* function, Work&& work) {
  if (component == nullptr) return fmi2Error;
  Fmi2Instance& instance = *static_cast<Fmi2Instance*>(component);
  if ((bit(instance.mode) & modes) == 0) {
    instance.log(fmi2Error, std::string(function) + " is not allowed at this stage");
    return fmi2Error;
  }
  try {
    work(instance);
    return fmi2OK;
  } catch (const std::exception& problem) {
    instance.log(fmi2Error, std::string(function) + ": " + problem.what());
    return fmi2Error;
  }
}

template <class Value>
fmi2Status get(fmi2Component component, const char* function, VariableType type, const fmi2ValueReference references[],
               std::size_t count, Value values[]) {
  return guarded(component, any_mode, function, [&](Fmi2Instance& instance) {
    for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Value>(instance.get(references[k], type));
  });
}

template <class Value>
fmi2Status set(fmi2Component component, const char* function, VariableType type, const fmi2ValueReference references[],
               std::size_t count, const Value values[]) {
  return guarded(component, before_steps | bit(SlaveMode::stepping), function, [&](Fmi2Instance& instance) {
    for (std::size_t k = 0; k < count; ++k) instance.set(references[k], type, static_cast<double>(values[k]));
  });
}

/// For functions that this FMU does not support, as its modelDescription.xml declares.
fmi2Status refuse(fmi2Component component, const char* function) {
  return guarded(component, any_mode, function,
                 [](Fmi2Instance&) { throw std::runtime_error("this FMU does not support this function"); });
}

}  // namespace

GYRO_FMI const char* fmi2GetTypesPlatform() {
  return "default";
}
GYRO_FMI const char* fmi2GetVersion() {
  return "2.0";
}

GYRO_FMI fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                       const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean) {
  const auto complain = [&](const char* problem) {
    if (functions != nullptr && functions->logger != nullptr)
      functions->logger(functions->componentEnvironment, name, fmi2Error, "logStatusError", "%s", problem);
  };
  if (functions == nullptr || name == nullptr || guid == nullptr || resources == nullptr || type != fmi2CoSimulation) {
    complain("fmi2Instantiate: a name, the GUID, the resources and the type co-simulation are needed");
    return nullptr;
  }
  try {
    return new Fmi2Instance(name, *functions, guid, resources);
  } catch (const std::exception& problem) {
    complain(problem.what());
    return nullptr;
  }
}

GYRO_FMI void fmi2FreeInstance(fmi2Component component) {
  delete static_cast<Fmi2Instance*>(component);
}

GYRO_FMI fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, std::size_t, const fmi2String[]) {
  return guarded(component, any_mode, "fmi2SetDebugLogging", [](Fmi2Instance&) {});
}

GYRO_FMI fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean,
                                        fmi2Real) {
  return guarded(component, bit(SlaveMode::instantiated), "fmi2SetupExperiment", [&](Fmi2Instance& instance) {
    instance.start_time = start;
    instance.changed = true;
  });
}

GYRO_FMI fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return guarded(component, bit(SlaveMode::instantiated), "fmi2EnterInitializationMode",
                 [](Fmi2Instance& instance) { instance.mode = SlaveMode::initialising; });
}

GYRO_FMI fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  return guarded(component, bit(SlaveMode::initialising), "fmi2ExitInitializationMode", [](Fmi2Instance& instance) {
    instance.apply_changes();
    instance.mode = SlaveMode::stepping;
  });
}

GYRO_FMI fmi2Status fmi2Terminate(fmi2Component component) {
  return guarded(component, bit(SlaveMode::stepping), "fmi2Terminate",
                 [](Fmi2Instance& instance) { instance.mode = SlaveMode::terminated; });
}

GYRO_FMI fmi2Status fmi2Reset(fmi2Component component) {
  return guarded(component, any_mode, "fmi2Reset", [](Fmi2Instance& instance) {
    instance.slave = std::make_unique<DriveSlave>(instance.as_exported);
    instance.mode = SlaveMode::instantiated;
    instance.changed = false;
    instance.start_time = 0;
  });
}

GYRO_FMI fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference r[], std::size_t n, fmi2Real v[]) {
  return get(c, "fmi2GetReal", VariableType::real, r, n, v);
}
GYRO_FMI fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference r[], std::size_t n, fmi2Integer v[]) {
  return get(c, "fmi2GetInteger", VariableType::integer, r, n, v);
}
GYRO_FMI fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference r[], std::size_t n, fmi2Boolean v[]) {
  return get(c, "fmi2GetBoolean", VariableType::boolean, r, n, v);
}
GYRO_FMI fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference[], std::size_t n, fmi2String[]) {
  return n == 0 ? fmi2OK : refuse(c, "fmi2GetString");
}
GYRO_FMI fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference r[], std::size_t n, const fmi2Real v[]) {
  return set(c, "fmi2SetReal", VariableType::real, r, n, v);
}
GYRO_FMI fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference r[], std::size_t n,
                                   const fmi2Integer v[]) {
  return set(c, "fmi2SetInteger", VariableType::integer, r, n, v);
}
GYRO_FMI fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference r[], std::size_t n,
                                   const fmi2Boolean v[]) {
  return set(c, "fmi2SetBoolean", VariableType::boolean, r, n, v);
}
GYRO_FMI fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference[], std::size_t n, const fmi2String[]) {
  return n == 0 ? fmi2OK : refuse(c, "fmi2SetString");
}

GYRO_FMI fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return guarded(component, any_mode, "fmi2GetFMUstate", [&](Fmi2Instance& instance) {
    instance.apply_changes();
    if (*state == nullptr) *state = new SavedSlave;
    *static_cast<SavedSlave*>(*state) = {instance.mode, instance.slave->state(), instance.slave->parameter_values()};
  });
}

GYRO_FMI fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return guarded(component, any_mode, "fmi2SetFMUstate", [&](Fmi2Instance& instance) {
    const SavedSlave& saved = *static_cast<SavedSlave*>(state);
    instance.slave->restore(saved.state, saved.parameters);
    instance.mode = saved.mode;
    instance.changed = false;
  });
}

GYRO_FMI fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return guarded(component, any_mode, "fmi2FreeFMUstate", [&](Fmi2Instance&) {
    delete static_cast<SavedSlave*>(*state);
    *state = nullptr;
  });
}

GYRO_FMI fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, std::size_t* size) {
  return guarded(component, any_mode, "fmi2SerializedFMUstateSize",
                 [&](Fmi2Instance&) { *size = static_cast<SavedSlave*>(state)->bytes().size(); });
}

GYRO_FMI fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[],
                                          std::size_t size) {
  return guarded(component, any_mode, "fmi2SerializeFMUstate", [&](Fmi2Instance&) {
    const std::vector<char> saved = static_cast<SavedSlave*>(state)->bytes();
    if (size < saved.size()) throw std::runtime_error("the buffer for the state is too small");
    std::memcpy(bytes, saved.data(), saved.size());
  });
}

GYRO_FMI fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], std::size_t size,
                                            fmi2FMUstate* state) {
  return guarded(component, any_mode, "fmi2DeSerializeFMUstate", [&](Fmi2Instance& instance) {
    SavedSlave saved = SavedSlave::from_bytes(bytes, size);
    if (saved.parameters.size() != instance.slave->parameter_values().size())
      throw std::runtime_error("these bytes are the state of another FMU");
    if (*state == nullptr) *state = new SavedSlave;
    *static_cast<SavedSlave*>(*state) = std::move(saved);
  });
}

GYRO_FMI fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference[], std::size_t,
                                                 const fmi2ValueReference[], std::size_t, const fmi2Real[],
                                                 fmi2Real[]) {
  return refuse(c, "fmi2GetDirectionalDerivative");
}
GYRO_FMI fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t,
                                                const fmi2Integer[], const fmi2Real[]) {
  return refuse(c, "fmi2SetRealInputDerivatives");
}
GYRO_FMI fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t,
                                                 const fmi2Integer[], fmi2Real[]) {
  return refuse(c, "fmi2GetRealOutputDerivatives");
}

GYRO_FMI fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step, fmi2Boolean) {
  return guarded(component, bit(SlaveMode::stepping), "fmi2DoStep",
                 [&](Fmi2Instance& instance) { instance.step(time, step); });
}

// fmi2DoStep returns after the step, so there is nothing to cancel or to wait for.
GYRO_FMI fmi2Status fmi2CancelStep(fmi2Component c) {
  return refuse(c, "fmi2CancelStep");
}
GYRO_FMI fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*) {
  return fmi2Discard;
}
GYRO_FMI fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  return guarded(component, any_mode, "fmi2GetRealStatus",
                 [&](Fmi2Instance& instance) { *value = instance.slave->state().motion.time; });
}
GYRO_FMI fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*) {
  return fmi2Discard;
}
GYRO_FMI fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = fmi2False;
  return fmi2OK;
}
GYRO_FMI fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*) {
  return fmi2Discard;
}
