// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fmu/model_description.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <map>
#include <pugixml.hpp>

namespace gyro {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw BadInput("modelDescription.xml " + problem);
}

std::string text_of(pugi::xml_node node, const char* attribute) {
  return node.attribute(attribute).as_string();
}

std::string needed(pugi::xml_node node, const char* attribute) {
  const std::string text = text_of(node, attribute);
  if (text.empty())
    refuse("has a " + std::string(node.name()) + " without " + attribute +
           "; an FMI 2.0 FMU for co-simulation is needed");
  return text;
}

std::map<std::string, FmuUnit> units_of(pugi::xml_node root) {
  std::map<std::string, FmuUnit> units;
  for (const pugi::xml_node unit : root.child("UnitDefinitions").children("Unit")) {
    const pugi::xml_node base = unit.child("BaseUnit");
    if (!base) continue;  // a name without a definition
    FmuUnit si{.factor = base.attribute("factor").as_double(1), .offset = base.attribute("offset").as_double(0)};
    constexpr const char* names[] = {"kg", "m", "s", "A", "K", "mol", "cd"};
    for (std::size_t k = 0; k < si.exponents.size(); ++k) si.exponents[k] = base.attribute(names[k]).as_int(0);
    units[text_of(unit, "name")] = si;
  }
  return units;
}

/// For each declared type, the unit of its variables.
std::map<std::string, std::string> type_units_of(pugi::xml_node root) {
  std::map<std::string, std::string> units;
  for (const pugi::xml_node type : root.child("TypeDefinitions").children("SimpleType"))
    units[text_of(type, "name")] = text_of(type.child("Real"), "unit");
  return units;
}

void read_variables(pugi::xml_node root, ModelDescription& out) {
  const auto units = units_of(root);
  const auto type_units = type_units_of(root);
  for (const pugi::xml_node scalar : root.child("ModelVariables").children("ScalarVariable")) {
    FmuVariable v;
    v.name = needed(scalar, "name");
    needed(scalar, "valueReference");
    v.reference = scalar.attribute("valueReference").as_uint();
    v.causality = scalar.attribute("causality").as_string("local");
    for (const char* type : {"Real", "Integer", "Boolean", "String", "Enumeration"}) {
      const pugi::xml_node typed = scalar.child(type);
      if (!typed) continue;
      v.type = type;
      v.unit = text_of(typed, "unit");
      const auto declared = type_units.find(text_of(typed, "declaredType"));
      if (v.unit.empty() && declared != type_units.end()) v.unit = declared->second;
    }
    if (v.type.empty())
      refuse("has a variable " + v.name + " without a type; an FMI 2.0 FMU for co-simulation is needed");
    const auto unit = units.find(v.unit);
    v.unit_known = unit != units.end();
    if (v.unit_known) v.si = unit->second;
    out.variables.push_back(std::move(v));
  }
}

}  // namespace

const FmuVariable* ModelDescription::find(std::string_view name) const {
  const auto found = std::ranges::find(variables, name, &FmuVariable::name);
  return found == variables.end() ? nullptr : &*found;
}

ModelDescription read_model_description(const std::string& xml) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    refuse("is not XML: " + std::string(parsed.description()) + " at byte " + std::to_string(parsed.offset) +
           "; an FMI 2.0 FMU for co-simulation is needed");
  const pugi::xml_node root = document.child("fmiModelDescription");
  if (!root) refuse("has no fmiModelDescription; an FMI 2.0 FMU for co-simulation is needed");
  const std::string version = text_of(root, "fmiVersion");
  if (version != "2.0")
    refuse(version.empty() ? std::string("has no fmiVersion; FMI 2.0 is needed")
                           : "is of FMI " + version + "; FMI 2.0 is needed");
  const pugi::xml_node slave = root.child("CoSimulation");
  if (!slave) refuse("has no CoSimulation (model exchange only); an FMU for co-simulation is needed");

  ModelDescription out;
  out.needs_tool = slave.attribute("needsExecutionTool").as_bool();
  out.model_name = needed(root, "modelName");
  out.guid = needed(root, "guid");
  out.generation_tool = text_of(root, "generationTool");
  out.identifier = needed(slave, "modelIdentifier");
  if (out.identifier.find('/') != std::string::npos)
    refuse("has a modelIdentifier with a slash; it must be the name of its library");
  out.variable_step = slave.attribute("canHandleVariableCommunicationStepSize").as_bool();
  out.state = slave.attribute("canGetAndSetFMUstate").as_bool();
  out.serialisation = out.state && slave.attribute("canSerializeFMUstate").as_bool();
  read_variables(root, out);
  return out;
}

}  // namespace gyro
