// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/report/page.hpp"
#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/summary.hpp"

#include <iostream>

namespace gyro {
namespace {

/// A page must be named as one: a slip such as `--out RUNDIR/results.h5` would replace results of hours.
void require_page_name(const std::filesystem::path& file) {
  if (file.extension() != ".html" && file.extension() != ".htm")
    throw BadInput("--out " + file.string() + ": does not end in .html; give a name that does");
  if (std::filesystem::is_directory(file))
    throw BadInput("--out " + file.string() + ": is a directory; give the name of a file");
}

}  // namespace

int report_command(const ReportArguments& arguments) {
  if (!arguments.out) {
    std::string text;
    for (const std::filesystem::path& run : arguments.runs) text += to_text(load_summary(run), run);
    std::cout << text;
    return exit_done;
  }
  require_page_name(*arguments.out);
  replace_file(*arguments.out, report::report_page(arguments.runs));
  return exit_done;
}

}  // namespace gyro
