// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/assembly.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/library_wait.hpp"
#include "core/base/errors.hpp"
#include "io/rocks/library_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace gyro {
namespace {

/// Figures of the whole library.
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
  std::printf(
      "crumbled to particles, its rock takes %.2f times the volume of solid rock; real broken rock takes about 1.7\n",
      swell_of_crumbled(library));
  for (const std::string& note : library.notes) std::printf("%s\n", note.c_str());
  std::printf("%s in %.3g s\n", library.from_cache ? "read from the cache" : "made", library.seconds);
}

}  // namespace

void make_directory(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (failed) throw OutputError(path.string() + ": cannot make the directory: " + failed.message());
}

int library_command(const CaseArguments& arguments, const std::optional<std::filesystem::path>& out) {
  const std::optional<Case> input = load_or_complain(arguments);
  if (!input) return exit_bad_input;
  if (!input->rocks)
    throw BadInput(to_string(problem_at(arguments.file, arguments.set, "rocks",
                                        "the case has no `rocks`; add the section, a library is made from it")));
  const Assembly assembly = located(
      arguments, [&] { return assemble(*input, {.threads = arguments.threads, .library_progress = LibraryWait()}); });
  const RockLibrary& library = assembly.setup.library;
  if (out) {
    make_directory(*out);
    write_library(library, *out / "library.h5");
    write_library_preview(library, *out);
  }
  const SizeDistribution sizes(input->rocks->sizes);
  nlohmann::json j{{"rocks", nlohmann::json::array()},
                   {"seconds", library.seconds},
                   {"from_cache", library.from_cache},
                   {"f80", sizes.f80()},
                   {"f50", sizes.f50()},
                   {"swell_of_crumbled", swell_of_crumbled(library)},
                   {"notes", library.notes}};
  if (!arguments.json)
    std::printf("%-28s %9s %9s %9s %7s %8s %9s %9s %9s %6s %9s\n", "rock", "mm", "particles", "largest", "bonds",
                "packing", "mass err", "centre", "inertia", "coord", "limit us");
  for (const RockTemplate& r : library.rocks) {
    const double largest = *std::max_element(r.radii.begin(), r.radii.end());
    j["rocks"].push_back({{"name", r.name},
                          {"diameter", r.diameter},
                          {"sieve_size", r.sieve_size},
                          {"particles", r.centres.size()},
                          {"largest_particle", 2 * largest},
                          {"bonds", r.bonds.size()},
                          {"packing_fraction", r.packing_fraction},
                          {"mass_error", r.mass_error},
                          {"inertia_error", r.inertia_error},
                          {"centre_error", r.centre_error},
                          {"coordination", r.coordination},
                          {"critical_step", r.critical_step}});
    if (!arguments.json)
      std::printf("%-28s %9.4g %9zu %9.4g %7zu %8.4f %9.1e %9.1e %9.1e %6.2f %9.4g\n", r.name.c_str(), r.diameter * 1e3,
                  r.centres.size(), 2e3 * largest, r.bonds.size(), r.packing_fraction, r.mass_error, r.centre_error,
                  r.inertia_error, r.coordination, r.critical_step * 1e6);
  }
  if (arguments.json)
    std::cout << j.dump(2) << "\n";
  else
    print_footer(library, sizes);
  return exit_done;
}

}  // namespace gyro
