// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// The indices [begin, end).
struct IndexRange {
  Index begin, end;
};

}  // namespace gyro
