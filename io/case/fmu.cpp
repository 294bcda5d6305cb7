// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/case/parts.hpp"

// Reads `drivetrain.fmu` without running its native code.

namespace gyro {
namespace {

/// Runs `work`; a BadInput that it throws becomes a problem at this place.
template <class Work>
void at(const Mark& mark, CaseProblems& problems, Work&& work) {
  try {
    work();
  } catch (const BadInput& problem) {
    problems.add(mark, problem.what());
  }
}

void connect(const Setting& drive, const ModelDescription& model, FmuLinks& links, CaseProblems& problems) {
  for (std::size_t k = 0; k < fmu_quantities; ++k) {
    const auto quantity = static_cast<FmuQuantity>(k);
    const FmuQuantityInfo& info = info_of(quantity);
    const std::string name(info.name);
    const Setting* said = drive.find("map." + name);
    const FmuVariable* same_name = model.find(name);
    const bool no_such =
        same_name == nullptr || (type_of(quantity) == VariableType::boolean && same_name->type != "Boolean");
    if (said == nullptr && !info.required && no_such) continue;
    at(said != nullptr ? said->mark : drive.find("fmu")->mark, problems,
       [&] { links[k] = link_to(model, quantity, said != nullptr ? said->texts.at(0) : name); });
  }
}

bool linked(const FmuLinks& links, FmuQuantity quantity) {
  return links[static_cast<std::size_t>(quantity)].has_value();
}

}  // namespace

void read_drive_fmu(const Setting& root, CaseTables& tables, CaseProblems& problems) {
  const Setting& drive = *root.find("drivetrain");
  const Setting& file = *drive.find("fmu");
  at(file.mark, problems, [&] {
    const ModelDescription model = read_fmu(file.texts.at(0));
    CaseFmu fmu;
    static_cast<DriveFmu&>(fmu) = unconnected(file.texts[0], model);
    connect(drive, model, fmu.links, problems);
    if (const Setting* parameters = drive.find("parameters"))
      for (const Setting& p : parameters->children)
        at(p.mark, problems, [&] { fmu.starts.push_back(start_of(model, p.name, p.numbers.at(0))); });
    if (const Setting* depth = drive.find("bushing_depth")) fmu.bushing_depth = depth->numbers.at(0);
    const bool forces = linked(fmu.links, FmuQuantity::bushing_force) || linked(fmu.links, FmuQuantity::spider_force);
    if (forces && drive.lacks("bushing_depth"))
      throw BadInput("the FMU has an input for the force on bushings or spider; add the key bushing_depth");
    const Setting* limit = root.find("coupling.residual_limit");
    if (!fmu.variable_step && knowledge_of(fmu.links).accounts && limit != nullptr && limit->numbers.at(0) > 0)
      throw BadInput(
          "the FMU takes steps of one length only (canHandleVariableCommunicationStepSize is false), so that windows "
          "cannot be halved; set coupling.residual_limit: 0");
    tables.fmu = std::move(fmu);
  });
}

}  // namespace gyro
