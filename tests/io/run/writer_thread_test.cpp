// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/writer_thread.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

namespace {

using namespace gyro;

/// A job that lasts until it is let go.
class Gate {
 public:
  void pass() {
    reached_ = true;
    while (!open_) std::this_thread::yield();
  }
  void wait_until_reached() const {
    while (!reached_) std::this_thread::yield();
  }
  void open() { open_ = true; }

 private:
  std::atomic<bool> reached_{false}, open_{false};
};

std::string failure_of(const std::function<void()>& call) {
  try {
    call();
    return "none";
  } catch (const OutputError& failure) {
    return failure.what();
  }
}

}  // namespace

TEST_CASE("A writer thread does its jobs in their order, and is at most two behind") {
  std::vector<int> done;
  std::atomic<int> begun{0};
  WriterThread writer;
  for (int k = 0; k < 200; ++k) {
    writer.add([&, k] {
      ++begun;
      done.push_back(k);
    });
    CHECK(begun + static_cast<int>(WriterThread::max_jobs) > k);
  }
  writer.finish();
  REQUIRE(done.size() == 200);
  for (int k = 0; k < 200; ++k) CHECK(done[static_cast<std::size_t>(k)] == k);
}

TEST_CASE("A writer thread does not hold up its caller until two jobs wait") {
  Gate gate;
  WriterThread writer;
  writer.add([&] { gate.pass(); });
  writer.add([] {});
  writer.check();
  std::atomic<bool> added{false};
  std::thread caller([&] {
    writer.add([] {});
    added = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK_FALSE(added);
  gate.open();
  caller.join();
  writer.finish();
}

TEST_CASE("A failed job of a writer thread is reported by each later call, and those behind it are not done") {
  Gate gate;
  std::atomic<bool> later{false};
  WriterThread writer;
  writer.add([&] {
    gate.pass();
    throw OutputError("disk full");
  });
  writer.add([&] { later = true; });
  gate.open();
  CHECK(failure_of([&] { writer.finish(); }) == "disk full");
  CHECK(failure_of([&] { writer.check(); }) == "disk full");
  CHECK(failure_of([&] { writer.add([&] { later = true; }); }) == "disk full");
  CHECK_FALSE(later);
}

TEST_CASE("A writer thread that ends finishes its jobs, unless they were dropped") {
  const bool drops = GENERATE(false, true);
  Gate gate;
  int done = 0;
  {
    WriterThread writer;
    writer.add([&] {
      gate.pass();
      ++done;
    });
    writer.add([&] { ++done; });
    gate.wait_until_reached();
    if (drops) writer.drop();
    gate.open();
  }
  CHECK(done == (drops ? 1 : 2));
}
