// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"

#include "core/base/thread_team.hpp"

#include <chrono>
#include <numeric>
#include <set>

using namespace gyro;

namespace {

/// How often each thread of a team was called in one job.
std::vector<int> calls_of_one_job(ThreadTeam& team) {
  std::vector<int> calls(static_cast<std::size_t>(team.size()), 0);
  team.run([&](int t) { ++calls.at(static_cast<std::size_t>(t)); });
  return calls;
}

}  // namespace

TEST_CASE("A job calls every index once", "[exec]") {
  const int threads = GENERATE(1, 2, 3, 4, 5, 6, 7, 8);
  ThreadTeam team(threads);
  CHECK(team.size() == threads);
  CHECK(calls_of_one_job(team) == std::vector<int>(static_cast<std::size_t>(threads), 1));
}

TEST_CASE("Each index of a job has its own thread, and the first runs on the caller's", "[exec]") {
  ThreadTeam team(4);
  std::vector<std::thread::id> ids(4);
  team.run([&](int t) { ids[static_cast<std::size_t>(t)] = std::this_thread::get_id(); });
  CHECK(ids[0] == std::this_thread::get_id());
  CHECK(std::set<std::thread::id>(ids.begin(), ids.end()).size() == 4);
}

TEST_CASE("Many short jobs follow each other without losing one", "[exec]") {
  // A job that began before the last one ended, or a thread that served one twice, would spoil the counts.
  const int threads = GENERATE(2, 3, 8);
  const int jobs = 5000;
  ThreadTeam team(threads);
  std::vector<std::int64_t> sums(static_cast<std::size_t>(threads), 0);
  for (int job = 0; job < jobs; ++job) team.run([&](int t) { sums[static_cast<std::size_t>(t)] += job; });
  CHECK(sums == std::vector<std::int64_t>(static_cast<std::size_t>(threads), std::int64_t{jobs} * (jobs - 1) / 2));
}

TEST_CASE("The results of all threads of a job are visible when it returns", "[exec]") {
  ThreadTeam team(4);
  std::vector<int> values(4000, 0);
  for (int job = 1; job <= 200; ++job) {
    team.run([&](int t) {
      for (std::size_t k = static_cast<std::size_t>(t) * 1000; k < (static_cast<std::size_t>(t) + 1) * 1000; ++k)
        values[k] = job;
    });
    REQUIRE(std::accumulate(values.begin(), values.end(), 0) == 4000 * job);
  }
}

TEST_CASE("A team may have more threads than the machine has cores", "[exec]") {
  const int threads = 3 * static_cast<int>(std::max(1u, std::thread::hardware_concurrency())) + 5;
  ThreadTeam team(threads);
  for (int job = 0; job < 20; ++job)
    REQUIRE(calls_of_one_job(team) == std::vector<int>(static_cast<std::size_t>(threads), 1));
}

TEST_CASE("Threads that have fallen asleep serve the next job, and end with their team", "[exec]") {
  for (const auto pause : {std::chrono::milliseconds(0), std::chrono::milliseconds(30)}) {
    auto team = std::make_unique<ThreadTeam>(4);
    std::this_thread::sleep_for(pause);  // they look for work for about 150 us, then sleep
    CHECK(calls_of_one_job(*team) == std::vector<int>(4, 1));
    std::this_thread::sleep_for(pause);
    team.reset();  // hangs if a sleeping thread misses the end
  }
}

TEST_CASE("A team without any job ends", "[exec]") {
  for (int k = 0; k < 50; ++k) ThreadTeam(8);
  SUCCEED();
}

TEST_CASE("Jobs are taken once each, and the failure of the lowest is thrown after all are done") {
  for (const int threads : {1, 2, 7}) {
    ThreadTeam team(threads);
    std::vector<std::atomic<int>> calls(100);
    for_each_job(team, 100, [&](int k) { ++calls[static_cast<std::size_t>(k)]; });
    for (const std::atomic<int>& count : calls) CHECK(count == 1);
    try {
      for_each_job(team, 100, [&](int k) {
        ++calls[static_cast<std::size_t>(k)];
        if (k % 10 == 3) throw k;
      });
      FAIL("nothing was thrown");
    } catch (int k) {
      CHECK(k == 3);
    }
    for (const std::atomic<int>& count : calls) CHECK(count == 2);
    for_each_job(team, 0, [](int) { FAIL("there is no job"); });
  }
  CHECK(all_cores() >= 1);
}
