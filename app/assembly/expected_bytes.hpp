// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/precision.hpp"

namespace gyro {

/// Most bytes that a scene takes at a time, set-up included, without meshes and without what the program takes itself
/// (some 40 MB of a run). The sum of
///
///   per particle   its columns, bounds and begins of rows
///   per bond       its columns and its entries in the rows of both particles
///   and the larger of
///     the start      rows of particles and bonds before they are inserted, which are freed then
///     the steps      a snapshot and held forces of each particle, 3.3 pairs a particle less its bonds, each with the
///                    loads of both ends and its place in the list before, candidates, entries near walls
///
/// Pairs, candidates and entries near walls are those of S1 of `bench speed`, loose spheres that fall together. Peaks
/// of S1, S2 and S2r are 0.89 to 0.99 of this (tests/app/expected_bytes_test.cpp). Rock whose bonds are all broken
/// takes as many pairs as loose spheres and keeps the rows of its bonds until rock is removed: some 850 bytes a
/// particle more.
double expected_bytes(double particles, double bonds, Precision precision);

}  // namespace gyro
