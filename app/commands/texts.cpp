// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/commands/program_files.hpp"
#include "app/output/tables/reference.hpp"
#include "app/version.hpp"
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/schema/describe.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

namespace gyro {

std::optional<Case> load_or_complain(const CaseArguments& arguments) {
  CaseReport report = load_case(arguments.file, arguments.set);
  for (const CaseProblem& problem : report.problems) std::cerr << to_string(problem) << "\n";
  return report.loaded;
}

int describe_command(const DescribeArguments& a) {
  const bool outputs = a.key == "outputs";
  if (!outputs && (a.json || a.markdown))
    throw BadInput(
        "--json and --markdown belong to `gyrosim describe outputs`; use --json-schema for the keys of a case");
  if (outputs)
    std::cout << (a.json ? outputs_json() : a.markdown ? outputs_page() : outputs_text());
  else
    std::cout << (a.json_schema ? json_schema() : describe(a.key));
  if (a.key.empty() && !a.json_schema) std::cout << "\n`gyrosim describe outputs` documents what a run writes.\n";
  return exit_done;
}

int init_command(const std::string& name) {
  static const std::pair<const char*, const char*> templates[] = {{"quickstart", "quickstart.yaml"},
                                                                  {"primary", "mkii-62-75/case.yaml"},
                                                                  {"compression", "laboratory/platen.yaml"}};
  for (const auto& [known, file] : templates) {
    if (name != known) continue;
    const std::filesystem::path path = case_folder() / file;
    if (!std::filesystem::exists(path))
      throw OutputError(path.string() + ": cannot be read; the templates belong to the checkout or installation");
    std::cout << read_file(path);
    return exit_done;
  }
  throw BadInput("--template " + name + " is unknown; use quickstart, primary or compression");
}

int info_command(bool json) {
  nlohmann::json j {
    {"version", version::number}, {"git", version::git}, {"build_type", version::build_type},
        {"compiler", version::compiler}, {"precisions", {"mixed", "double"}},
#if defined(GYRO_WITH_CUDA)
        {"cuda", {{"compiled", true}}},
#else
        {"cuda", {{"compiled", false}}},
#endif
    {
      "threads", std::thread::hardware_concurrency()
    }
  };
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);)
    if (line.rfind("model name", 0) == 0) {
      j["cpu"] = line.substr(line.find(':') + 2);
      break;
    }
  j["libraries"] = {{"sundials", version::sundials}, {"hdf5", version::hdf5}, {"vtk", version::vtk}};
  if (json) {
    std::cout << j.dump(2) << "\n";
    return exit_done;
  }
  for (const auto& [key, value] : j.items()) std::cout << key << ": " << value.dump() << "\n";
  return exit_done;
}

}  // namespace gyro
