// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/results.hpp"
#include "io/run/snapshots.hpp"
#include "io/run/state_file.hpp"
#include "io/run/summary.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <functional>

using namespace gyro;

namespace {

/// Runs `write` in a process whose files cannot grow beyond `bytes`, as on a full disk.
/// @returns the message of the OutputError, or a description of what happened instead
std::string message_with_limit(rlim_t bytes, const std::function<void()>& write) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::string message = "no error";
    try {
      write();
    } catch (const OutputError& error) {
      message = error.what();
    } catch (const std::exception& error) {
      message = std::string("other error: ") + error.what();
    }
    const bool told = ::write(ends[1], message.data(), message.size()) == static_cast<ssize_t>(message.size());
    std::exit(told ? 0 : 1);  // runs everything that a program does at its end
  }
  ::close(ends[1]);
  std::string message(4096, '\0');
  const ssize_t length = ::read(ends[0], message.data(), message.size());
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return "crashed";
  return message.substr(0, static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
}

void write_results(const std::filesystem::path& path) {
  ResultsContent content;
  content.groups = {{"/series", {}}};
  for (int c = 0; c < 24; ++c) content.groups[0].channels.push_back({"channel_" + std::to_string(c), "1"});
  ResultsFile results(path, content);
  for (int row = 0; row < 10000; ++row) results.append("/series", std::vector<double>(24, row));
  results.close();
}

}  // namespace

TEST_CASE("A full disk during the writing of results is an OutputError") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  // The disk is full at once, later, or only at the last rows (of 1.9 MB of data).
  for (const rlim_t limit : {0, 500, 5000, 50000, 500000, 1800000}) {
    CAPTURE(limit);
    const std::string message = message_with_limit(limit, [&] { write_results(path); });
    CHECK_THAT(message, Catch::Matchers::StartsWith(path.string()));
    CHECK_THAT(message, Catch::Matchers::Contains("File too large"));
  }
  CHECK(message_with_limit(10000000, [&] { write_results(path); }) == "no error");
}

TEST_CASE("A full disk during the writing of a snapshot is an OutputError") {
  const ScratchDirectory scratch;
  ParticleSnapshot particles;
  for (Index p = 0; p < 5000; ++p) {
    particles.id.push_back(static_cast<ParticleId>(p));
    particles.rock.push_back(0);
    particles.fragment.push_back(0);
    particles.position.push_back({0.3 * p, 0.7 * p * p, 1.0 / (1 + p)});
    particles.velocity.push_back({0, 0, 0});
    particles.force.push_back({0, 0, 0});
    particles.radius.push_back(1);
    particles.mass.push_back(1);
  }
  const std::string message = message_with_limit(10000, [&] {
    SnapshotWriter writer(scratch.path());
    writer.write({.time = 0, .particles = &particles});
  });
  CHECK_THAT(message, Catch::Matchers::Contains("particles_000000.vtp: cannot write: File too large"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "particles.pvd"));
  CHECK(std::filesystem::is_empty(scratch.path() / "snapshots"));
}

TEST_CASE("A full disk leaves the earlier summary unchanged") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "summary.json";
  write_summary({.status = RunStatus::done, .simulated_seconds = 2}, scratch.path());
  const std::string message = message_with_limit(100, [&] { write_summary({.title = "new"}, scratch.path()); });
  CHECK_THAT(message, Catch::Matchers::Contains("summary.json: cannot write: File too large"));
  CHECK(read_summary(scratch.path())->simulated_seconds == 2);
  CHECK_FALSE(std::filesystem::exists(path.string() + ".tmp"));
}

TEST_CASE("A full disk leaves the earlier checkpoint unchanged and no temporary file") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "checkpoint.h5";
  SavedState old, large;
  old.put("numbers/one", std::vector<double>{1});
  large.put("numbers/many", std::vector<double>(100000, 2));
  write_state(path, old);
  for (const rlim_t limit : {0, 100, 3000, 100000, 790000}) {
    CAPTURE(limit);
    const std::string message = message_with_limit(limit, [&] { write_state(path, large); });
    CHECK_THAT(message, Catch::Matchers::StartsWith(path.string()));
    CHECK_THAT(message, Catch::Matchers::Contains("File too large"));
    CHECK(read_state(path).get_one<double>("numbers/one") == 1);
    CHECK_FALSE(std::filesystem::exists(path.string() + ".tmp"));
  }
  CHECK(message_with_limit(1000000, [&] { write_state(path, large); }) == "no error");
  CHECK(read_state(path).get<double>("numbers/many").size() == 100000);
}
