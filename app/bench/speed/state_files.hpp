// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/scene.hpp"

#include <filesystem>

namespace gyro::bench {

/// Makes a scene's start state and writes a folder that other programs can read too:
///
///   particles.csv, bonds.csv, WALL.stl   as cases name them; the coordinates are exact, STL is ASCII
///   case.yaml                            the case with every key, which `gyrosim run` takes
///   scene.json                           seed, steps, sizes
///
/// A folder that was made from the same scene, steps and case file is left alone.
/// @param cases  folder of the cases of the program
/// @param above  the folder becomes ABOVE/SCENE-SEED-PARTICLES
/// @return the case to run: case.yaml, or that of a scene without a start state
std::filesystem::path write_start(const SpeedScene& scene, const std::filesystem::path& cases,
                                  const std::filesystem::path& above);

}  // namespace gyro::bench
