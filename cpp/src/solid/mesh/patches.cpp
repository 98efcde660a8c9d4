// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/patches.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace swept::step {
namespace {

// Cosine of 45 degrees. If the angle of a triangle to the plane of its region is larger, the
// triangle is a fold, unless it is a sliver.
constexpr double kMinCosine = 0.7;

// Moments of a growing set of points, relative to a nearby base point to avoid cancellation.
struct PlaneFit {
  Eigen::Vector3d base = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double count = 0;

  void add(const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = p - base;
    sum += d;
    products += d * d.transpose();
    count += 1;
  }
  // Fits the plane. Its normal points to the side of `towards`. Returns false if the points do not
  // determine a plane.
  bool solve(const Eigen::Vector3d& towards, Carrier& plane) const {
    if (count < 3) return false;
    const Eigen::Vector3d mean = sum / count;
    const Eigen::Matrix3d covariance = products / count - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d values = solver.eigenvalues();
    if (values[1] < 1e-12 * values[2]) return false;  // the points lie on a line
    plane.axis = solver.eigenvectors().col(0).normalized();
    if (plane.axis.dot(towards) < 0) plane.axis = -plane.axis;
    plane.point = base + mean;
    return true;
  }
};

struct PlaneGrower {
  const HalfEdgeMesh& mesh;
  double tolerance;
  Partition& partition;
  const TriangleShapes& shapes;
  std::vector<std::int32_t> inRegion;   ///< stamp of the last region that took the triangle
  std::vector<std::int32_t> pointSeen;  ///< stamp of the last region that took the vertex
  std::int32_t stamp = 0;

  bool accepts(std::int32_t t, const Carrier& plane) const {
    if (partition.patchOf[t] >= 0) return false;
    for (const std::int32_t v : mesh.triangles[t]) {
      if (std::abs(plane.distance(mesh.points[v])) > tolerance) return false;
    }
    return shapes.height[t] <= 2 * tolerance || shapes.normal[t].dot(plane.axis) >= kMinCosine;
  }

  // Grows a region breadth first from the seed. With `refit`, fits the plane again each time the
  // region has doubled its size.
  std::vector<std::int32_t> grow(std::int32_t seed, Carrier& plane, bool refit) {
    ++stamp;
    PlaneFit fit;
    fit.base = mesh.points[mesh.triangles[seed][0]];
    const Eigen::Vector3d side = plane.axis;
    std::vector<std::int32_t> region{seed};
    inRegion[seed] = stamp;
    double refitAt = 6;
    auto addPoints = [&](std::int32_t t) {
      for (const std::int32_t v : mesh.triangles[t]) {
        if (pointSeen[v] == stamp) continue;
        pointSeen[v] = stamp;
        fit.add(mesh.points[v]);
      }
    };
    addPoints(seed);
    for (std::size_t i = 0; i < region.size(); ++i) {
      for (const std::int32_t other : mesh.neighbours(region[i])) {
        if (inRegion[other] == stamp || !accepts(other, plane)) continue;
        inRegion[other] = stamp;
        region.push_back(other);
        addPoints(other);
        if (refit && fit.count >= refitAt) {
          fit.solve(side, plane);
          refitAt = 2 * fit.count;
        }
      }
    }
    if (refit) fit.solve(side, plane);
    return region;
  }

  void fromSeed(std::int32_t seed) {
    Carrier plane;
    plane.kind = CarrierKind::Plane;
    plane.axis = shapes.normal[seed];
    plane.point = mesh.points[mesh.triangles[seed][0]];
    std::vector<std::int32_t> region = grow(seed, plane, true);
    if (region.size() < 2) return;
    if (largestDistance(mesh, region, plane) > tolerance) {
      // The plane has moved away from triangles that were added early. Grow again with the final
      // plane, which excludes them.
      if (!accepts(seed, plane)) {
        plane.axis = shapes.normal[seed];
        plane.point = mesh.points[mesh.triangles[seed][0]];
      }
      region = grow(seed, plane, false);
      if (region.size() < 2) return;
    }
    Patch patch;
    patch.deviation = largestDistance(mesh, region, plane);
    patch.surface = plane;
    for (const std::int32_t t : region) {
      partition.patchOf[t] = static_cast<std::int32_t>(partition.patches.size());
    }
    patch.triangles = std::move(region);
    partition.patches.push_back(std::move(patch));
  }
};

}  // namespace

