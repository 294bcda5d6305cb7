// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/speed.hpp"

#include <nlohmann/json.hpp>

namespace gyro::bench {

/// Head of the table.
void print_speed_head();
/// Two lines of the table: rates and memory, and the shares of the phases.
void print(const SpeedResult& result);

/// A result as `bench speed --json` gives it.
nlohmann::ordered_json to_json(const SpeedResult& result);

/// Name of the processor; empty where the system does not say.
std::string processor_name();

}  // namespace gyro::bench
