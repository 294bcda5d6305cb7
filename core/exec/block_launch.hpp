// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// How many blocks a kernel is run over, and how much of a block can run at once.
struct BlockLaunch {
  Index blocks;
  Index colour_size;  ///< items in a colour on average, or rows without items: that many threads of a GPU have work
};

}  // namespace gyro
