// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/run_ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <thread>

namespace gyro::bench {

std::vector<double> Ensemble::values(const std::string& metric) const {
  std::vector<double> out;
  for (const MemberResult& m : members) {
    const auto found = m.values.find(metric);
    out.push_back(found != m.values.end() ? found->second : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

double Ensemble::cpu_per_simulated_second() const {
  double cpu = 0, simulated = 0;
  for (const MemberResult& m : members) {
    cpu += m.cpu_seconds;
    simulated += m.simulated_seconds;
  }
  return cpu / simulated;
}

int Ensemble::stopped() const {
  return static_cast<int>(
      std::count_if(members.begin(), members.end(), [](const MemberResult& m) { return m.stopped.has_value(); }));
}

std::string Ensemble::first_reason() const {
  for (const MemberResult& m : members)
    if (m.stopped) return *m.stopped;
  return {};
}

Ensemble run_ensemble(const Member& first, int seeds, int threads) {
  Ensemble ensemble;
  ensemble.members.resize(static_cast<std::size_t>(seeds));
  std::vector<std::exception_ptr> failures(ensemble.members.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < ensemble.members.size(); k = next++) {
      Member member = first;
      member.seed = static_cast<int>(k) + 1;
      try {
        ensemble.members[k] = run_member(member);
      } catch (...) {
        failures[k] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> team;
    for (int t = 1; t < std::min(threads, seeds); ++t) team.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return ensemble;
}

}  // namespace gyro::bench
