// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace gyro {

/// The folder `cases` that belongs to this program: of the checkout when it runs from its build folder, else the
/// installed one (share/gyrosim/cases).
std::filesystem::path case_folder();

/// A file that was built with this program: in a build folder beside it, installed in lib/gyrosim.
///
/// scripts/run.sh builds only what a first run needs. So, in a build folder, a part that is missing or older than
/// the program is built first, with a note on standard error where that takes long.
/// @param name  of the file
/// @param target  of the build that makes it
/// @throws OutputError when it is missing and cannot be built
std::filesystem::path program_part(const std::string& name, const std::string& target);

}  // namespace gyro
