// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/expected_counts.hpp"
#include "app/assembly/free_memory.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cmath>
#include <fstream>

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

constexpr double kb = 1024, gb = 1e9;

/// A root folder with files as the system shows them.
struct FakeSystem {
  ScratchDirectory scratch;

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((scratch.path() / name).parent_path());
    std::ofstream(scratch.path() / name) << text;
  }
  FreeMemory free() const { return free_memory(scratch.path()); }
};

}  // namespace

TEST_CASE("Free memory is that of the machine, and unlimited where nothing is known") {
  const FakeSystem system;
  CHECK(std::isinf(system.free().bytes));
  system.write("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:         1000 kB\nMemAvailable:    9000000 kB\n");
  CHECK(system.free().bytes == 9e6 * kb);
  CHECK(system.free().what == "the memory that is free");
  system.write("proc/self/cgroup", "0::/user.slice\n");
  system.write("sys/fs/cgroup/user.slice/memory.max", "max\n");
  CHECK(system.free().bytes == 9e6 * kb);
}

TEST_CASE("A control group of version 2, or one above it, bounds the memory") {
  const FakeSystem system;
  system.write("proc/meminfo", "MemAvailable:    9000000 kB\n");
  system.write("proc/self/cgroup", "0::/job/step\n");
  const std::string job = "sys/fs/cgroup/job/", step = job + "step/";
  system.write(step + "memory.max", "2000000000\n");
  CHECK(system.free().bytes == 2 * gb);
  system.write(step + "memory.current", "500000000\n");
  CHECK(system.free().bytes == 1.5 * gb);
  system.write(step + "memory.stat", "anon 1\nfile 300000000\ninactive_file 100000000\nactive_file 200000000\n");
  CHECK(system.free().bytes == 1.8 * gb);
  CHECK_THAT(system.free().what, Contains("control group") && Contains("sys/fs/cgroup/job/step/memory.max"));
  system.write(job + "memory.max", "1000000000\n");
  system.write(job + "memory.current", "1200000000\n");
  CHECK(system.free().bytes == 0);
  CHECK_THAT(system.free().what, Contains("sys/fs/cgroup/job/memory.max"));
}

TEST_CASE("A container that sees its own group as the root of the file system is bounded by it") {
  const std::string seen = GENERATE(as<std::string>{}, "0::/\n", "0::/../../job\n", "0::/docker/5a1f\n");
  CAPTURE(seen);
  const FakeSystem system;
  system.write("proc/meminfo", "MemAvailable:    9000000 kB\n");
  system.write("proc/self/cgroup", seen);
  system.write("sys/fs/cgroup/memory.max", "3000000000\n");
  CHECK(system.free().bytes == 3 * gb);
}

TEST_CASE("A control group of version 1 bounds the memory") {
  const FakeSystem system;
  system.write("proc/meminfo", "MemAvailable:    9000000 kB\n");
  system.write("proc/self/cgroup", "9:name=systemd:/\n5:cpu,memory:/slurm/job\n3:cpuset:/other\n0::/\n");
  const std::string job = "sys/fs/cgroup/memory/slurm/job/";
  system.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // none
  CHECK(system.free().bytes == 9e6 * kb);
  system.write(job + "memory.limit_in_bytes", "4000000000\n");
  system.write(job + "memory.usage_in_bytes", "3000000000\n");
  system.write(job + "memory.stat", "inactive_file 7\ntotal_inactive_file 500000000\ntotal_active_file 500000000\n");
  CHECK(system.free().bytes == 2 * gb);
}

TEST_CASE("The limits of address space and data bound the memory") {
  const FakeSystem system;
  const std::string head = "Limit                     Soft Limit           Hard Limit           Units     \n";
  system.write("proc/meminfo", "MemAvailable:    9000000 kB\n");
  system.write("proc/self/status", "Name:\tgyrosim\nVmSize:\t  100000 kB\nVmData:\t   50000 kB\n");
  system.write("proc/self/limits", head +
                                       "Max data size             unlimited            unlimited            bytes\n"
                                       "Max address space         2000000000           unlimited            bytes\n");
  CHECK(system.free().bytes == 2 * gb - 1e5 * kb);
  CHECK_THAT(system.free().what, Contains("ulimit -v"));
  system.write("proc/self/limits",
               head + "Max data size             1000000000           unlimited            bytes\n");
  CHECK(system.free().bytes == 1 * gb - 5e4 * kb);
  CHECK_THAT(system.free().what, Contains("ulimit -d"));
}

namespace {

ExpectedCounts counts_of(double start, double fed) {
  ExpectedCounts counts;
  counts.rocks = counts.particles = start;
  counts.fed_rocks = counts.fed_particles = fed;
  counts.bytes_at_start = expected_bytes(start, 0, Precision::mixed);
  counts.bytes = expected_bytes(start + fed, 0, Precision::mixed);
  return counts;
}

}  // namespace

TEST_CASE("A start that exceeds the free memory is refused with what limits it") {
  Setup setup;
  setup.feed.emplace();
  const FreeMemory memory{expected_bytes(1e6, 0, Precision::mixed), "what a test leaves"};
  CHECK(check_counts(counts_of(0.8e6, 0), setup, memory).empty());
  ExpectedCounts long_window = counts_of(1e3, 0);
  long_window.window_bytes = memory.bytes;
  CHECK_THROWS_WITH(check_counts(long_window, setup, memory),
                    Contains("a coupling interval take 1.34 GB") && Contains("more than 0.9 of what a test leaves"));
  CHECK_THROWS_WITH(check_counts(counts_of(0.95e6, 0), setup, memory),
                    Contains("more than 0.9 of what a test leaves, 1.34 GB"));
}

TEST_CASE("A feed that adds more than the free memory is noted, since not all of it may find room") {
  Setup setup;
  setup.feed.emplace();
  const FreeMemory memory{expected_bytes(1e6, 0, Precision::mixed), "what a test leaves"};
  CHECK(check_counts(counts_of(0.1e6, 0.7e6), setup, memory).empty());
  const ExpectedCounts much = counts_of(0.1e6, 0.9e6);
  const auto note = [&] {
    const std::vector<std::string> notes = check_counts(much, setup, memory);
    REQUIRE(notes.size() == 1);
    return notes[0];
  };
  CHECK_THAT(note(), Contains("the feed adds 9e+05 particles, about 1.34 GB in all, if all of it finds room (without a "
                              "crusher nothing is removed): more than 0.9 of what a test leaves"));
  setup.discharge.emplace();
  CHECK_THAT(note(), Contains("1.34 GB in all, if all of it finds room and nothing is discharged: more than 0.9"));
}
