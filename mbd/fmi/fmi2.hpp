// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

// The C interface of FMI 2.0 for co-simulation: types, and every function that a unit of that kind must export. Names,
// values and signatures are those of the standard "Functional Mock-up Interface for Model Exchange and Co-Simulation",
// version 2.0.4 (Modelica Association, 2022, https://fmi-standard.org), sections 2.1 and 4.2; the text here is our own.

extern "C" {

// The types platform "default".
using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

constexpr fmi2Boolean fmi2False = 0, fmi2True = 1;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category,
                                    fmi2String message, ...);
using fmi2CallbackAllocateMemory = void* (*)(std::size_t count, std::size_t size);
using fmi2CallbackFreeMemory = void (*)(void*);
using fmi2StepFinished = void (*)(fmi2ComponentEnvironment, fmi2Status);

struct fmi2CallbackFunctions {
  fmi2CallbackLogger logger;
  fmi2CallbackAllocateMemory allocateMemory;
  fmi2CallbackFreeMemory freeMemory;
  fmi2StepFinished stepFinished;
  fmi2ComponentEnvironment componentEnvironment;
};

using fmi2GetTypesPlatformTYPE = const char*();
using fmi2GetVersionTYPE = const char*();
using fmi2SetDebugLoggingTYPE = fmi2Status(fmi2Component, fmi2Boolean on, std::size_t count, const fmi2String[]);
using fmi2InstantiateTYPE = fmi2Component(fmi2String instance, fmi2Type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions*, fmi2Boolean visible, fmi2Boolean logging);
using fmi2FreeInstanceTYPE = void(fmi2Component);

using fmi2SetupExperimentTYPE = fmi2Status(fmi2Component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop);
using fmi2EnterInitializationModeTYPE = fmi2Status(fmi2Component);
using fmi2ExitInitializationModeTYPE = fmi2Status(fmi2Component);
using fmi2TerminateTYPE = fmi2Status(fmi2Component);
using fmi2ResetTYPE = fmi2Status(fmi2Component);

using fmi2GetRealTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, fmi2Real[]);
using fmi2GetIntegerTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, fmi2Integer[]);
using fmi2GetBooleanTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, fmi2Boolean[]);
using fmi2GetStringTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, fmi2String[]);
using fmi2SetRealTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, const fmi2Real[]);
using fmi2SetIntegerTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t, const fmi2Integer[]);
using fmi2SetBooleanTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t, const fmi2Boolean[]);
using fmi2SetStringTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t count, const fmi2String[]);

using fmi2GetFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate*);
using fmi2SetFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate);
using fmi2FreeFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate*);
using fmi2SerializedFMUstateSizeTYPE = fmi2Status(fmi2Component, fmi2FMUstate, std::size_t*);
using fmi2SerializeFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate, fmi2Byte[], std::size_t);
using fmi2DeSerializeFMUstateTYPE = fmi2Status(fmi2Component, const fmi2Byte[], std::size_t, fmi2FMUstate*);
using fmi2GetDirectionalDerivativeTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t,
                                                    const fmi2ValueReference[], std::size_t, const fmi2Real[],
                                                    fmi2Real[]);

using fmi2SetRealInputDerivativesTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t,
                                                   const fmi2Integer[], const fmi2Real[]);
using fmi2GetRealOutputDerivativesTYPE = fmi2Status(fmi2Component, const fmi2ValueReference[], std::size_t,
                                                    const fmi2Integer[], fmi2Real[]);
using fmi2DoStepTYPE = fmi2Status(fmi2Component, fmi2Real time, fmi2Real step, fmi2Boolean no_state_set_before);
using fmi2CancelStepTYPE = fmi2Status(fmi2Component);
using fmi2GetStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Status*);
using fmi2GetRealStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Real*);
using fmi2GetIntegerStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Integer*);
using fmi2GetBooleanStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Boolean*);
using fmi2GetStringStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2String*);
}
