// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly.hpp"
#include "app/commands.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/stl_file.hpp"
#include "core/walls/mesh_setting.hpp"
#include "io/library_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace gyro {
namespace {

constexpr double bulk_density_of_rock = 1600;  // brochures state capacities at 1.6 t/m3

double eccentric_speed(const Case& input) {
  if (input.drivetrain_fmu) return open_drive(*input.drivetrain_fmu)->idle_speed();
  if (!input.drivetrain) return 160 * 2 * 3.14159265358979323846 / 60;
  return idle_speed(*input.drivetrain);
}

void make_directory(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (failed) throw OutputError(path.string() + ": cannot make the directory: " + failed.message());
}

constexpr int sectors = 360;

/// The setting as it is on the meshes that are written.
MeshSetting measured(const Liners& liners) {
  return MeshGap(revolve(liners.mantle, sectors), revolve(liners.concave, sectors), liners.motion)
      .measure(liners.motion.lift);
}

/// The liner as it stands with the mantle centred and lifted to the setting: a case takes the file as it is.
void write_liner(const ProfileShape& shape, double lift, const std::filesystem::path& file) {
  MeshShape mesh = revolve(shape, sectors);
  for (Vec3d& v : mesh.vertices) v.z += lift;
  write_stl(file.string(), {mesh.vertices, mesh.triangles});
}

/// What the library is as a whole.
void print_footer(const RockLibrary& library, const SizeDistribution& sizes) {
  double particles = 0, bonds = 0, rocks_per_mass = 0, particles_by_number = 0;
  for (const RockTemplate& r : library.rocks) {
    const double count = static_cast<double>(r.centres.size());
    particles += count;
    bonds += static_cast<double>(r.bonds.size());
    rocks_per_mass += 1 / r.solid_volume;  // each template stands for the same mass of feed
    particles_by_number += count / r.solid_volume;
  }
  const double n = static_cast<double>(library.rocks.size());
  std::printf("feed: F80 %.4g mm, F50 %.4g mm\n", sizes.f80() * 1e3, sizes.f50() * 1e3);
  std::printf(
      "mean of the library: %.4g particles and %.4g bonds a rock; of the rocks fed, by number: %.4g particles\n",
      particles / n, bonds / n, particles_by_number / rocks_per_mass);
  std::printf("crumbled, its rock takes %.2f times the room of solid rock; real broken rock about 1.7\n",
              swell_of_crumbled(library));
  for (const std::string& note : library.notes) std::printf("%s\n", note.c_str());
  std::printf("%s in %.3g s\n", library.from_cache ? "read from the cache" : "made", library.seconds);
}

}  // namespace

int liners_command(const CaseArguments& arguments, const std::filesystem::path& out) {
  const std::optional<Case> input = load_or_complain(arguments);
  if (!input) return exit_bad_input;
  if (!input->crusher || input->crusher->liners.empty())
    throw BadInput(to_string(problem_at(arguments.file, arguments.set, "crusher",
                                        "the case has no crusher.profile; liners are made from a profile")));
  const CaseCrusher& c = *input->crusher;
  const Liners liners = located(arguments, [&] { return blaming("crusher", [&] { return liners_of(c); }); });
  const LinerReport report = measure(liners, eccentric_speed(*input), norm(input->gravity));
  const MeshSetting on_meshes = measured(liners);
  make_directory(out);
  write_liner(liners.concave, 0, out / "concave.stl");
  write_liner(liners.mantle, liners.motion.lift, out / "mantle.stl");
  nlohmann::json j{{"closed_side_setting", report.closed_side_setting},
                   {"open_side_setting", report.open_side_setting},
                   {"throw", report.throw_at_discharge},
                   {"measured_on_meshes", {{"closed", on_meshes.closed}, {"open", on_meshes.open}}},
                   {"volume", report.volume},
                   {"capacity_tph", report.capacity * bulk_density_of_rock * 3.6},
                   {"choke_height", report.choke_height},
                   {"nip_angle", nlohmann::json::array()}};
  for (std::size_t k = 0; k < report.nip_angle.size(); ++k)
    j["nip_angle"].push_back({c.liners[k].z, report.nip_angle[k]});
  if (arguments.json) {
    std::cout << j.dump(2) << "\n";
    return exit_done;
  }
  std::printf("closed side setting  %.2f mm\nopen side setting    %.2f mm\nthrow                %.2f mm\n",
              report.closed_side_setting * 1e3, report.open_side_setting * 1e3, report.throw_at_discharge * 1e3);
  std::printf("on the meshes        %.2f and %.2f mm, by turning the eccentric\n", on_meshes.closed * 1e3,
              on_meshes.open * 1e3);
  std::printf("chamber volume       %.4g m3\nslice capacity       %.4g t/h at 1.6 t/m3, choke at z = %.3g m\n",
              report.volume, report.capacity * bulk_density_of_rock * 3.6, report.choke_height);
  const std::size_t every = std::max<std::size_t>(1, report.nip_angle.size() / 12);
  for (std::size_t k = 0; k < report.nip_angle.size(); k += every)
    std::printf("nip angle            %5.1f deg at z = %.3g m\n", report.nip_angle[k] * 57.29577951308232,
                c.liners[k].z);
  return exit_done;
}

int library_command(const CaseArguments& arguments, const std::optional<std::filesystem::path>& out) {
  const std::optional<Case> input = load_or_complain(arguments);
  if (!input) return exit_bad_input;
  if (!input->rocks)
    throw BadInput(to_string(
        problem_at(arguments.file, arguments.set, "rocks", "the case has no `rocks`; a library is made from them")));
  const Assembly assembly = located(arguments, [&] { return assemble(*input); });
  if (out) {
    make_directory(*out);
    write_library(assembly.library, *out);
    write_library_preview(assembly.library, *out);
  }
  const SizeDistribution sizes(input->rocks->sizes);
  nlohmann::json j{{"rocks", nlohmann::json::array()},
                   {"seconds", assembly.library.seconds},
                   {"from_cache", assembly.library.from_cache},
                   {"f80", sizes.f80()},
                   {"f50", sizes.f50()},
                   {"swell_of_crumbled", swell_of_crumbled(assembly.library)},
                   {"notes", assembly.library.notes}};
  if (!arguments.json)
    std::printf("%-28s %9s %9s %7s %8s %9s %9s %9s %6s %9s\n", "rock", "mm", "particles", "bonds", "packing",
                "mass err", "centre", "inertia", "coord", "limit us");
  for (const RockTemplate& r : assembly.library.rocks) {
    j["rocks"].push_back({{"name", r.name},
                          {"diameter", r.diameter},
                          {"sieve_size", r.sieve_size},
                          {"particles", r.centres.size()},
                          {"bonds", r.bonds.size()},
                          {"packing_fraction", r.packing_fraction},
                          {"mass_error", r.mass_error},
                          {"inertia_error", r.inertia_error},
                          {"centre_error", r.centre_error},
                          {"coordination", r.coordination},
                          {"critical_step", r.critical_step}});
    if (!arguments.json)
      std::printf("%-28s %9.4g %9zu %7zu %8.4f %9.1e %9.1e %9.1e %6.2f %9.4g\n", r.name.c_str(), r.diameter * 1e3,
                  r.centres.size(), r.bonds.size(), r.packing_fraction, r.mass_error, r.centre_error, r.inertia_error,
                  r.coordination, r.critical_step * 1e6);
  }
  if (arguments.json)
    std::cout << j.dump(2) << "\n";
  else
    print_footer(assembly.library, sizes);
  return exit_done;
}

}  // namespace gyro
