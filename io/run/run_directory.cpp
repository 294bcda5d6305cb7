// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/run_directory.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/summary.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>
#include <vector>

namespace gyro {
namespace {

namespace fs = std::filesystem;

// All files that a run writes; --overwrite removes these and frames, and nothing else.
constexpr std::array own_files{"results.h5", "fields.h5",     "fields.xdmf", "checkpoint.h5", "summary.json", "log.txt",
                               "case.yaml",  "particles.pvd", "bonds.pvd",   "walls.pvd",     "fragments.pvd"};
// Files that show that a directory holds a run. A case.yaml alone does not, because it may be the user's own.
constexpr std::array marks{"results.h5", "summary.json", "log.txt", "checkpoint.h5"};

bool has_any(const fs::path& directory, const auto& names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return fs::exists(directory / name); });
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::error_code& error) {
  throw OutputError(path.string() + ": cannot " + what + ": " + error.message());
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) fail(path, "remove", error);
}

/// Whether a file has the name of a frame: (particles|bonds|walls|fragments)_NNNNNN.vtp or walls_fixed.vtp, perhaps
/// with .tmp at the end.
bool is_frame(std::string_view name) {
  if (name.ends_with(".tmp")) name.remove_suffix(4);
  if (name == "walls_fixed.vtp") return true;
  if (!name.ends_with(".vtp")) return false;
  name.remove_suffix(4);
  const std::size_t bar = std::min(name.find('_'), name.size());
  const std::string_view kind = name.substr(0, bar), number = name.substr(std::min(bar + 1, name.size()));
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return (kind == "particles" || kind == "bonds" || kind == "walls" || kind == "fragments") && number.size() >= 6 &&
         std::all_of(number.begin(), number.end(), is_digit);
}

/// Whether a file has the name of an index of fields.h5, perhaps with .tmp at the end.
bool is_field_index(std::string_view name) {
  if (name.ends_with(".tmp")) name.remove_suffix(4);
  const std::size_t dot = std::min(name.find('.'), name.size());
  const std::string_view kind = name.substr(0, dot), suffix = name.substr(dot);
  return (kind == "particles" || kind == "bonds" || kind == "liners" || kind == "liners_fixed" ||
          kind == "fragments") &&
         (suffix == ".xdmf" || suffix == ".vtkhdf");
}

/// Removes the files of a run in a folder, and the folder unless it contains other files.
void remove_folder(const fs::path& folder, bool (*is_of_run)(std::string_view name)) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_of_run(entry.path().filename().string())) files.push_back(entry.path());
  for (const fs::path& path : files) remove_file(path);
  std::error_code not_empty;
  fs::remove(folder, not_empty);
}

void remove_run(const fs::path& directory) {
  for (const char* name : own_files) {
    remove_file(directory / name);
    remove_file(directory / (std::string(name) + ".tmp"));
  }
  remove_folder(directory / "snapshots", is_frame);
  remove_folder(directory / "fields", is_field_index);
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "make the directory", error);
}

/// Checks before the run that the directory can be written. @throws OutputError
void prove_writable(const fs::path& directory) {
  const fs::path probe = directory / ".gyrosim-probe";
  replace_file(probe, "");
  remove_file(probe);
}

/// The number NNN of a name <stem>-NNN; -1 for another name.
int run_number(const std::string& name, const std::string& stem) {
  if (name.size() < stem.size() + 4 || name.compare(0, stem.size() + 1, stem + "-") != 0) return -1;
  const std::string digits = name.substr(stem.size() + 1);
  const bool number = digits.size() <= 9 &&
                      std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return number ? std::stoi(digits) : -1;
}

RunDirectory next_in_runs(const std::string& case_name) {
  const fs::path runs = "runs";
  make_directory(runs);
  int highest = 0;
  for (const auto& entry : fs::directory_iterator(runs))
    highest = std::max(highest, run_number(entry.path().filename().string(), case_name));
  // Another process may choose the same number: only one of them can create the directory.
  for (int next = highest + 1;; ++next) {
    std::array<char, 16> number;
    std::snprintf(number.data(), number.size(), "-%03d", next);
    const fs::path path = runs / (case_name + number.data());
    std::error_code error;
    if (fs::create_directory(path, error))
      return {path, RunDirectory::State::fresh, 0, std::make_shared<RunLock>(path)};
    if (error) fail(path, "make the directory", error);
  }
}

/// Examines a path without changing it.
RunDirectory find_named(const fs::path& path, bool resume, bool overwrite) {
  if (fs::exists(path) && !fs::is_directory(path))
    throw BadInput("--out " + path.string() + " is a file; give a directory, which may be new");
  const bool has_run = has_any(path, marks);
  const EarlierRun earlier = read_summary(path).value_or(EarlierRun{"unfinished", 0});
  if (!has_run && has_any(path, own_files))
    throw BadInput("--out " + path.string() +
                   " holds files with names that a run would use, but no run; give another directory");
  if (!has_run || overwrite) return {path, RunDirectory::State::fresh, 0};
  if (earlier.status == "done") return {path, RunDirectory::State::finished, earlier.simulated_seconds};
  if (!resume)
    throw BadInput("--out " + path.string() + " holds a run that is not finished (" + earlier.status +
                   "); use --resume to continue, --overwrite to start again, or another directory");
  return {path, RunDirectory::State::half_done, earlier.simulated_seconds};
}

RunDirectory open_named(const fs::path& path, const RunDirectoryRequest& request) {
  RunDirectory found = find_named(path, request.resume, request.overwrite);
  // A finished run may be in an archive that cannot be written.
  if (found.state == RunDirectory::State::finished && !request.lock) return found;
  make_directory(path);
  found.lock = request.lock ? request.lock : std::make_shared<RunLock>(path);
  if (find_named(path, request.resume, request.overwrite).state != found.state)
    throw BadInput(path.string() + ": another run has begun or ended here meanwhile; repeat the command");
  prove_writable(path);
  if (request.overwrite) remove_run(path);
  return found;
}

void check_request(const RunDirectoryRequest& request) {
  if (request.out && request.out->empty()) throw BadInput("--out is empty; give a directory");
  if (request.resume && request.overwrite)
    throw BadInput("--resume and --overwrite contradict each other; give only one of them");
  if (!request.out && (request.resume || request.overwrite))
    throw BadInput(std::string(request.resume ? "--resume" : "--overwrite") +
                   " needs a run; give its directory with --out DIR");
}

}  // namespace

std::shared_ptr<RunLock> lock_run_directory(const std::optional<fs::path>& out) {
  std::error_code error;
  if (!out || !fs::is_directory(*out, error)) return {};
  if (!has_any(*out, marks) && !fs::exists(*out / "run.lock", error)) return {};
  if (::access(out->c_str(), W_OK) != 0) return {};
  return std::make_shared<RunLock>(*out);
}

RunDirectory find_run_directory(const RunDirectoryRequest& request) {
  check_request(request);
  try {
    return request.out ? find_named(*request.out, request.resume, request.overwrite) : RunDirectory{};
  } catch (const fs::filesystem_error& error) {
    throw OutputError(error.what());
  }
}

RunDirectory open_run_directory(const RunDirectoryRequest& request) {
  check_request(request);
  try {
    return request.out ? open_named(*request.out, request) : next_in_runs(request.case_name);
  } catch (const fs::filesystem_error& error) {
    throw OutputError(error.what());
  }
}

}  // namespace gyro
