// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/walls.hpp"
#include "app/commands/commands.hpp"
#include "core/base/errors.hpp"
#include "io/mesh/stl.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <numbers>

namespace gyro {
namespace {

using Json = nlohmann::json;

constexpr double tph = 1600 * 3.6;  // t/h per m3/s of bulk rock: brochures state capacities at 1.6 t/m3
constexpr double degree = std::numbers::pi / 180;
constexpr int sectors = 360;

double eccentric_speed(const Case& input) {
  if (input.drivetrain_fmu) return open_drive(*input.drivetrain_fmu)->idle_speed();
  if (!input.drivetrain) return 160 * 2 * std::numbers::pi / 60;
  return idle_speed(*input.drivetrain);
}

/// The liners with the mantle centred and lifted to the setting, so that a case can use the files as they are.
void write_liners(const MeshLiners& liners, const std::filesystem::path& folder) {
  make_directory(folder);
  write_stl((folder / "concave.stl").string(), liners.concave);
  TriangleMesh mantle = liners.mantle;
  for (Vec3d& v : mantle.vertices) v.z += liners.motion.lift;
  write_stl((folder / "mantle.stl").string(), mantle);
}

void print_settings(double closed, double open, double stroke) {
  std::printf("closed side setting  %.2f mm\nopen side setting    %.2f mm\nthrow                %.2f mm\n",
              closed * 1e3, open * 1e3, stroke * 1e3);
}

void print_chamber(double volume, double capacity, double choke_height) {
  std::printf("chamber volume       %.4g m3\nslice capacity       %.4g t/h at 1.6 t/m3, choke at z = %.3g m\n", volume,
              capacity * tph, choke_height);
}

Json json_of(const LinerReport& report, const MeshSetting& on_meshes, const std::vector<LinerRow>& rows) {
  Json j{{"closed_side_setting", report.closed_side_setting},
         {"open_side_setting", report.open_side_setting},
         {"throw", report.throw_at_discharge},
         {"measured_on_meshes", {{"closed", on_meshes.closed}, {"open", on_meshes.open}}},
         {"volume", report.volume},
         {"capacity_tph", report.capacity * tph},
         {"choke_height", report.choke_height},
         {"nip_angle", Json::array()}};
  for (std::size_t k = 0; k < rows.size(); ++k) j["nip_angle"].push_back({rows[k].z, report.nip_angle[k]});
  return j;
}

void report_profile(const CaseCrusher& crusher, const Liners& liners, const Case& input, const CaseArguments& arguments,
                    const std::filesystem::path& out) {
  const LinerReport report = measure(liners, eccentric_speed(input), norm(input.gravity));
  const MeshLiners meshes{revolve(liners.concave, sectors), revolve(liners.mantle, sectors), liners.motion};
  const MeshSetting on_meshes = MeshGap(meshes.mantle, meshes.concave, meshes.motion).measure(meshes.motion.lift);
  write_liners(meshes, out);
  if (arguments.json) {
    std::cout << json_of(report, on_meshes, crusher.liners).dump(2) << "\n";
    return;
  }
  print_settings(report.closed_side_setting, report.open_side_setting, report.throw_at_discharge);
  std::printf("on the meshes        %.2f and %.2f mm, by turning the eccentric\n", on_meshes.closed * 1e3,
              on_meshes.open * 1e3);
  print_chamber(report.volume, report.capacity, report.choke_height);
  const std::size_t every = std::max<std::size_t>(1, report.nip_angle.size() / 12);
  for (std::size_t k = 0; k < report.nip_angle.size(); k += every)
    std::printf("nip angle            %5.1f deg at z = %.3g m\n", report.nip_angle[k] / degree, crusher.liners[k].z);
}

Json json_of(const MeshReport& report, double lift, const std::vector<std::string>& notes) {
  Json j{{"closed_side_setting", report.closed_side_setting},
         {"open_side_setting", report.open_side_setting},
         {"throw", report.throw_at_discharge},
         {"lift", lift},
         {"sides", Json::array()},
         {"bottom", report.bottom},
         {"top", report.top},
         {"volume", report.volume},
         {"capacity_tph", report.capacity * tph},
         {"choke_height", report.choke_height},
         {"bridged", report.bridged},
         {"notes", notes},
         {"nip_angle", Json::array()}};
  for (const SideOfMeshes& side : report.sides)
    j["sides"].push_back({{"azimuth", side.azimuth}, {"closed", side.closed}, {"open", side.open}});
  for (const MeshReport::NipAngle& nip : report.nip_angle) j["nip_angle"].push_back({nip.z, nip.minimum, nip.largest});
  return j;
}

void print(const MeshReport& report, double lift) {
  print_settings(report.closed_side_setting, report.open_side_setting, report.throw_at_discharge);
  const auto closed = std::ranges::minmax(report.sides, {}, &SideOfMeshes::closed);
  const auto open = std::ranges::minmax(report.sides, {}, &SideOfMeshes::open);
  std::printf("by azimuth           closed %.2f (at %.0f deg) to %.2f mm (at %.0f), open %.2f to %.2f mm\n",
              closed.min.closed * 1e3, closed.min.azimuth / degree, closed.max.closed * 1e3,
              closed.max.azimuth / degree, open.min.open * 1e3, open.max.open * 1e3);
  std::printf("mantle lifted by     %.2f mm\n", lift * 1e3);
  print_chamber(report.volume, report.capacity, report.choke_height);
  std::printf("chamber              from z = %.3g to %.3g m; %.2g %% of the sections met no surface\n", report.bottom,
              report.top, report.bridged * 100);
  for (const MeshReport::NipAngle& nip : report.nip_angle)
    std::printf("nip angle            %5.1f to %.1f deg at z = %.3g m\n", nip.minimum / degree, nip.largest / degree,
                nip.z);
}

void report_meshes(const Case& input, const CaseArguments& arguments, const std::filesystem::path& out) {
  const CaseWalls walls = located(arguments, [&] { return make_walls(input); });
  const std::optional<MeshLiners> liners = mesh_liners(walls.walls);
  if (!liners)
    throw BadInput(
        to_string(problem_at(arguments.file, arguments.set, "crusher",
                             "there is nothing to measure; give crusher.profile, or two meshes, of which one "
                             "gyrates and the other is fixed and called concave")));
  const MeshReport report = located(arguments, [&] {
    return blaming("crusher", [&] { return measure(*liners, eccentric_speed(input), norm(input.gravity)); });
  });
  write_liners(*liners, out);
  if (arguments.json) {
    std::cout << json_of(report, liners->motion.lift, walls.notes).dump(2) << "\n";
  } else {
    print(report, liners->motion.lift);
    for (const std::string& note : walls.notes) std::printf("note                 %s\n", note.c_str());
  }
}

}  // namespace

int liners_command(const CaseArguments& arguments, const std::filesystem::path& out) {
  const std::optional<Case> input = load_or_complain(arguments);
  if (!input) return exit_bad_input;
  if (!input->crusher)
    throw BadInput(to_string(
        problem_at(arguments.file, arguments.set, "crusher",
                   "the case has no crusher; add one: its liners are made from a profile or measured on meshes")));
  const CaseCrusher& crusher = *input->crusher;
  if (crusher.liners.empty()) {
    report_meshes(*input, arguments, out);
    return exit_done;
  }
  const Liners liners = located(arguments, [&] { return blaming("crusher", [&] { return liners_of(crusher); }); });
  report_profile(crusher, liners, *input, arguments, out);
  return exit_done;
}

}  // namespace gyro
