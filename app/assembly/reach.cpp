// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/reach.hpp"

#include "app/assembly/mesh_checks.hpp"
#include "app/assembly/rocks.hpp"
#include "app/simulation/time_step.hpp"
#include "core/geometry/mesh_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace gyro {
namespace {

Extents around(const Vec3d& point) {
  return {point, point};
}

void add(std::optional<Extents>& box, const Extents& e) {
  if (!box) {
    box = e;
    return;
  }
  box->low = {std::min(box->low.x, e.low.x), std::min(box->low.y, e.low.y), std::min(box->low.z, e.low.z)};
  box->high = {std::max(box->high.x, e.high.x), std::max(box->high.y, e.high.y), std::max(box->high.z, e.high.z)};
}

/// Box of a wall as drawn; none for a plane.
std::optional<Extents> box_of(const Wall& wall) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&wall.shape)) return extents_of(*mesh);
  const auto* profile = std::get_if<ProfileShape>(&wall.shape);
  if (profile == nullptr) return std::nullopt;
  std::optional<Extents> box;
  for (const ProfilePoint& p : profile->points) add(box, {{-p.r, -p.r, p.z}, {p.r, p.r, p.z}});
  return box;
}

using Boxes = std::vector<std::optional<Extents>>;  ///< one per wall

Boxes boxes_of(const std::vector<Wall>& walls) {
  Boxes boxes;
  for (const Wall& wall : walls) boxes.push_back(box_of(wall));
  return boxes;
}

/// Where rock appears. @param boxes  of the walls
std::optional<Extents> rock_box(const Case& input, const Setup& setup, const Boxes& boxes) {
  std::optional<Extents> box;
  for (const NewRock& rock : setup.start)
    for (const NewParticle& p : rock.particles) add(box, around(p.position));
  if (!setup.feed) return box;
  for (const FixedRock& rock : setup.feed->fixed) add(box, around(rock.position));
  const Index above = input.feed->above;
  if (above != none)
    if (const auto& wall = boxes[static_cast<std::size_t>(above)]) add(box, *wall);
  return box;
}

/// Distance of two boxes; what `fall` along gravity covers does not count.
double gap(const Extents& rock, const Extents& wall, const Vec3d& gravity, double fall) {
  const double low[] = {rock.low.x - wall.high.x, rock.low.y - wall.high.y, rock.low.z - wall.high.z};
  const double high[] = {wall.low.x - rock.high.x, wall.low.y - rock.high.y, wall.low.z - rock.high.z};
  const double pull[] = {gravity.x, gravity.y, gravity.z};
  const double size = norm(gravity);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double share = size > 0 ? std::abs(pull[k]) / size : 0;
    const double below = pull[k] < 0 ? low[k] : high[k], beside = pull[k] < 0 ? high[k] : low[k];
    const double free = std::max({below - share * fall, beside, 0.0});
    square += free * free;
  }
  return std::sqrt(square);
}

/// How far a wall travels, or the rock on it.
double travel(const Wall& wall, const std::optional<Extents>& box, double end) {
  if (const auto* line = std::get_if<LinearMotion>(&wall.motion)) return norm(line->velocity) * end;
  if (const auto* circle = std::get_if<CircularMotion>(&wall.motion)) return 2 * circle->radius;
  const auto* turn = std::get_if<RotationMotion>(&wall.motion);
  return turn == nullptr || !box ? 0 : norm(box->middle() - turn->point) + box->largest();
}

double diagonal(const Extents& box) {
  return norm(box.size());
}

std::string subject(const CaseWall& wall) {
  const auto* file = std::get_if<MeshFile>(&wall.shape);
  return file != nullptr ? name_of(wall, *file) : "wall " + wall.name + ": ";
}

std::string in_words(const char* form, double number) {
  char text[100];
  std::snprintf(text, sizeof text, form, number);
  return text;
}

std::string advice(const CaseWall& wall, const char* keys) {
  const bool mesh = std::holds_alternative<MeshFile>(wall.shape);
  return mesh ? std::string("; check ") + keys + " of walls." + wall.name
              : "; check crusher.profile, which is in metres";
}

}  // namespace

std::vector<std::string> reach_notes(const Case& input, const Setup& setup, double end) {
  const std::vector<Wall>& walls = setup.scene.walls;
  const Boxes boxes = boxes_of(walls);
  std::optional<Extents> rock = rock_box(input, setup, boxes);
  if (!rock) return {};
  const double fall = 0.5 * norm(setup.scene.gravity) * end * end;
  double carried = 20 * removal_depth(setup.library, setup.start) / 2;  // 10 rocks
  for (std::size_t w = 0; w < walls.size(); ++w) carried = std::max(carried, travel(walls[w], boxes[w], end));
  std::vector<bool> reached(walls.size(), false);
  for (bool grows = true; grows;) {  // a wall that rock reaches may carry it to others
    grows = false;
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const auto& box = boxes[w];
      if (reached[w] || !box || gap(*rock, *box, setup.scene.gravity, fall) > diagonal(*rock) + carried) continue;
      reached[w] = grows = true;
      add(rock, *box);
    }
  }
  std::vector<std::string> notes;
  for (std::size_t w = 0; w < input.walls.size(); ++w) {  // not the lid, which the program makes
    const auto& box = boxes[w];
    if (reached[w] || !box) continue;
    notes.push_back(subject(input.walls[w]) +
                    in_words("it lies %.4g m from all rock, so that nothing touches it",
                             gap(*rock, *box, setup.scene.gravity, fall)) +
                    advice(input.walls[w], "shift, scale and rotate"));
  }
  return notes;
}

std::vector<std::string> tiny_wall_notes(const Case& input, const Setup& setup) {
  const double smallest = 2 * smallest_radius(setup.library, setup.start);
  std::vector<std::string> notes;
  for (std::size_t w = 0; w < input.walls.size(); ++w) {  // not the lid, which the program makes
    const auto box = box_of(setup.scene.walls[w]);
    if (!box || !std::isfinite(smallest) || box->largest() >= smallest) continue;
    notes.push_back(subject(input.walls[w]) + in_words("%.3g mm long, ", 1e3 * box->largest()) +
                    in_words("smaller than the smallest particle of %.3g mm", 1e3 * smallest) +
                    advice(input.walls[w], "scale"));
  }
  return notes;
}

}  // namespace gyro
