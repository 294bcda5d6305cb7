// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/commands/program_files.hpp"
#include "app/version.hpp"
#include "core/base/errors.hpp"
#include "io/fmu/export.hpp"

#include <iostream>

namespace gyro {
namespace {

namespace fs = std::filesystem;

/// The lines of a case that use the FMU as the built-in drivetrain was used.
std::string section_text(const fs::path& file, const DrivetrainParameters& drive) {
  std::string text = "drivetrain:\n  fmu: " + file.filename().string() + "\n";
  if (drive.bearings.depth > 0) text += "  bushing_depth: " + std::to_string(drive.bearings.depth) + "\n";
  return text;
}

}  // namespace

int export_fmu_command(const CaseArguments& arguments, const std::optional<fs::path>& out) {
  CaseArguments source = arguments;
  if (fs::is_directory(source.file)) source.file /= "case.yaml";  // of a run
  const std::optional<Case> input = load_or_complain(source);
  if (!input) return exit_bad_input;
  const std::string name = source.file.string();
  if (input->drivetrain_fmu)
    throw BadInput(name + ": its drivetrain is an FMU already; export one from a case with a motor");
  if (!input->drivetrain)
    throw BadInput(name + ": has no drivetrain; export one from a case with the section drivetrain");
  const fs::path file = out.value_or(input->file.stem().string() + ".fmu");
  located(source, [&] {
    blaming("drivetrain", [&] {
      export_drive({.drive = *input->drivetrain,
                    .title = input->identity.title,
                    .tool = std::string("gyrosim ") + version::number + " (" + version::git + ")",
                    .stop_time = input->time.duration,
                    .step = input->coupling_interval,
                    .library = program_part("gyro_drivetrain_fmu.so", "gyro_drivetrain_fmu")},
                   file);
    });
  });
  std::cout << file.string() << ": FMI 2.0 co-simulation, linux64. In a case:\n"
            << section_text(file, *input->drivetrain);
  return exit_done;
}

}  // namespace gyro
