// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"

#include <string>
#include <utility>

namespace gyro {

/// A problem of a case that is found only when it is assembled, with the key of the case file that causes it.
struct BadKey : BadInput {
  BadKey(std::string blamed, const std::string& problem) : BadInput(problem), key(std::move(blamed)) {}
  std::string key;
};

/// Does `work`; turns a BadInput that it throws into a BadKey with this key.
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
