// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Files of this folder that are compiled into the program (CMakeLists.txt), so that it needs none of them to run.
namespace gyro::report::resources {

extern const std::string_view page_css, view3d_js;

}  // namespace gyro::report::resources
