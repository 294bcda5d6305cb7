// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/writer_thread.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <pthread.h>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace gyro;

/// A job that lasts until it is let go.
class Gate {
 public:
  void pass() {
    while (!open_) std::this_thread::yield();
  }
  void open() { open_ = true; }

 private:
  std::atomic<bool> open_{false};
};

/// While it exists, no thread can be started: none of this size fits into the address space.
class NoThreads {
 public:
  NoThreads() {
    ::pthread_attr_init(&before_);
    ::pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    ::pthread_attr_init(&huge);
    REQUIRE(::pthread_attr_setstacksize(&huge, std::size_t{1} << 55U) == 0);
    REQUIRE(::pthread_setattr_default_np(&huge) == 0);
    ::pthread_attr_destroy(&huge);
  }
  ~NoThreads() {
    ::pthread_setattr_default_np(&before_);
    ::pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_;
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

TEST_CASE("A writer thread that ends finishes its jobs") {
  Gate gate;
  int done = 0;
  {
    WriterThread writer;
    writer.add([&] {
      gate.pass();
      ++done;
    });
    writer.add([&] { ++done; });
    gate.open();
  }
  CHECK(done == 2);
}

TEST_CASE("A writer thread has room for a job once one of two is done, and has freed what that one owned") {
  Gate first, second;
  WriterThread writer;
  const auto owned = std::make_shared<int>(1);
  writer.add([&, owned] { first.pass(); });
  writer.add([&] { second.pass(); });
  CHECK(owned.use_count() == 2);
  std::atomic<bool> room{false};
  std::thread caller([&] {
    writer.wait_for_room();
    room = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK_FALSE(room);
  first.open();
  caller.join();  // the second job is not done
  CHECK(owned.use_count() == 1);
  second.open();
  writer.finish();
}

TEST_CASE("Where the system starts no more threads, the caller does the jobs of a writer thread") {
  std::vector<std::thread::id> done;
  WriterThread writer;
  {
    const NoThreads meanwhile;
    writer.add([&] { done.push_back(std::this_thread::get_id()); });
    CHECK(done == std::vector{std::this_thread::get_id()});
    writer.finish();
  }
  writer.add([&] { done.push_back(std::this_thread::get_id()); });
  writer.finish();
  REQUIRE(done.size() == 2);
  CHECK(done[1] != std::this_thread::get_id());
}

TEST_CASE("A job that fails in the caller of a writer thread is reported by the next call") {
  const NoThreads meanwhile;
  WriterThread writer;
  CHECK(failure_of([&] { writer.add([] { throw OutputError("disk full"); }); }) == "none");
  CHECK(failure_of([&] { writer.check(); }) == "disk full");
  CHECK(failure_of([&] { writer.finish(); }) == "disk full");
  bool later = false;
  CHECK(failure_of([&] { writer.add([&] { later = true; }); }) == "disk full");
  CHECK_FALSE(later);
}
