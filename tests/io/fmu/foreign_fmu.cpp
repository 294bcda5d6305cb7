// SPDX-License-Identifier: GPL-3.0-or-later
// A drivetrain FMU as another program could make it: other names, speed in rpm, explicit Euler, no saved state.
//   J dw/dt = stall_torque (1 - w / w0) - T_load; from trip_at on without the torque of the motor
#include "mbd/fmi/fmi2.hpp"

#include <cfenv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace {

enum Reference : unsigned {
  load,
  speed,
  torque,
  inertia,
  fail_at,
  blind_at,
  trip_at = 9,
  off,
  misdeed,
  misdeed_at,
  references
};
constexpr double rpm = 0.10471975511965977, idle = 452.5 * rpm, stall_torque = 23.4375;

struct Instance {
  double values[references] = {0, idle / rpm, 0, 0.174, 1e9, 1e9, 0, 0, 0, 1e9, 0, 0, 0};
  fmi2CallbackFunctions callbacks{};
};

/// What the code of an FMU may do to the program that calls it.
enum class Misdeed { exit = 1, exception, crash, hang, round };

void misbehave(Misdeed what) {
  switch (what) {
    case Misdeed::exit:
      std::exit(0);
    case Misdeed::exception:
      throw std::runtime_error("of the FMU");
    case Misdeed::crash:
      std::raise(SIGSEGV);
      break;
    case Misdeed::hang:
      for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    case Misdeed::round:
      std::fesetround(FE_UPWARD);
  }
}

Instance& of(fmi2Component component) {
  return *static_cast<Instance*>(component);
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform() {
  return "default";
}
const char* fmi2GetVersion() {
  return "2.0";
}

fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String guid, fmi2String, const fmi2CallbackFunctions* functions,
                              fmi2Boolean, fmi2Boolean) {
  if (std::strcmp(guid, "foreign-1") != 0) {
    functions->logger(functions->componentEnvironment, "", fmi2Error, "", "the GUID is %s, not foreign-1", guid);
    return nullptr;
  }
  auto* instance = new Instance;
  instance->callbacks = *functions;
  return instance;
}
void fmi2FreeInstance(fmi2Component component) {
  delete static_cast<Instance*>(component);
}

fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real) {
  return fmi2OK;
}
fmi2Status fmi2EnterInitializationMode(fmi2Component) {
  return fmi2OK;
}
fmi2Status fmi2ExitInitializationMode(fmi2Component) {
  return fmi2OK;
}
fmi2Status fmi2Terminate(fmi2Component) {
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference refs[], std::size_t count, fmi2Real values[]) {
  for (std::size_t k = 0; k < count; ++k) values[k] = of(component).values[refs[k]];
  return fmi2OK;
}
fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference refs[], std::size_t count,
                          fmi2Boolean values[]) {
  for (std::size_t k = 0; k < count; ++k) values[k] = of(component).values[refs[k]] != 0;
  return fmi2OK;
}
fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference refs[], std::size_t count,
                       const fmi2Real values[]) {
  for (std::size_t k = 0; k < count; ++k) of(component).values[refs[k]] = values[k];
  return fmi2OK;
}
fmi2Status fmi2SetInteger(fmi2Component, const fmi2ValueReference[], std::size_t, const fmi2Integer[]) {
  return fmi2Error;
}
fmi2Status fmi2SetBoolean(fmi2Component, const fmi2ValueReference[], std::size_t, const fmi2Boolean[]) {
  return fmi2Error;
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step, fmi2Boolean) {
  constexpr int parts = 10;
  Instance& instance = of(component);
  double* v = instance.values;
  if (time + step > v[fail_at]) {
    const fmi2CallbackFunctions& c = instance.callbacks;
    c.logger(c.componentEnvironment, "", fmi2Error, "", "the motor is on fire at %g s", time);
    return fmi2Error;
  }
  if (v[misdeed] > 0 && time + step > v[misdeed_at]) misbehave(static_cast<Misdeed>(v[misdeed]));
  for (int k = 0; k < parts; ++k) {
    v[off] = time + k * step / parts >= v[trip_at];
    v[torque] = v[off] != 0 ? 0 : stall_torque * (1 - v[speed] * rpm / idle);
    v[speed] += step / parts * (v[torque] - v[load]) / v[inertia] / rpm;
  }
  if (time + step > v[blind_at]) v[speed] = std::nan("");
  return fmi2OK;
}
}
