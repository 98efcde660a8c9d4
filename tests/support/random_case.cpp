// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/random_case.h"

#include <algorithm>
#include <numeric>

#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

Eigen::Vector3d inCube(std::mt19937& random, double half) {
  return {uniform(random, -half, half), uniform(random, -half, half), uniform(random, -half, half)};
}

/// Numbers are drawn in a fixed order, since compilers evaluate arguments in different orders.
Eigen::Isometry3d randomPlacement(std::mt19937& random, const Eigen::Vector3d& axisNear,
                                  double mostDegrees, double reach) {
  const Eigen::Vector3d shift = inCube(random, reach);
  const double degrees = uniform(random, 0, mostDegrees);
  return placement(inCube(random, 1) + axisNear, degrees, shift);
}

TriMesh randomPiece(std::mt19937& random) {
  TriMesh mesh;
  switch (uniformBelow(5, random)) {
    case 0: {
      const Eigen::Vector3d half = Eigen::Vector3d(1.5, 1.5, 1.5) + inCube(random, 0.9);
      mesh = makeBox(-half, half);
      break;
    }
    case 1:
      mesh = makeBall({0, 0, 0}, uniform(random, 1, 2), 3);
      break;
    case 2: {
      const double top = uniform(random, 0.5, 2.5);
      mesh = makeCylinder(uniform(random, 0.7, 1.6), -1, top, 48);
      break;
    }
    case 3:
      mesh = makeTorus(2, uniform(random, 0.5, 0.9), 36, 20);
      break;
    default:
      mesh = makeSquareRing(2, uniform(random, 0.8, 1.3), -0.6, 0.7);
  }
  return transformed(mesh, randomPlacement(random, {0, 0, 1.1}, 180, 1));
}

}  // namespace

TriMesh randomBody(std::mt19937& random) {
  TriMesh mesh = randomPiece(random);
  if (uniform(random, 0, 1) < 0.3) append(mesh, randomPiece(random));
  return mesh;
}

Trajectory randomMotion(std::mt19937& random) {
  Trajectory motion;
  constexpr Interpolation kinds[3] = {Interpolation::None, Interpolation::Linear,
                                      Interpolation::Screw};
  motion.interpolation = kinds[uniformBelow(3, random)];
  const int count = 2 + uniformBelow(3, random);
  Eigen::Isometry3d now = randomFrame(random);
  for (int i = 0; i < count; ++i) {
    motion.poses.push_back(poseOf(i, now));
    now = now * randomPlacement(random, {0, 1.1, 0}, 100, 3);
  }
  return motion;
}

Eigen::Isometry3d randomFrame(std::mt19937& random) {
  return randomPlacement(random, {1.1, 0, 0}, 360, 100);
}

TriMesh shuffled(const TriMesh& mesh, std::mt19937& random) {
  std::vector<std::int32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  TriMesh result;
  result.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < order.size(); ++v) result.vertices[order[v]] = mesh.vertices[v];
  for (const auto& t : mesh.triangles) {
    const int k = uniformBelow(3, random);
    result.triangles.push_back({order[t[k]], order[t[(k + 1) % 3]], order[t[(k + 2) % 3]]});
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

}  // namespace swept::test
