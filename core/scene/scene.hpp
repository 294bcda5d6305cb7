// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/quat.hpp"
#include "core/scene/bond_model.hpp"
#include "core/scene/bond_parameters.hpp"
#include "core/scene/load_table.hpp"
#include "core/scene/material.hpp"
#include "core/scene/new_rock.hpp"
#include "core/scene/triangle_mesh.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// Infinite plane; rock is on the side of the normal.
struct PlaneShape {
  Vec3d point;
  Vec3d normal;  ///< unit
};

/// A point of a liner's profile.
struct ProfilePoint {
  double r, z;  ///< distance from the axis, height [m]
};

/// Surface of revolution about the body's z axis: an open polyline in the (r, z) half-plane.
/// Rock is on the left of the direction of travel.
struct ProfileShape {
  std::vector<ProfilePoint> points;
};

struct Fixed {};
struct LinearMotion {
  Vec3d velocity;  ///< [m/s]
};
struct RotationMotion {
  Vec3d axis;  ///< unit
  Vec3d point;
  double speed;  ///< [rad/s]
};
/// Translation on a horizontal circle, starting at the drawn position: r (sin wt, 1 - cos wt, 0).
struct CircularMotion {
  double radius, period;  ///< [m], [s]
};
/// Gyration about the pivot (0, 0, pivot_height): the axis leans so that the mantle is nearest to
/// the concave at the azimuth of the eccentric angle. `lift` moves the mantle along its axis, which
/// is how the setting is imposed.
struct GyrationMotion {
  double eccentricity;  ///< half the throw, in the plane z = 0 [m]
  double pivot_height;  ///< [m]
  double lift = 0;      ///< [m]
};

/// A rigid wall. Its shape is given in its own frame, which is the world at rest.
struct Wall {
  std::string name;
  std::variant<PlaneShape, ProfileShape, TriangleMesh> shape;
  std::variant<Fixed, LinearMotion, RotationMotion, CircularMotion, GyrationMotion> motion;
  Index material = 0;
};

/// Where a wall is and how it moves: x_world = origin + rotate(orientation, x_body),
/// velocity at a world point p = velocity + angular_velocity x (p - origin).
struct WallPose {
  Vec3d origin{0, 0, 0};
  Quatd orientation{1, 0, 0, 0};
  Vec3d velocity{0, 0, 0};          ///< of the body's origin [m/s]
  Vec3d angular_velocity{0, 0, 0};  ///< [rad/s]

  template <class F, class... P>
  static constexpr void for_each_field(F&& f, P&... p) {
    f("origin", p.origin...);
    f("orientation", p.orientation...);
    f("velocity", p.velocity...);
    f("angular_velocity", p.angular_velocity...);
  }
};
static_assert(declares_every_field<WallPose>);

/// Per-step limits; exceeding one raises a flag. Beyond them the contacts' geometry or the bonds' law fails.
///
/// With a particle and a wall that each move by up to 0.2 R in a step, a particle crosses a thin wall unnoticed only
/// where overlaps exceed 0.8 R: a crossing from 0.2 R in front of it to 0.2 R behind it takes 0.4 R.
struct StepLimits {
  double overlap_ratio = 0.8;  ///< overlap / smaller radius [-]
  double speed_ratio = 0.2;    ///< v dt / R [-]
  double rotation = 0.1;       ///< angular velocity x dt [rad]
  double contact_step = 1;     ///< step / stability limit of what a particle touches [-]
  double bond_rotation = 0.5;  ///< 2 sin(theta/2), theta the rotation of a bond's ends against each other [rad]
};

/// When a rock, or a piece of one, moves as one rigid body in place of particles and bonds.
struct RigidLevel {
  double bonded_above = 0.5;  ///< static stress / strength of a bond beyond which the rock's bonds are evaluated [-]
  double rigid_below = 0.2;   ///< largest stress / strength with which a rock becomes rigid [-]
  double calm_time = 5e-3;    ///< for how long it must stay below [s]
  double look_interval =
      1e-4;  ///< longest time between two looks at the loads of rigid rocks, or a step if that is longer [s]
  std::shared_ptr<const std::vector<LoadTable>> tables;  ///< of NewRock::load_table; never null. Shared: they are large
  /// Of a rock free of load that is in one piece, in the frame of its particles. Empty: rocks without a table, and
  /// pieces of broken rocks, are never rigid.
  std::function<std::unique_ptr<LoadResponse>(const NewRock&)> response_of = {};
};

/// Everything about a DEM scene that does not change while it runs.
struct Scene {
  std::vector<Material> materials;
  std::vector<PairProperties> pairs;  ///< square table, materials x materials
  Index rock_material = 0;
  std::optional<BondParameters> bonds;  ///< none: unbreakable spheres, no columns or pass of bonds
  BondModel bond_model;                 ///< law of the bonds
  std::vector<Wall> walls;
  Vec3d gravity{0, 0, -9.81};
  double dt = 0;              ///< step, from one evaluation of contact and wall forces to the next [s]
  int substeps = 1;           ///< steps of a rock's bonds in one of the scene; a rock may have its own (NewRock)
  double damping_cap = 1;     ///< beta of largest_dashpot(): a large number for dashpots without a cap [-]
  double neighbour_skin = 0;  ///< twice the way that any particle may go until neighbours are sought again, 0: by their
                              ///< speed [m]; changes speed, never results
  StepLimits limits;
  std::optional<RigidLevel> rigid;  ///< none: bonds of all rocks are always evaluated
  bool wall_impulses = false;       ///< Dem::take_wall_impulses() has something to give
};

}  // namespace gyro
