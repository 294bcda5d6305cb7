// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/run_directory.hpp"

#include "core/base/errors.hpp"
#include "io/run/summary.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>

using namespace gyro;
using Catch::Matchers::Contains;
using State = RunDirectory::State;
namespace fs = std::filesystem;

namespace {

void touch(const fs::path& path) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "x";
}

}  // namespace

TEST_CASE("Runs without --out get a new numbered directory") {
  const ScratchDirectory scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  CHECK(open_run_directory({.case_name = "quickstart"}).path == "runs/quickstart-001");
  CHECK(open_run_directory({.case_name = "quickstart"}).path == "runs/quickstart-002");
  CHECK(open_run_directory({.case_name = "other"}).path == "runs/other-001");
  fs::create_directories("runs/quickstart-1041");
  fs::create_directories("runs/quickstart-fine-5000");
  touch("runs/quickstart-notes");
  const RunDirectory next = open_run_directory({.case_name = "quickstart"});
  CHECK(next.path == "runs/quickstart-1042");
  CHECK(next.state == State::fresh);
  CHECK(fs::is_directory(next.path));
  CHECK_THROWS_AS(open_run_directory({.case_name = "quickstart", .resume = true}), BadInput);
  CHECK_THROWS_AS(open_run_directory({.case_name = "quickstart", .overwrite = true}), BadInput);
  fs::current_path(before);
}

TEST_CASE("A run in a new or empty --out is fresh, also with --resume") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "a" / "b";
  CHECK(open_run_directory({.out = out}).state == State::fresh);
  CHECK(open_run_directory({.out = out, .resume = true}).state == State::fresh);
  CHECK(fs::is_empty(out));  // the probe was removed
  touch(out / "notes.txt");
  CHECK(open_run_directory({.out = out}).state == State::fresh);
}

TEST_CASE("A finished run is left unchanged unless --overwrite is given") {
  const ScratchDirectory scratch;
  write_summary({.status = RunStatus::done, .simulated_seconds = 2}, scratch.path());
  const RunDirectory plain = open_run_directory({.out = scratch.path()});
  CHECK(plain.state == State::finished);
  CHECK(plain.simulated_seconds == 2);
  CHECK(open_run_directory({.out = scratch.path(), .resume = true}).state == State::finished);
  CHECK(open_run_directory({.out = scratch.path(), .overwrite = true}).state == State::fresh);
  CHECK(fs::is_empty(scratch.path()));
}

TEST_CASE("A half-done run is refused without --resume or --overwrite") {
  const ScratchDirectory scratch;
  touch(scratch.path() / "results.h5");  // killed before it wrote a summary
  CHECK_THROWS_WITH(open_run_directory({.out = scratch.path()}), Contains("--overwrite"));
  CHECK(open_run_directory({.out = scratch.path(), .resume = true}).state == State::half_done);
  write_summary({.status = RunStatus::interrupted, .simulated_seconds = 0.5}, scratch.path());
  CHECK_THROWS_WITH(open_run_directory({.out = scratch.path()}), Contains("interrupted"));
  CHECK(open_run_directory({.out = scratch.path(), .resume = true}).simulated_seconds == 0.5);
  CHECK_THROWS_AS(open_run_directory({.out = scratch.path(), .resume = true, .overwrite = true}), BadInput);
}

TEST_CASE("Option --overwrite removes what a run wrote and nothing else") {
  const ScratchDirectory scratch;
  for (const char* name :
       {"results.h5", "log.txt", "case.yaml", "checkpoint.h5", "checkpoint.h5.tmp", "walls.pvd",
        "snapshots/particles_000000.vtp", "snapshots/walls_1000000.vtp", "snapshots/walls_fixed.vtp"})
    touch(scratch.path() / name);
  for (const char* name : {"notes.txt", "picture.png", "snapshots/particles_mine.vtp", "particles.pvd.bak"})
    touch(scratch.path() / name);
  CHECK(open_run_directory({.out = scratch.path(), .overwrite = true}).state == State::fresh);
  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path()))
    if (entry.is_regular_file()) left.push_back(fs::relative(entry.path(), scratch.path()).string());
  std::sort(left.begin(), left.end());
  CHECK(left ==
        std::vector<std::string>{"notes.txt", "particles.pvd.bak", "picture.png", "snapshots/particles_mine.vtp"});
}

TEST_CASE("A case.yaml alone is taken for the user's own and is not removed") {
  const ScratchDirectory scratch;
  touch(scratch.path() / "case.yaml");
  CHECK_THROWS_AS(open_run_directory({.out = scratch.path()}), BadInput);
  CHECK_THROWS_AS(open_run_directory({.out = scratch.path(), .overwrite = true}), BadInput);
  CHECK(fs::exists(scratch.path() / "case.yaml"));
}

TEST_CASE("An --out that is a file is bad input, and a directory that cannot be made is an output error") {
  const ScratchDirectory scratch;
  touch(scratch.path() / "file");
  CHECK_THROWS_AS(open_run_directory({.out = scratch.path() / "file"}), BadInput);
  CHECK_THROWS_AS(open_run_directory({.out = scratch.path() / "file" / "below"}), OutputError);
  CHECK_THROWS_AS(open_run_directory({.out = "/proc/gyrosim-run"}), OutputError);  // also root cannot write there
}
