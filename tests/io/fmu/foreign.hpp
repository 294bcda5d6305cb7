// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fmu/archive.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace gyro {

/// modelDescription.xml of foreign_fmu.cpp.
inline std::string foreign_description() {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="Flywheel" guid="foreign-1" generationTool="another program">
  <CoSimulation modelIdentifier="flywheel" canHandleVariableCommunicationStepSize="true"/>
  <UnitDefinitions>
    <Unit name="rpm"><BaseUnit s="-1" rad="1" factor="0.10471975511965977"/></Unit>
    <Unit name="N.m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
    <Unit name="kg"><BaseUnit kg="1"/></Unit>
  </UnitDefinitions>
  <TypeDefinitions><SimpleType name="Speed"><Real unit="rpm"/></SimpleType></TypeDefinitions>
  <ModelVariables>
    <ScalarVariable name="T_load" valueReference="0" causality="input"><Real unit="N.m" start="0"/></ScalarVariable>
    <ScalarVariable name="shaft.w" valueReference="1" causality="output"><Real declaredType="Speed"/></ScalarVariable>
    <ScalarVariable name="tau" valueReference="2" causality="output"><Real unit="N.m"/></ScalarVariable>
    <ScalarVariable name="J" valueReference="3" causality="parameter"><Real start="0.174"/></ScalarVariable>
    <ScalarVariable name="fail_at" valueReference="4" causality="parameter"><Real start="1e9"/></ScalarVariable>
    <ScalarVariable name="blind_at" valueReference="5" causality="parameter"><Real start="1e9"/></ScalarVariable>
    <ScalarVariable name="sacks" valueReference="6" causality="parameter"><Integer start="1"/></ScalarVariable>
    <ScalarVariable name="weight" valueReference="7" causality="output"><Real unit="kg"/></ScalarVariable>
    <ScalarVariable name="trip_at" valueReference="9" causality="parameter"><Real start="1e9"/></ScalarVariable>
    <ScalarVariable name="off" valueReference="10" causality="output"><Boolean/></ScalarVariable>
    <ScalarVariable name="misdeed" valueReference="11" causality="parameter"><Real start="0"/></ScalarVariable>
    <ScalarVariable name="misdeed_at" valueReference="12" causality="parameter"><Real start="0"/></ScalarVariable>
    <ScalarVariable name="odd" valueReference="8" causality="output"><Real unit="furlong"/></ScalarVariable>
  </ModelVariables>
</fmiModelDescription>
)";
}

/// A text with a part replaced; the text must contain the part.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

/// Writes the foreign FMU. @param library  name of the library in the archive  @param binary  file with its content
inline void write_foreign_fmu(const std::filesystem::path& file, const std::string& description = foreign_description(),
                              const std::string& library = "binaries/linux64/flywheel.so",
                              const char* binary = GYRO_FOREIGN_FMU) {
  std::ifstream stream(binary, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  write_archive(file, {{"modelDescription.xml", description}, {library, content}});
}

}  // namespace gyro
