// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/program_files.hpp"

#include "core/base/errors.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace gyro {
namespace {

namespace fs = std::filesystem;

fs::path program() {
  std::error_code failed;
  const fs::path file = fs::read_symlink("/proc/self/exe", failed);
  if (failed) throw OutputError("/proc/self/exe: cannot be read: " + failed.message());
  return file;
}

bool is_build_folder(const fs::path& folder) {
  return fs::exists(folder / "CMakeCache.txt");
}

/// Holds the lock of a build folder, which scripts/build.sh takes too: two builds at once would disturb each other.
class BuildLock {
 public:
  explicit BuildLock(const fs::path& folder)
      : file_(::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ >= 0) ::flock(file_, LOCK_EX);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;
  ~BuildLock() {
    if (file_ >= 0) ::close(file_);
  }

 private:
  int file_;
};

/// A word of a shell's command line.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

bool is_current(const fs::path& file) {
  return fs::exists(file) && fs::last_write_time(file) >= fs::last_write_time(program());
}

void build(const fs::path& folder, const fs::path& file, const std::string& target) {
  const BuildLock lock(folder);
  if (is_current(file)) return;  // another process built it meanwhile
  const fs::path log = folder / (target + ".log");
  if (!fs::exists(file)) std::fprintf(stderr, "gyrosim: building %s, once (%s)\n", target.c_str(), log.c_str());
  const std::string command = "cmake --build " + quoted(folder) + " --target " + target + " >" + quoted(log) + " 2>&1";
  if (std::system(command.c_str()) != 0) throw OutputError(target + ": cannot be built; " + log.string() + " says why");
}

}  // namespace

fs::path case_folder() {
  const fs::path folder = program().parent_path();
  return (folder / (is_build_folder(folder) ? GYRO_CASES_FROM_BUILD : GYRO_CASES_FROM_BIN)).lexically_normal();
}

fs::path program_part(const std::string& name, const std::string& target) {
  const fs::path folder = program().parent_path();
  if (is_build_folder(folder)) {
    if (!is_current(folder / name)) build(folder, folder / name, target);
    return folder / name;
  }
  const fs::path file = (folder / GYRO_PARTS_FROM_BIN / name).lexically_normal();
  if (!fs::exists(file)) throw OutputError(file.string() + ": is missing; install gyrosim again");
  return file;
}

}  // namespace gyro
