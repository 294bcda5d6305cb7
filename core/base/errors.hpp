// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace gyro {

/// Input that cannot be used: the message says what is wrong and what to do. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run left its limits of validity (not finite, overlap, energy). Exit code 4.
struct StoppedByGuard : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A window was given up before its end, because somebody asked for it (GiveUp in core/scene/window.hpp).
struct WindowGivenUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be written or the disk is full. Exit code 5.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The device asked for is not there, or memory ran out. Exit code 6.
struct NoDevice : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gyro
