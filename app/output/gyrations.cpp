// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/gyrations.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace gyro {

void GyrationReader::add(const GyrationWindow& w) {
  State& s = state_;
  if (s.length == 0) s.begin = w.time - w.length;
  s.length += w.length;
  s.power += w.power * w.length;
  s.motor_power += w.motor_power * w.length;
  s.holdup += w.holdup * w.length;
  const double turns = std::floor(std::abs(w.angle) / (2 * std::numbers::pi));
  if (turns <= s.turns) return;
  s.done.gyrations.push_back({s.begin, w.time, s.power / s.length, s.holdup / s.length, w.discharged - s.discharged,
                              s.motor_power / s.length});
  s.sieve_mass.resize(w.sieve_mass.size());
  for (std::size_t k = 0; k < w.sieve_mass.size(); ++k) s.done.sieve_mass.push_back(w.sieve_mass[k] - s.sieve_mass[k]);
  s = {.done = std::move(s.done),
       .turns = turns,
       .discharged = w.discharged,
       .sieve_mass = {w.sieve_mass.begin(), w.sieve_mass.end()}};
}

}  // namespace gyro
