// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gyro::report {

/// Which points of a curve are drawn, so that it looks the same with at most `limit` points: the first and the last
/// one, and the lowest and the highest of each of equally long stretches, in order. A stretch with a value that is not
/// finite keeps one such value, where the line is broken. @param limit  at least 8
std::vector<std::size_t> decimated(std::span<const double> y, std::size_t limit = 1500);

}  // namespace gyro::report