TriangleShapes shapesOf(const HalfEdgeMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  TriangleShapes shapes{std::vector<Eigen::Vector3d>(count), std::vector<double>(count),
                        std::vector<double>(count), std::vector<char>(count)};
  parallelBlocks(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Eigen::Vector3d vector = mesh.areaVector(static_cast<std::int32_t>(t));
      const double twice = vector.norm();
      const double longest = std::max({(mesh.points[a] - mesh.points[b]).norm(),
                                       (mesh.points[b] - mesh.points[c]).norm(),
                                       (mesh.points[c] - mesh.points[a]).norm()});
      shapes.area[t] = 0.5 * twice;
      shapes.height[t] = longest > 0 ? twice / longest : 0;
      shapes.normal[t] = twice > 0 ? Eigen::Vector3d(vector / twice) : Eigen::Vector3d::Zero();
      shapes.thin[t] = twice < 0.05 * longest * longest;
    }
  });
  return shapes;
}

double areaOf(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles) {
  double area = 0;
  for (const std::int32_t t : triangles) area += 0.5 * mesh.areaVector(t).norm();
  return area;
}

double largestDistance(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles,
                       const Carrier& surface) {
  double largest = 0;
  for (const std::int32_t t : triangles) {
    for (const std::int32_t v : mesh.triangles[t])
      largest = std::max(largest, std::abs(surface.distance(mesh.points[v])));
  }
  return largest;
}

void growPlanes(const HalfEdgeMesh& mesh, double tolerance, Partition& partition, RunContext& run) {
  const std::size_t count = mesh.triangles.size();
  const TriangleShapes shapes = shapesOf(mesh);
  PlaneGrower grower{mesh,
                     tolerance,
                     partition,
                     shapes,
                     std::vector<std::int32_t>(count, 0),
                     std::vector<std::int32_t>(mesh.points.size(), 0)};
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return shapes.area[a] > shapes.area[b]; });
  std::uint64_t done = 0;
  for (const std::int32_t seed : order) {
    if ((++done & 4095U) == 0) run.checkpoint(Phase::Export, done, 20 * count);
    if (partition.patchOf[seed] < 0 && shapes.area[seed] > 0) grower.fromSeed(seed);
  }
}

namespace {
void setFacet(const HalfEdgeMesh& mesh, std::int32_t t, Patch& patch) {
  patch.surface = Carrier{};
  patch.surface.kind = CarrierKind::Facet;
  patch.surface.axis = mesh.areaVector(t).normalized();
  patch.surface.point = mesh.points[mesh.triangles[t][0]];
  patch.triangles.assign(1, t);
  patch.deviation = 0;
  patch.surfaceId = -1;
}
}  // namespace

void addFacets(const HalfEdgeMesh& mesh, Partition& partition) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (partition.patchOf[t] >= 0) continue;
    partition.patchOf[t] = static_cast<std::int32_t>(partition.patches.size());
    partition.patches.emplace_back();
    setFacet(mesh, static_cast<std::int32_t>(t), partition.patches.back());
  }
}

void dissolvePatch(const HalfEdgeMesh& mesh, std::int32_t patch, Partition& partition) {
  const std::vector<std::int32_t> members = std::move(partition.patches[patch].triangles);
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::int32_t target = patch;
    if (i > 0) {
      target = static_cast<std::int32_t>(partition.patches.size());
      partition.patches.emplace_back();
    }
    partition.patchOf[members[i]] = target;
    setFacet(mesh, members[i], partition.patches[target]);
  }
}

}  // namespace swept::step
