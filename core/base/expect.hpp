// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>

// GYRO_EXPECT(condition): what the program itself must have made true. A debug build stops with file and line where
// it is false, on the host and on the device; a release build does not evaluate it. What a user can cause is an error
// (core/base/errors.hpp), never an expectation.
#if defined(NDEBUG)
#define GYRO_EXPECT(...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#else
#define GYRO_EXPECT(...) assert((__VA_ARGS__))
#endif
