// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"

#include <string>
#include <utility>

namespace gyro {

/// A problem of a case that shows only when it is assembled, with the key of the case file to blame.
struct BadKey : BadInput {
  BadKey(std::string blamed, const std::string& problem) : BadInput(problem), key(std::move(blamed)) {}
  std::string key;
};

/// Does `work`; blames `key` for bad input that it meets.
template <class Work>
auto blaming(const std::string& key, Work&& work) {
  try {
    return work();
  } catch (const BadKey&) {
    throw;
  } catch (const BadInput& problem) {
    throw BadKey(key, problem.what());
  }
}

}  // namespace gyro
