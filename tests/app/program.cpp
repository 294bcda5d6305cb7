// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.hpp"

#include "io/hdf5/hdf5.hpp"

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace gyro {
namespace fs = std::filesystem;

Outcome Workplace::call(const std::string& command) const {
  const std::string notes = notes_.path().string();
  const std::string whole = "cd '" + work_.path().string() + "' && GYROSIM_THREADS=1 XDG_CACHE_HOME='" + notes + "' " +
                            command + " >'" + notes + "/out' 2>'" + notes + "/err'";
  const int status = std::system(whole.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(notes + "/out"), read_text(notes + "/err")};
}

Outcome Workplace::gyrosim(const std::string& arguments) const {
  return call("'" GYROSIM "' " + arguments);
}

Outcome Workplace::shell(const std::string& line) const {
  return call("GYROSIM='" GYROSIM "' && export GYROSIM GYROSIM_THREADS XDG_CACHE_HOME && { " + line + "; }");
}

Outcome Workplace::gyrosim_with_signal(const std::string& arguments, const std::string& signal, double seconds) const {
  // In the foreground, because otherwise timeout kills itself as well and returns before the killed program has ended.
  return call("timeout --foreground -s " + signal + " --preserve-status " + std::to_string(seconds) +
              " '" GYROSIM "' " + arguments);
}

Outcome Workplace::gyrosim_with_file_limit(const std::string& arguments, std::size_t bytes) const {
  // A shell counts in blocks of 512 bytes; without the signal a write beyond them fails as on a full disk.
  return call("sh -c 'trap \"\" XFSZ; ulimit -f " + std::to_string(bytes / 512) +
              "; exec \"$0\" \"$@\"' '" GYROSIM "' " + arguments);
}

void Workplace::write(const std::string& name, const std::string& text) const {
  std::ofstream(work_.path() / name) << text;
}

std::vector<std::string> Workplace::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(work_.path()))
    names.push_back(fs::relative(entry.path(), work_.path()).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

nlohmann::json summary_of(const fs::path& run) {
  return nlohmann::json::parse(read_text(run / "summary.json"));
}

std::vector<double> result_of(const fs::path& run, const std::string& dataset) {
  return hdf5::File::open(run / "results.h5").dataset(dataset).read();
}

std::vector<std::string> results_in(const fs::path& run, const std::string& group) {
  const hdf5::File file = hdf5::File::open(run / "results.h5");
  return file.contains(group) ? file.children(group) : std::vector<std::string>{};
}

std::vector<std::pair<std::string, std::vector<double>>> all_results(const fs::path& run) {
  std::vector<std::pair<std::string, std::vector<double>>> found;
  for (const std::string group : {"series", "ledger", "breakage", "fragments", "product", "holdup"})
    for (const std::string& name : results_in(run, group)) {
      if (name == "wall_seconds") continue;
      std::vector<double> values = result_of(run, group + "/" + name);
      // "None" is NaN in the file; here it must be equal to itself.
      std::replace_if(
          values.begin(), values.end(), [](double v) { return std::isnan(v); }, -1e300);
      found.emplace_back(group + "/" + name, std::move(values));
    }
  return found;
}

}  // namespace gyro
