// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/fmu/drive_fmu.hpp"
#include "io/schema/schema.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

constexpr std::array<int, 7> torque{1, 2, -2}, force{1, 1, -2}, angle{}, angular_speed{0, 0, -1}, impulse{1, 2, -1},
    power{1, 2, -3}, energy{1, 2, -2};

constexpr std::array<FmuQuantityInfo, fmu_quantities> quantities{{
    {"mantle_torque", torque, true},
    {"spin_torque", torque},
    {"bushing_force", force},
    {"spider_force", force},
    {"eccentric_speed", angular_speed, true},
    {"eccentric_angle", angle},
    {"mantle_spin", angular_speed},
    {"mantle_spin_angle", angle},
    {"motor_speed", angular_speed},
    {"motor_angle", angle},
    {"motor_torque", torque},
    {"motor_impulse", impulse},
    {"motor_power", power},
    {"motor_work", energy},
    {"loss_work", energy},
    {"kinetic_energy", energy},
    {"tripped", {}},
}};

/// SI units that are known without a definition in the FMU.
constexpr std::string_view plain_si[] = {"N.m", "Nm", "N m", "N", "rad", "1", "rad/s", "1/s", "N.m.s", "W", "J"};

std::string list_of(const std::vector<std::string_view>& names) {
  constexpr std::size_t maximum = 20;
  if (names.empty()) return "none";
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), maximum); ++k)
    text += (k == 0 ? "" : ", ") + std::string(names[k]);
  return text + (names.size() > maximum ? ", and " + std::to_string(names.size() - maximum) + " more" : "");
}

/// Names of the variables that could be used in place of an unknown name.
/// @param type  empty: any
std::vector<std::string_view> names_of(const ModelDescription& model, std::string_view causality,
                                       std::string_view type) {
  std::vector<std::string_view> names;
  for (const FmuVariable& v : model.variables)
    if (v.causality == causality && (type.empty() || v.type == type)) names.push_back(v.name);
  return names;
}

std::string hint(std::string_view wanted, const std::vector<std::string_view>& names) {
  const std::string_view meant = closest(wanted, names);
  return meant.empty() ? "" : "did you mean \"" + std::string(meant) + "\"? ";
}

/// Sets factor and offset of a link for the conversion to SI. @throws BadInput for another or an unknown unit
void take_unit(FmuLink& link, const FmuVariable& variable, const FmuQuantityInfo& info) {
  if (variable.unit.empty()) return;  // no unit declared: SI
  if (!variable.unit_known) {
    if (std::ranges::find(plain_si, variable.unit) == std::end(plain_si))
      throw BadInput("the FMU's variable \"" + variable.name + "\" has the unit \"" + variable.unit +
                     "\", which its description does not define; use a unit with a BaseUnit");
    return;
  }
  if (variable.si.exponents != info.exponents || !(variable.si.factor != 0) || !std::isfinite(variable.si.factor))
    throw BadInput("the FMU's variable \"" + variable.name + "\" is in \"" + variable.unit +
                   "\", which is not a unit of " + std::string(info.name) + "; map a variable with such a unit");
  link.factor = variable.si.factor;
  link.offset = variable.si.offset;
}

}  // namespace

const FmuQuantityInfo& info_of(FmuQuantity quantity) {
  return quantities[static_cast<std::size_t>(quantity)];
}

FmuLink link_to(const ModelDescription& model, FmuQuantity quantity, std::string wanted) {
  const FmuQuantityInfo& info = info_of(quantity);
  const bool input = is_input(quantity), turned = wanted.starts_with('-') && model.find(wanted) == nullptr;
  if (turned) wanted.erase(0, 1);
  const bool real = type_of(quantity) == VariableType::real;
  const std::string_view type = real ? "Real" : "Boolean";
  const std::vector<std::string_view> names = names_of(model, input ? "input" : "output", type);
  const std::string kind = std::string(real ? "real " : "boolean ") + (input ? "input" : "output"),
                    choices = kind + "s of the FMU are " + list_of(names);
  const FmuVariable* variable = model.find(wanted);
  if (variable == nullptr)
    throw BadInput("the FMU has no variable \"" + wanted + "\" for " + std::string(info.name) + "; " +
                   hint(wanted, names) + choices);
  const bool readable = variable->causality == "output" || variable->causality == "local";
  if (variable->type != type || !(input ? variable->causality == "input" : readable))
    throw BadInput("the FMU's variable \"" + wanted + "\" is not a " + kind + " (" + variable->type + ", " +
                   variable->causality + "); " + choices);
  FmuLink link{variable->reference};
  if (!real) return link;
  take_unit(link, *variable, info);
  if (turned) {
    link.factor = -link.factor;
    link.offset = -link.offset;
  }
  return link;
}

DriveFmu unconnected(const std::filesystem::path& file, const ModelDescription& model) {
  return {file,        model.model_name,    model.generation_tool, model.guid, model.identifier,  model.variable_step,
          model.state, model.serialisation, model.needs_tool,      {},         history_of(model), {}};
}

std::optional<FmuHistory> history_of(const ModelDescription& model) {
  const auto output = [&](const std::string& name, std::string_view type) {
    const FmuVariable* variable = model.find(name);
    return variable != nullptr && variable->causality == "output" && variable->type == type ? variable : nullptr;
  };
  const FmuVariable* events = output("events", "Integer");
  if (events == nullptr) return std::nullopt;
  FmuHistory history{events->reference, {}, {}};
  for (int k = 1;; ++k) {
    const std::string place = std::to_string(k) + ']';
    const FmuVariable *time = output("event_time[" + place, "Real"), *what = output("event_kind[" + place, "Integer");
    if (time == nullptr || what == nullptr) break;
    history.times.push_back(time->reference);
    history.kinds.push_back(what->reference);
  }
  return history.times.empty() ? std::nullopt : std::optional(std::move(history));
}

FmuStart start_of(const ModelDescription& model, const std::string& name, double value) {
  const std::vector<std::string_view> names = names_of(model, "parameter", "");
  const FmuVariable* variable = model.find(name);
  if (variable == nullptr || variable->causality != "parameter")
    throw BadInput("the FMU has no parameter \"" + name + "\"; " + hint(name, names) + "parameters of the FMU are " +
                   list_of(names));
  if (variable->type == "Real") return {variable->reference, VariableType::real, value};
  const bool truth = variable->type == "Boolean";
  if (variable->type == "String" || (truth ? value != 0 && value != 1 : value != std::round(value)))
    throw BadInput("the FMU's parameter \"" + name + "\" is of type " + variable->type + "; " +
                   (truth ? "give true or false" : "give a whole number for an Integer or Enumeration"));
  return {variable->reference, truth ? VariableType::boolean : VariableType::integer, value};
}

}  // namespace gyro
