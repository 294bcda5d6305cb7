// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/describe.hpp"

#include <iostream>

int main() {
  std::cout << gyro::json_schema();
}
