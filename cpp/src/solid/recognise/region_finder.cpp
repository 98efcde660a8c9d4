// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/region_finder.h"

#include <algorithm>
#include <cmath>

namespace swept::step {

using Eigen::Vector3d;

Samples RegionFinder::samplesOf(const std::vector<std::int32_t>& region, std::size_t maxCount,
                                bool needles) {
  Samples samples;
  ++pointStamp_;
  const std::size_t stride = std::max<std::size_t>(1, region.size() / maxCount);
  for (std::size_t i = 0; i < region.size(); i += stride) {
    if (shapes_.thin[region[i]] && !needles) continue;
    for (const std::int32_t v : mesh_.triangles[region[i]]) {
      if (pointStampOf_[v] == pointStamp_) continue;
      pointStampOf_[v] = pointStamp_;
      samples.points.push_back(mesh_.points[v]);
      samples.normals.push_back(shapes_.normal[region[i]]);
    }
  }
  return samples;
}

bool RegionFinder::bends(const std::vector<std::int32_t>& region) const {
  constexpr double kMinTurn = 0.98;  // cosine of 11 degrees
  const Vector3d& first = shapes_.normal[region.front()];
  return std::any_of(region.begin(), region.end(), [&](std::int32_t t) {
    return !shapes_.thin[t] && first.dot(shapes_.normal[t]) < kMinTurn;
  });
}

bool liesOn(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, std::int32_t t,
            const Carrier& surface, double tolerance, double minCosine) {
  Vector3d centre = Vector3d::Zero();
  for (const std::int32_t v : mesh.triangles[t]) {
    if (!(std::abs(surface.distance(mesh.points[v])) <= tolerance)) return false;
    centre += mesh.points[v] / 3;
  }
  return shapes.thin[t] || surface.normal(centre).dot(shapes.normal[t]) >= minCosine;
}

double medianDistance(const HalfEdgeMesh& mesh, const Carrier& surface,
                      const std::vector<std::int32_t>& triangles) {
  if (triangles.empty()) return 0;
  std::vector<double> distances;
  distances.reserve(triangles.size());
  for (const std::int32_t t : triangles)
    distances.push_back(std::abs(surface.distance(mesh.points[mesh.triangles[t][0]])));
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2];
}

}  // namespace swept::step
