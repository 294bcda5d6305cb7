// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/free_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr double kilobyte = 1024;  // of /proc

/// The number in the line of a file that begins with `name`; nothing if there is no such line, or no number in it.
std::optional<double> number_of(const fs::path& file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(name)) continue;
    std::istringstream rest(line.substr(name.size()));
    double number = 0;
    if (rest >> number) return number;
  }
  return std::nullopt;
}

/// A file with one number; none for the word `max`.
std::optional<double> number_in(const fs::path& file) {
  return number_of(file, "");
}

/// A version of control groups: where they are mounted, and the names of what they say of memory.
struct Version {
  const char *folder, *limit, *used, *inactive_cache, *active_cache;
};
constexpr Version version_2{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file ", "active_file "};
constexpr Version version_1{"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                            "total_inactive_file ", "total_active_file "};

/// Path of the control group of this process that limits memory, as "/user.slice/run"; none if there is none.
std::optional<fs::path> own_group(const fs::path& root, const Version& version) {
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {  // "4:cpu,memory:/path", version 2: "0::/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool own = &version == &version_2 ? controllers == ",," : controllers.find(",memory,") != std::string::npos;
    if (own) return fs::path(line.substr(second + 1)).lexically_normal();
  }
  return std::nullopt;
}

void add_group(std::vector<FreeMemory>& bounds, const fs::path& folder, const Version& version) {
  const std::optional<double> limit = number_in(folder / version.limit);
  if (!limit) return;
  const fs::path stat = folder / "memory.stat";
  const double used = number_in(folder / version.used).value_or(0);
  const double cache =
      number_of(stat, version.inactive_cache).value_or(0) + number_of(stat, version.active_cache).value_or(0);
  bounds.push_back({std::max(0.0, *limit - std::max(0.0, used - cache)),
                    "what the limit of a control group leaves (" + (folder / version.limit).string() + ")"});
}

/// Limits of a control group and of all above it. In a container the path of the group may be that of the machine,
/// where the folder is that of the container: then only the root is there.
void add_groups(std::vector<FreeMemory>& bounds, const fs::path& root, const Version& version) {
  const std::optional<fs::path> group = own_group(root, version);
  if (!group) return;
  const fs::path top = root / version.folder;
  fs::path folder = top;
  add_group(bounds, folder, version);
  for (const fs::path& part : group->relative_path()) {
    if (part.empty() || part == "..") continue;
    folder /= part;
    add_group(bounds, folder, version);
  }
}

void add_resource_limit(std::vector<FreeMemory>& bounds, const fs::path& root, const char* limit, const char* used,
                        const char* what) {
  const std::optional<double> most = number_of(root / "proc/self/limits", limit);
  if (!most) return;  // unlimited
  const double now = kilobyte * number_of(root / "proc/self/status", used).value_or(0);
  bounds.push_back({std::max(0.0, *most - now), what});
}

}  // namespace

FreeMemory free_memory(const fs::path& root) {
  std::vector<FreeMemory> bounds{{std::numeric_limits<double>::infinity(), "the memory"}};
  if (const auto free = number_of(root / "proc/meminfo", "MemAvailable:"))
    bounds.push_back({kilobyte * *free, "the memory that is free"});
  add_groups(bounds, root, version_2);
  add_groups(bounds, root, version_1);
  add_resource_limit(bounds, root, "Max address space",
                     "VmSize:", "what the limit of the address space leaves (ulimit -v)");
  add_resource_limit(bounds, root, "Max data size", "VmData:", "what the limit of the data leaves (ulimit -d)");
  return *std::ranges::min_element(bounds, {}, &FreeMemory::bytes);
}

}  // namespace gyro
