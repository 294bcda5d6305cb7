// SPDX-License-Identifier: GPL-3.0-or-later
// A library that expects a function from its host, like libraries that embed an interpreter.

extern "C" {
const char* nobody_has_this();

const char* fmi2GetVersion() {
  return nobody_has_this();
}
}
