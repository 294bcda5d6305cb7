// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/walls.hpp"
#include "core/surfaces/mesh_grid.hpp"
#include "core/surfaces/profile_surface.hpp"

#include <list>

namespace gyro {

/// The shapes of a scene's walls in an executor's memory.
template <class Exec>
class WallSurfaces {
 public:
  /// @throws BadInput for a shape that cannot be used
  explicit WallSurfaces(const std::vector<Wall>& walls) {
    std::vector<WallSurface> surfaces;
    for (const Wall& wall : walls)
      surfaces.push_back(std::visit([this](const auto& s) { return stored(s); }, wall.shape));
    for (const WallSurface& s : surfaces) extents_.push_back(s.extent);
    Exec::upload(surfaces_, std::move(surfaces));
  }

  const WallSurface* data() const { return surfaces_.data(); }
  Index count() const { return static_cast<Index>(extents_.size()); }
  double extent(std::size_t wall) const { return extents_[wall]; }
  bool bounded(std::size_t wall) const { return extents_[wall] < endless; }

 private:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  WallSurface stored(const PlaneShape& plane) { return {WallKind::plane, plane, {}, {}, endless}; }
  WallSurface stored(const ProfileShape& shape) {
    const ProfileSurface made(shape);
    ProfileView view = made.view();
    view.segments = keep(segments_, made.segments());
    view.bins = keep(bins_, made.bins());
    double extent = 0;
    for (const ProfilePoint& p : shape.points) extent = larger(extent, ::sqrt(p.r * p.r + p.z * p.z));
    return {WallKind::profile, {}, view, {}, extent};
  }
  WallSurface stored(const TriangleMesh& shape) {
    const MeshGrid made(shape);
    MeshView view = made.view();
    view.triangles = keep(triangles_, made.triangles());
    view.cell_begin = keep(indices_, made.cell_begin());
    view.items = keep(indices_, made.items());
    view.large = keep(indices_, made.large());
    double extent = 0;
    for (const Vec3d& v : shape.vertices) extent = larger(extent, norm(v));
    return {WallKind::mesh, {}, {}, view, extent};
  }

  template <class T>
  static const T* keep(std::list<Buffer<T>>& store, const std::vector<T>& values) {
    Exec::upload(store.emplace_back(), values);
    return store.back().data();
  }

  std::list<Buffer<ProfileSegment>> segments_;
  std::list<Buffer<SegmentRange>> bins_;
  std::list<Buffer<WallTriangle>> triangles_;
  std::list<Buffer<Index>> indices_;
  Buffer<WallSurface> surfaces_;
  std::vector<double> extents_;
};

}  // namespace gyro
