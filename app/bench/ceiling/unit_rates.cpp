// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ceiling/unit_rates.hpp"

#include "app/bench/ceiling/bond_loop.hpp"
#include "core/math/pack.hpp"

#include <utility>

namespace gyro::bench {
namespace {

constexpr int repetitions = 20000;

/// A number that the compiler does not know.
template <class T>
T unknown(double value) {
  volatile T number = static_cast<T>(value);
  return number;
}

struct Add {
  template <class P>
  static P next(P x, P c) {
    return x + c;
  }
};
struct Multiply {
  template <class P>
  static P next(P x, P c) {
    return x * c;
  }
};
struct Divide {
  template <class P>
  static P next(P x, P c) {
    return c / x;
  }
};
/// With an addition, which another unit does meanwhile, so that the number is not 1.
struct Root {
  template <class P>
  static P next(P x, P c) {
    return sqrt(x + c);
  }
};

/// Chains of dependent operations, independent of each other: as many as keep two units of four cycles busy, and as the
/// 16 registers of AVX2 hold.
template <class P, class Even, class Odd, int... chain>
void run(std::integer_sequence<int, chain...>) {
  using T = typename LaneOf<P>::type;
  const P c(unknown<T>(1));
  P x[] = {P(unknown<T>(1 + 0.1 * chain))...};
  for (int k = 0; k < repetitions; ++k)
    ((x[chain] = chain % 2 == 0 ? Even::next(x[chain], c) : Odd::next(x[chain], c)), ...);
  P sum(0);
  ((sum = sum + x[chain]), ...);
  [[maybe_unused]] volatile T result = sum[0];
}

/// Time of one operation on one number [ns].
template <class P, class Even, class Odd, int chains>
double time_of() {
  const double seconds = seconds_of([] { run<P, Even, Odd>(std::make_integer_sequence<int, chains>{}); });
  return 1e9 * seconds / (static_cast<double>(repetitions) * chains * P::lanes);
}

}  // namespace

template <class T, int N>
OperationTimes measured_times() {
  using P = Pack<T, N>;
  return {.add = time_of<P, Add, Add, 8>(),
          .multiply = time_of<P, Multiply, Multiply, 8>(),
          .pair = 2 * time_of<P, Add, Multiply, 12>(),
          .divide = time_of<P, Divide, Divide, 4>(),
          .root = time_of<P, Root, Root, 8>()};
}

template OperationTimes measured_times<double, register_bytes / 8>();
template OperationTimes measured_times<float, register_bytes / 4>();

}  // namespace gyro::bench
