// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/run_lock.hpp"

#include "core/base/errors.hpp"
#include "io/run/run_directory.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

using namespace gyro;
using Catch::Matchers::Contains;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr LockTimes quick{20ms, 400ms};

std::string read(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes run.lock like a run on another machine, after `beat` signs of life.
void write_foreign_lock(const fs::path& folder, int beat) {
  std::ofstream(folder / "run.lock") << "host elsewhere\npid 17\nsince 2026-11-30T04:00:00Z\nbeat " << beat << "\n";
}

}  // namespace

TEST_CASE("A directory has only one writer, and a second one is refused with the process of the first") {
  const ScratchDirectory folder;
  std::optional<RunLock> first;
  first.emplace(folder.path());
  CHECK_THROWS_AS(RunLock(folder.path()), BadInput);
  CHECK_THROWS_WITH(RunLock(folder.path()), Contains("a run is still writing here") &&
                                                Contains("process " + std::to_string(::getpid()) + " on "));
  first.reset();
  CHECK(fs::is_empty(folder.path()));
  CHECK_NOTHROW(RunLock(folder.path()));
}

TEST_CASE("Whether a run writes into a directory can be seen without taking the lock") {
  const ScratchDirectory folder;
  CHECK_FALSE(is_locked(folder.path() / "nowhere"));
  CHECK_FALSE(is_locked(folder.path()));
  std::optional<RunLock> lock;
  lock.emplace(folder.path());
  CHECK(is_locked(folder.path()));
  CHECK(is_locked(folder.path()));
  lock.reset();
  CHECK_FALSE(is_locked(folder.path()));
  std::ofstream(folder.path() / "run.lock") << "host here\npid 1\n";  // of a run that was killed
  CHECK_FALSE(is_locked(folder.path()));
}

TEST_CASE("The lock of a process that was killed can be taken") {
  const ScratchDirectory folder;
  int ready[2];
  REQUIRE(::pipe(ready) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const RunLock held(folder.path());
    [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char byte = 0;
  REQUIRE(::read(ready[0], &byte, 1) == 1);
  CHECK_THROWS_AS(RunLock(folder.path()), BadInput);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.path() / "run.lock"));
  CHECK_NOTHROW(RunLock(folder.path()));
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST_CASE("A run on another machine holds its lock while it gives signs of life") {
  const ScratchDirectory folder;
  write_foreign_lock(folder.path(), 0);
  std::jthread other([&](const std::stop_token& stop) {
    for (int beat = 1; !stop.stop_requested(); ++beat) {
      write_foreign_lock(folder.path(), beat);
      std::this_thread::sleep_for(5ms);
    }
  });
  CHECK_THROWS_WITH(RunLock(folder.path(), quick), Contains("process 17 on elsewhere since 2026-11-30T04:00:00Z"));
  other.request_stop();
  other.join();
  CHECK_NOTHROW(RunLock(folder.path(), quick));
}

TEST_CASE("The holder of a lock gives signs of life") {
  const ScratchDirectory folder;
  const RunLock held(folder.path(), quick);
  const std::string before = read(folder.path() / "run.lock");
  CHECK_THAT(before, Contains("pid " + std::to_string(::getpid())));
  for (int k = 0; k < 500 && read(folder.path() / "run.lock") == before; ++k) std::this_thread::sleep_for(10ms);
  CHECK(read(folder.path() / "run.lock") != before);
}

TEST_CASE("A holder that has lost its lock to another run detects this and leaves the other run's file") {
  const ScratchDirectory folder;
  {
    const RunLock held(folder.path(), quick);
    CHECK_FALSE(held.lost());
    write_foreign_lock(folder.path(), 1);
    for (int k = 0; k < 500 && !held.lost(); ++k) std::this_thread::sleep_for(10ms);
    CHECK(held.lost());
  }
  CHECK_THAT(read(folder.path() / "run.lock"), Contains("host elsewhere"));
}

TEST_CASE("A run directory cannot be opened by a second run at the same time") {
  const ScratchDirectory folder;
  {
    const RunDirectory first = open_run_directory({.out = folder.path()});
    CHECK_THROWS_WITH(open_run_directory({.out = folder.path(), .overwrite = true}), Contains("still writing here"));
    CHECK_THROWS_WITH(open_run_directory({.out = folder.path(), .resume = true}), Contains("still writing here"));
    std::ofstream(folder.path() / "results.h5") << "rows";
    CHECK_THROWS_WITH(lock_run_directory(folder.path()), Contains("still writing here"));
    CHECK(fs::file_size(folder.path() / "results.h5") == 4);  // the file of the first run is unchanged
  }
  std::filesystem::remove(folder.path() / "results.h5");
  {
    const RunLock just_begun(folder.path());  // a run that has not written anything yet
    CHECK_THROWS_WITH(lock_run_directory(folder.path()), Contains("still writing here"));
  }
  std::ofstream(folder.path() / "results.h5") << "rows";
  const auto lock = lock_run_directory(folder.path());
  REQUIRE(lock);
  CHECK_NOTHROW(open_run_directory({.out = folder.path(), .overwrite = true, .lock = lock}));
}
