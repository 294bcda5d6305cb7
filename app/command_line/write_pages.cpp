// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the manual page and the shells' completions into a folder; the build runs it.
#include "app/command_line/pages.hpp"
#include "app/version.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_pages FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const gyro::CommandText program = gyro::command_line_text();
    write(folder / "gyrosim.1", gyro::manual_page(program, gyro::version::number));
    write(folder / "bash/gyrosim", gyro::bash_completion(program));
    write(folder / "zsh/_gyrosim", gyro::zsh_completion(program));
    return 0;
  } catch (const std::exception& problem) {
    std::cerr << problem.what() << "\n";
    return 1;
  }
}
