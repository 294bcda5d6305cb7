// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace gyro {

/// Says on standard error how far the library of rocks is, where it takes more than two seconds. A LibraryProgress.
class LibraryWait {
 public:
  LibraryWait();
  void operator()(int made, int of) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace gyro
