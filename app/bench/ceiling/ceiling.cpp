// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ceiling/ceiling.hpp"

#include <algorithm>
#include <cstdio>

namespace gyro::bench {
namespace {

constexpr OperationTimes unknown_times{1e9, 1e9, 1e9, 1e9, 1e9};

void keep_shorter(OperationTimes& shortest, const OperationTimes& t) {
  shortest = {std::min(shortest.add, t.add), std::min(shortest.multiply, t.multiply), std::min(shortest.pair, t.pair),
              std::min(shortest.divide, t.divide), std::min(shortest.root, t.root)};
}

/// Processor time of one bond [ns].
double time_of_bond(const BondLoop& loop, const std::function<void(int)>& evaluate) {
  constexpr int passes = 20;
  return 1e9 * seconds_of([&] { evaluate(passes); }) / (passes * loop.bonds);
}

double sums_of(const OperationCounts& n, const OperationTimes& t) {
  const int pairs = std::min(n.add, n.multiply);
  return pairs * t.pair + (n.add - pairs) * t.add + (n.multiply - pairs) * t.multiply;
}
double quotients_of(const OperationCounts& n, const OperationTimes& t) {
  return n.divide * t.divide + n.root * t.root;
}

nlohmann::ordered_json to_json(const OperationCounts& n) {
  return {{"add", n.add}, {"multiply", n.multiply}, {"divide", n.divide}, {"root", n.root}};
}
/// Numbers a second, in units of 1e9.
nlohmann::ordered_json to_json(const OperationTimes& t) {
  return {{"add", 1 / t.add},
          {"multiply", 1 / t.multiply},
          {"add_and_multiply", 2 / t.pair},
          {"divide", 1 / t.divide},
          {"root", 1 / t.root}};
}

void print(const char* precision, const OperationCounts& n, const OperationTimes& t) {
  std::printf(
      "         %-6s %4d additions, %d multiplications, %d divisions, %d roots; this core does %.2f additions, "
      "%.2f multiplications,\n                %.2f of both in turn, %.2f divisions, %.2f roots a ns\n",
      precision, n.add, n.multiply, n.divide, n.root, 1 / t.add, 1 / t.multiply, 2 / t.pair, 1 / t.divide, 1 / t.root);
}

}  // namespace

ArithmeticTime arithmetic_time(const BondOperations& n, const UnitTimes& t) {
  return {.sums = sums_of(n.in_double, t.of_double) + sums_of(n.in_single, t.of_float),
          .quotients = quotients_of(n.in_double, t.of_double) + quotients_of(n.in_single, t.of_float)};
}

std::vector<BondCeiling> measure_bond_ceiling(std::span<const Precision> precisions, int rounds) {
  UnitTimes times{unknown_times, unknown_times};
  std::vector<BondCeiling> ceilings;
  std::vector<BondLoop> loops;
  for (const Precision precision : precisions) {
    ceilings.push_back({precision, bond_operations(precision), times, 1e9, 1e9});
    loops.push_back(bond_loop(precision));
  }
  for (int round = 0; round < rounds; ++round) {
    keep_shorter(times.of_double, measured_times<double, register_bytes / 8>());
    keep_shorter(times.of_float, measured_times<float, register_bytes / 4>());
    for (std::size_t k = 0; k < loops.size(); ++k) {
      BondCeiling& c = ceilings[k];
      c.measured = std::min(c.measured, time_of_bond(loops[k], loops[k].in_packs));
      c.one_by_one = std::min(c.one_by_one, time_of_bond(loops[k], loops[k].one_by_one));
    }
  }
  for (BondCeiling& c : ceilings) c.times = times;
  return ceilings;
}

void print(std::span<const BondCeiling> ceilings) {
  std::printf("\nBonds of one rock in cache, on one core; ceiling: the arithmetic alone (app/bench/README.md)\n");
  std::printf("%-8s %12s %12s %8s %16s\n", "", "ns per bond", "ceiling [ns]", "ratio", "one by one [ns]");
  for (const BondCeiling& c : ceilings) {
    std::printf("%-8s %12.2f %12.2f %8.2f %16.2f\n", to_string(c.precision).c_str(), c.measured, c.ceiling().least(),
                c.ratio(), c.one_by_one);
    print("double", c.operations.in_double, c.times.of_double);
    if (c.precision == Precision::mixed) print("single", c.operations.in_single, c.times.of_float);
  }
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(const BondCeiling& c) {
  return {{"precision", to_string(c.precision)},
          {"ns_per_bond", c.measured},
          {"ceiling_ns_per_bond", c.ceiling().least()},
          {"ratio", c.ratio()},
          {"sums_ns", c.ceiling().sums},
          {"quotients_ns", c.ceiling().quotients},
          {"one_by_one_ns_per_bond", c.one_by_one},
          {"operations", {{"double", to_json(c.operations.in_double)}, {"single", to_json(c.operations.in_single)}}},
          {"operations_per_ns", {{"double", to_json(c.times.of_double)}, {"single", to_json(c.times.of_float)}}}};
}

}  // namespace gyro::bench
