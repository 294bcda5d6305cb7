// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/state_files.hpp"

#include "core/base/errors.hpp"
#include "io/case/case.hpp"
#include "io/files/digest.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace gyro::bench {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw OutputError(file.string() + ": cannot be written; is the disk full?");
}

std::string row_of(const StartState& state, std::size_t k) {
  const Vec3d x = state.centres[k], v = state.velocities.empty() ? Vec3d{0, 0, 0} : state.velocities[k];
  char row[256];
  std::snprintf(row, sizeof row, "%zu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k, x.x, x.y, x.z, state.radii[k],
                v.x, v.y, v.z);
  return row;
}

void write_particles(const fs::path& file, const StartState& state) {
  std::string text = "id,x,y,z,r,vx,vy,vz\n";
  for (std::size_t k = 0; k < state.centres.size(); ++k) text += row_of(state, k);
  write(file, text);
}

void write_bonds(const fs::path& file, const StartState& state) {
  std::string text = "i,j\n";
  for (const auto& [i, j] : state.bonds) text += std::to_string(i) + "," + std::to_string(j) + "\n";
  write(file, text);
}

/// ASCII, which every program reads.
void write_mesh(const fs::path& file, const std::string& name, const TriangleMesh& mesh) {
  std::string text = "solid " + name + "\n";
  const auto add = [&](const char* before, const Vec3d& v) {
    char line[120];
    std::snprintf(line, sizeof line, "%s %.9e %.9e %.9e\n", before, v.x, v.y, v.z);
    text += line;
  };
  for (const Vec3<Index>& t : mesh.triangles) {
    const Vec3d corners[] = {mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]};
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    add("facet normal", (1 / norm(normal)) * normal);
    text += "outer loop\n";
    for (const Vec3d& corner : corners) add("vertex", corner);
    text += "endloop\nendfacet\n";
  }
  write(file, text + "endsolid " + name + "\n");
}

/// Overrides of the case that name the files of the folder.
std::vector<std::string> named_files(const StartState& state, const fs::path& folder) {
  const std::string at = folder.string() + "/";
  std::vector<std::string> overrides{"particles.file='" + at + "particles.csv'"};
  if (!state.bonds.empty()) overrides.push_back("particles.bonds='" + at + "bonds.csv'");
  for (const auto& [wall, mesh] : state.meshes) overrides.push_back("walls." + wall + ".stl='" + at + wall + ".stl'");
  return overrides;
}

Case load(const SpeedScene& scene, const fs::path& file, const std::vector<std::string>& overrides) {
  const CaseReport report = load_case(file, overrides);
  std::string problems = "the case of scene " + scene.name + " cannot be used:";
  for (const CaseProblem& problem : report.problems) problems += "\n" + to_string(problem);
  if (!report.loaded) throw BadInput(problems);
  return *report.loaded;
}

/// What a folder must have been made from to be used again. `form` changes with the start states.
nlohmann::ordered_json origin_of(const SpeedScene& scene, const fs::path& file) {
  return {{"scene", scene.name},
          {"seed", scene.recipe.seed},
          {"asked", scene.recipe.particles},
          {"warm_up", scene.warm_up},
          {"timed", scene.timed},
          {"case", digest_of_file(file)},
          {"form", 1}};
}

bool is_current(const fs::path& folder, const nlohmann::ordered_json& origin) {
  std::ifstream in(folder / "scene.json");
  const nlohmann::json written = nlohmann::json::parse(in, nullptr, false);
  if (!written.is_object()) return false;
  for (const auto& [key, value] : origin.items())
    if (!written.contains(key) || written.at(key) != nlohmann::json(value)) return false;
  return true;
}

void write_folder(const fs::path& folder, const SpeedScene& scene, const fs::path& file,
                  nlohmann::ordered_json description) {
  const StartState state = scene.make(scene.recipe);
  fs::remove(folder / "scene.json");
  write_particles(folder / "particles.csv", state);
  if (!state.bonds.empty()) write_bonds(folder / "bonds.csv", state);
  for (const auto& [wall, mesh] : state.meshes) write_mesh(folder / (wall + ".stl"), wall, mesh);
  std::vector<std::string> overrides = scene.overrides;
  overrides.insert(overrides.end(), state.overrides.begin(), state.overrides.end());
  const std::vector<std::string> files = named_files(state, folder);
  overrides.insert(overrides.end(), files.begin(), files.end());
  const Case input = load(scene, file, overrides);
  write(folder / "case.yaml", resolved_yaml(input));
  description["particles"] = state.centres.size();
  description["bonds"] = state.bonds.size();
  description["time_step"] = input.time.step.value_or(0);
  for (const auto& [name, size] : state.sizes) description["sizes"][name] = size;
  write(folder / "scene.json", description.dump(1) + "\n");  // last: the folder is complete
}

}  // namespace

fs::path write_start(const SpeedScene& scene, const fs::path& cases, const fs::path& above) {
  if (scene.make == nullptr) return cases / scene.file;
  const fs::path folder = fs::absolute(above) / (scene.name + "-" + std::to_string(scene.recipe.seed) + "-" +
                                                 std::to_string(scene.recipe.particles));
  const nlohmann::ordered_json origin = origin_of(scene, cases / scene.file);
  if (is_current(folder, origin)) return folder / "case.yaml";
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw OutputError(folder.string() + ": cannot be made: " + failed.message());
  write_folder(folder, scene, cases / scene.file, origin);
  return folder / "case.yaml";
}

}  // namespace gyro::bench
