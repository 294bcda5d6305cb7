// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/touch.hpp"

namespace gyro {

/// How far two touches with cosine c between their normals compete for the same place:
///   k = max(0, 2 c - 1): 1 for parallel normals, 0 from 60 degrees on, so that a corner of
/// 120 degrees or sharper is two full contacts and a facet seam is one.
GYRO_HD inline double competition(double cosine) {
  const double k = 2 * cosine - 1;
  return k > 0 ? k : 0;
}

/// Weights of the visible points of one wall for a sphere of radius R.
///
///   d_i  = R - h_i                            overlap at point i, at height h_i below the centre
///   s_ij = max(0, h_j - n_i.n_j h_i)          height of point i above the tangent plane of j
///   l_j  = min(d_j, min_k s_jk)               how firmly j stands itself
///   c_ij = s_ij / (s_ij + k_ij l_j)           0 when j's plane holds point i, 1 when j fades
///   a_i  = d_i prod_j c_ij                    presence of i
///   w_i  = a_i / (a_i + sum_j k_ij a_j)       k_ij: competition()
///
/// Each term is symmetric under exchange of two points and continuous in the centre: a point comes
/// and goes with presence 0, whether its overlap or its distance to a seam vanishes, and one with
/// presence 0 changes no weight of others. Parallel normals share one weight, sum w = 1; in a flat
/// seam w is the share of the distance to the seam; beyond 60 degrees every w = 1. (What a vanishing
/// point alone has hidden appears at once: that takes three points within 60 degrees, one of them on
/// a ridge.)
struct MergeWeights {
  double weight[VisiblePoints::capacity];

  GYRO_HD MergeWeights(const VisiblePoints& points, double radius) {
    double firmness[VisiblePoints::capacity], presence[VisiblePoints::capacity];
    const int n = points.count;
    for (int j = 0; j < n; ++j) {
      firmness[j] = radius - points.point[j].height;
      for (int k = 0; k < n; ++k)
        if (k != j) {
          const double rise = rise_above(points.point[j], points.point[k]);
          if (rise < firmness[j]) firmness[j] = rise;
        }
    }
    for (int i = 0; i < n; ++i) {
      presence[i] = radius - points.point[i].height;
      for (int j = 0; j < n; ++j)
        if (j != i) {
          const double k = competition(dot(points.point[i].normal, points.point[j].normal));
          const double rise = rise_above(points.point[i], points.point[j]);
          if (rise > 0) presence[i] *= rise / (rise + k * firmness[j]);
        }
    }
    for (int i = 0; i < n; ++i) {
      double sum = presence[i];
      for (int j = 0; j < n; ++j)
        if (j != i) sum += competition(dot(points.point[i].normal, points.point[j].normal)) * presence[j];
      weight[i] = presence[i] / sum;
    }
  }
};

/// Two nearly parallel touches as one: the weights add, normal and gap are their mean.
GYRO_HD inline WallTouch joined(const WallTouch& a, const WallTouch& b) {
  const double weight = a.weight + b.weight;
  const Vec3d normal = a.weight * a.normal + b.weight * b.normal;
  return {1 / norm(normal) * normal, (a.weight * a.gap + b.weight * b.gap) / weight, weight};
}

/// Makes room in a list of `count` touches, deepest first: joins the most parallel pair, or drops
/// the shallowest touch when all normals are more than 60 degrees apart. Keeps the order of depth.
GYRO_HD inline void make_room(WallTouch* touch, int& count) {
  int first = -1, second = -1;
  double closest = 0.5;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      if (dot(touch[i].normal, touch[j].normal) > closest) {
        closest = dot(touch[i].normal, touch[j].normal);
        first = i;
        second = j;
      }
  --count;
  if (first < 0) return;
  WallTouch moved = joined(touch[first], touch[second]);
  for (int i = second; i < count; ++i) touch[i] = touch[i + 1];
  int k = first;
  for (; k + 1 < count && touch[k + 1].gap < moved.gap; ++k) touch[k] = touch[k + 1];
  touch[k] = moved;
}

/// The touches of a sphere with one wall from its visible points.
GYRO_HD inline WallTouches merged_touches(const VisiblePoints& points, double radius) {
  WallTouches result;
  if (points.count == 1) {
    result.touch[0] = {points.point[0].normal, points.point[0].height - radius, 1};
    result.count = 1;
  }
  if (points.count <= 1) return result;
  const MergeWeights weights(points, radius);
  WallTouch touch[VisiblePoints::capacity];
  int count = points.count;
  for (int i = 0; i < count; ++i)
    touch[i] = {points.point[i].normal, points.point[i].height - radius, weights.weight[i]};
  while (count > WallTouches::capacity) make_room(touch, count);
  for (int i = 0; i < count; ++i) result.touch[i] = touch[i];
  result.count = count;
  return result;
}

}  // namespace gyro
