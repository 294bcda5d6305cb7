// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <functional>

namespace gyro::bench {

/// Does `work` in a process of its own and gives what it returns: memory that it used is free again, and the peak of
/// memory is its own. Must be called while this process has one thread.
/// @throws what `work` throws, as BadInput, StoppedByGuard, OutputError or NoDevice of the same message; NoDevice also
/// when the process is ended from outside
nlohmann::json in_own_process(const std::function<nlohmann::json()>& work);

}  // namespace gyro::bench
