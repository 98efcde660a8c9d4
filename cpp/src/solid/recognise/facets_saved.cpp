// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/facets_saved.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFacetsOfPlane = 3;  // facets that any plane saves, whatever its size
// Area of the largest triangle within the tolerance of a sphere, divided by tolerance times radius.
// An equilateral triangle with circumradius R has the area 3 sqrt(3) / 4 R^2. If its vertices lie
// outside the sphere by the tolerance, and its centre lies inside by the tolerance, then R^2 = 4
// tolerance radius.
constexpr double kAreaPerFacet = 5.2;

// Returns the angle about the axis that the patch spans, from the positions of its vertices. The
// normals of small triangles scatter too much.
double angleOf(const HalfEdgeMesh& mesh, const Patch& patch) {
  const Carrier& s = patch.surface;
  const auto outward = [&](std::int32_t v) {
    const Vector3d d = mesh.points[v] - s.point;
    return Vector3d(d - d.dot(s.axis) * s.axis).normalized();
  };
  Vector3d mean = Vector3d::Zero();
  for (const std::int32_t t : patch.triangles) {
    for (const std::int32_t v : mesh.triangles[t]) mean += outward(v);
  }
  mean.normalize();
  double smallest = 1;
  for (const std::int32_t t : patch.triangles) {
    for (const std::int32_t v : mesh.triangles[t])
      smallest = std::min(smallest, outward(v).dot(mean));
  }
  return 2 * std::acos(std::max(-1.0, smallest));
}

double curvatureAt(const Profile& profile, double t) {
  Vector2d first, second;
  profile.derivatives(t, first, second);
  return std::abs(first.x() * second.y() - first.y() * second.x()) / std::pow(first.norm(), 3);
}

// Returns the number of flat strips that approximate the surface within the tolerance. Each runs
// along the direction of extrusion or around the axis. A revolution is curved around its axis, too:
// if it needs more triangles than strips, as a torus does, returns the number of triangles.
double savedByProfile(const HalfEdgeMesh& mesh, const Patch& patch, double tolerance) {
  constexpr int kSteps = 200;
  const Profile& profile = *patch.surface.profile;
  const double from = profile.nodes().front().knot, step = profile.length() / kSteps;
  double strips = 0, facets = 0;
  for (int i = 0; i < kSteps; ++i)
    strips += step * std::sqrt(curvatureAt(profile, from + (i + 0.5) * step) / tolerance);
  if (patch.surface.kind == CarrierKind::Extrusion) return strips;
  for (const std::int32_t t : patch.triangles) {
    const Vector2d q = patch.surface.inProfile(mesh.points[mesh.triangles[t][0]]);
    const Profile::Foot foot = profile.foot(q);
    const double across = std::abs(foot.tangent.y()) / std::max(q.x(), tolerance);
    const double area = 0.5 * mesh.areaVector(t).norm();
    facets += area * std::sqrt(curvatureAt(profile, foot.t) * across) / (kAreaPerFacet * tolerance);
  }
  return std::max(strips, facets);
}

}  // namespace

double facetsSaved(const HalfEdgeMesh& mesh, const Patch& patch, double tolerance) {
  const Carrier& s = patch.surface;
  if (s.isPlanar()) return kFacetsOfPlane;
  if (s.hasProfile()) return savedByProfile(mesh, patch, tolerance);
  if (s.kind == CarrierKind::Sphere || s.kind == CarrierKind::Torus) {
    const double radius =
        s.kind == CarrierKind::Sphere ? s.radius : std::sqrt(s.minor * (s.radius + s.minor));
    return areaOf(mesh, patch.triangles) / (kAreaPerFacet * tolerance * radius);
  }
  // Strips along the axis, with two facets each.
  return angleOf(mesh, patch) / std::sqrt(4 * tolerance / s.radius);
}

}  // namespace swept::step
