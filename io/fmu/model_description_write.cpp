// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fmu/model_description.hpp"
#include "io/schema/schema.hpp"

#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace gyro {
namespace {

/// A unit in SI base units.
struct BaseUnit {
  const char* name;
  int kg, m, s, rad;
};
constexpr BaseUnit base_units[] = {
    {"rad", 0, 0, 0, 1},   {"rad/s", 0, 0, -1, 1}, {"N.m", 1, 2, -2, 0},      {"N.m.s", 1, 2, -1, 0},
    {"W", 1, 2, -3, 0},    {"J", 1, 2, -2, 0},     {"N.m/rad", 1, 2, -2, -1}, {"N.m.s/rad", 1, 2, -1, -1},
    {"kg.m2", 1, 2, 0, 0}, {"N", 1, 1, -2, 0},     {"m", 0, 1, 0, 0},         {"s", 0, 0, 1, 0},
};

void add_units(pugi::xml_node root, const std::vector<DriveVariable>& variables) {
  pugi::xml_node definitions = root.append_child("UnitDefinitions");
  for (const DriveVariable& variable : variables) {
    bool known = variable.unit.empty();
    for (const BaseUnit& unit : base_units) known = known || variable.unit == unit.name;
    if (!known) throw std::logic_error("the unit " + variable.unit + " has no definition");
  }
  for (const BaseUnit& unit : base_units) {
    pugi::xml_node node = definitions.append_child("Unit");
    node.append_attribute("name") = unit.name;
    pugi::xml_node base = node.append_child("BaseUnit");
    const auto exponent = [&](const char* name, int value) {
      if (value != 0) base.append_attribute(name) = value;
    };
    exponent("kg", unit.kg);
    exponent("m", unit.m);
    exponent("s", unit.s);
    exponent("rad", unit.rad);
  }
}

void add_variable(pugi::xml_node list, const DriveVariable& variable, std::size_t reference) {
  constexpr const char* types[] = {"Real", "Integer", "Boolean"};
  constexpr const char* causalities[] = {"parameter", "input", "output"};
  const bool real = variable.type == VariableType::real, output = variable.causality == Causality::output;
  pugi::xml_node scalar = list.append_child("ScalarVariable");
  scalar.append_attribute("name") = variable.name.c_str();
  scalar.append_attribute("valueReference") = static_cast<unsigned>(reference);
  scalar.append_attribute("description") = variable.description.c_str();
  scalar.append_attribute("causality") = causalities[static_cast<int>(variable.causality)];
  scalar.append_attribute("variability") =
      variable.causality == Causality::parameter ? "fixed" : (real ? "continuous" : "discrete");
  if (output) scalar.append_attribute("initial") = "calculated";
  pugi::xml_node typed = scalar.append_child(types[static_cast<int>(variable.type)]);
  if (!variable.unit.empty()) typed.append_attribute("unit") = variable.unit.c_str();
  if (output) return;
  const double start = variable.get();
  if (real)
    typed.append_attribute("start") = number_text(start).c_str();
  else if (variable.type == VariableType::boolean)
    typed.append_attribute("start") = start != 0;
  else
    typed.append_attribute("start") = static_cast<int>(start);
}

void add_structure(pugi::xml_node root, const std::vector<DriveVariable>& variables) {
  pugi::xml_node structure = root.append_child("ModelStructure");
  for (const char* list : {"Outputs", "InitialUnknowns"}) {
    pugi::xml_node unknowns = structure.append_child(list);
    for (std::size_t k = 0; k < variables.size(); ++k)
      if (variables[k].causality == Causality::output)
        unknowns.append_child("Unknown").append_attribute("index") = static_cast<unsigned>(k + 1);
  }
}

}  // namespace

std::string write_model_description(const ModelIdentity& identity, const std::vector<DriveVariable>& variables) {
  pugi::xml_document document;
  document.append_child(pugi::node_declaration).append_attribute("version") = "1.0";
  document.first_child().append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("fmiModelDescription");
  const auto say = [](pugi::xml_node node, const char* name, const auto& value) {
    node.append_attribute(name) = value;
  };
  say(root, "fmiVersion", "2.0");
  say(root, "modelName", identity.name.c_str());
  say(root, "guid", identity.guid.c_str());
  say(root, "description", "Motor, gear and eccentric of a gyratory crusher");
  say(root, "license", "GPL-3.0-or-later");
  say(root, "generationTool", identity.tool.c_str());
  say(root, "variableNamingConvention", "structured");
  pugi::xml_node slave = root.append_child("CoSimulation");
  say(slave, "modelIdentifier", identity.identifier.c_str());
  for (const char* ability : {"canHandleVariableCommunicationStepSize", "canNotUseMemoryManagementFunctions",
                              "canGetAndSetFMUstate", "canSerializeFMUstate"})
    say(slave, ability, true);
  add_units(root, variables);
  pugi::xml_node categories = root.append_child("LogCategories");
  for (const char* category : {"logStatusWarning", "logStatusError"})
    say(categories.append_child("Category"), "name", category);
  pugi::xml_node experiment = root.append_child("DefaultExperiment");
  say(experiment, "startTime", "0");
  say(experiment, "stopTime", number_text(identity.stop_time).c_str());
  say(experiment, "stepSize", number_text(identity.step).c_str());
  pugi::xml_node list = root.append_child("ModelVariables");
  for (std::size_t k = 0; k < variables.size(); ++k) add_variable(list, variables[k], k);
  add_structure(root, variables);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace gyro
