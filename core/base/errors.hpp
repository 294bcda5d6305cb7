// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/printable.hpp"

#include <stdexcept>
#include <string>

namespace gyro {

/// A failure whose message is for the user; what it quotes of files is printable.
struct Failure : std::runtime_error {
  explicit Failure(const std::string& message) : std::runtime_error(printable(message)) {}
};

/// Input that cannot be used: the message says what is wrong and what to do. Exit code 2.
struct BadInput : Failure {
  using Failure::Failure;
};

/// The run left its limits of validity (not finite, overlap, energy). Exit code 4.
struct StoppedByGuard : Failure {
  using Failure::Failure;
};

/// A window was given up before its end, because somebody asked for it (GiveUp in core/scene/window.hpp).
struct WindowGivenUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be written or the disk is full. Exit code 5.
struct OutputError : Failure {
  using Failure::Failure;
};

/// The device asked for is not there, or memory ran out. Exit code 6.
struct NoDevice : Failure {
  using Failure::Failure;
};

}  // namespace gyro
