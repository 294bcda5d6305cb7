// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/rig.hpp"

#include <cmath>

namespace gyro::verify {
namespace {

constexpr double cylinder = 1, eccentricity = 0.02, pivot = 100;

Scene rig_scene(const Material& material, const PairProperties& pair, double dt,
                const std::optional<BondParameters>& bonds) {
  Scene scene = scene_of(material, rigid(), pair, dt);
  scene.bonds = bonds;
  scene.walls = {
      {"cylinder", ProfileShape{{{cylinder, 0.5}, {cylinder, -0.5}}}, GyrationMotion{eccentricity, pivot}, 1}};
  return scene;
}

/// Eccentric angle at which the cylinder stands `press` beyond its first place.
double angle_of(double press) {
  return pi / 2 - std::asin(press / eccentricity);
}

/// Turn of the cylinder about its axis for a shear: it makes up for the way of the axis along y.
double turn_of(double press, double shear) {
  return (shear + eccentricity * (1 - std::sin(angle_of(press)))) / cylinder;
}

}  // namespace

Rig::Rig(const Material& material, const PairProperties& pair, double dt, const NewRock& rock, Precision precision,
         const std::optional<BondParameters>& bonds)
    : stage_(rig_scene(material, pair, dt, bonds), precision) {
  stage_.insert({rock});
}

void Rig::move(double press, double shear, int steps) {
  const double time = steps * stage_.dt(), angle = angle_of(press_), turn = turn_of(press_, shear_);
  press_ += press;
  shear_ += shear;
  stage_.advance(steps, {angle, (angle_of(press_) - angle) / time, turn, (turn_of(press_, shear_) - turn) / time});
  work_ += stage_.dem().wall_loads()[0].work;
}

}  // namespace gyro::verify
