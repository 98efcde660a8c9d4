// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/inputs.h"

#include <cstdio>
#include <cstdlib>

#include "support/shapes.h"

namespace swept::fuzz {
namespace {

TriMesh looseTriangles(ByteSource& bytes) {
  TriMesh mesh;
  const int vertices = bytes.below(24), triangles = bytes.below(40);
  for (int v = 0; v < vertices; ++v) mesh.vertices.push_back(bytes.point());
  for (int t = 0; t < triangles; ++t) {
    const auto index = [&] { return static_cast<std::int32_t>(bytes.below(vertices + 1)); };
    const std::int32_t a = index(), b = index(), c = index();
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

TriMesh evenBox(ByteSource& bytes) {
  const Eigen::Vector3d a(bytes.even(), bytes.even(), bytes.even());
  const Eigen::Vector3d size(bytes.even(), bytes.even(), bytes.even());
  return test::makeBox(a, a + size);
}

TriMesh firstBody(ByteSource& bytes) {
  switch (bytes.below(8)) {
    case 0:
      return looseTriangles(bytes);
    case 1:
      return test::makeBall({0, 0, 0}, 1 + bytes.below(4), bytes.below(3));
    case 2:
      return test::makeTorus(2, 0.25 * (1 + bytes.below(7)), 3 + bytes.below(14),
                             3 + bytes.below(9));
    case 3:
      return test::makeCylinder(1 + bytes.below(3), -1, 1, 3 + bytes.below(20));
    case 4: {
      TriMesh mesh = evenBox(bytes);
      const int more = bytes.below(4);
      for (int i = 0; i < more; ++i) test::append(mesh, evenBox(bytes));
      return mesh;
    }
    case 5:
      return test::makeSquareRing(3, 1, -bytes.below(3), bytes.even());
    default:
      return evenBox(bytes);
  }
}

/// Damages the mesh in up to five places.
void damage(TriMesh& mesh, ByteSource& bytes) {
  const int changes = bytes.below(6);
  for (int i = 0; i < changes; ++i) {
    if (mesh.triangles.empty() || mesh.vertices.empty()) return;
    auto& triangle = mesh.triangles[bytes.byte() % mesh.triangles.size()];
    auto& vertex = mesh.vertices[bytes.byte() % mesh.vertices.size()];
    switch (bytes.below(8)) {
      case 0:
        vertex[bytes.below(3)] = bytes.special();
        break;
      case 1:
        vertex = bytes.point();
        break;
      case 2:
        vertex = mesh.vertices[bytes.byte() % mesh.vertices.size()];
        break;
      case 3:
        triangle[bytes.below(3)] = static_cast<std::int32_t>(bytes.byte()) - 2;
        break;
      case 4:
        std::swap(triangle[0], triangle[1]);
        break;
      case 5: {
        const auto copy = triangle;
        mesh.triangles.push_back(copy);
        break;
      }
      case 6:
        triangle = mesh.triangles.back();
        mesh.triangles.pop_back();
        break;
      default:
        mesh = test::inverted(mesh);
    }
  }
}

}  // namespace

TriMesh body(ByteSource& bytes) {
  TriMesh mesh = firstBody(bytes);
  damage(mesh, bytes);
  constexpr double kScales[] = {1, 1, 1, 1, 1e-3, 1e3, 1e-9, 1e7};
  const double scale = kScales[bytes.below(8)];
  constexpr double kPlaces[] = {0, 0, 0, 0, 1, 1e6, 5e8, 1e12};
  const double position = kPlaces[bytes.below(8)];
  for (auto& v : mesh.vertices) v = v * scale + Eigen::Vector3d(position, -position, position / 3);
  return mesh;
}

Trajectory motion(ByteSource& bytes) {
  Trajectory motion;
  constexpr Interpolation kKinds[] = {Interpolation::Linear, Interpolation::Screw,
                                      Interpolation::None};
  motion.interpolation = kKinds[bytes.below(3)];
  const int poses = bytes.below(7);
  double time = 0;
  for (int i = 0; i < poses; ++i) {
    Pose pose;
    const int kind = bytes.below(8);
    if (kind < 4) {
      const Eigen::Vector3d axis(bytes.even(), bytes.even(), bytes.even() + 0.03);
      pose.rotation = Eigen::AngleAxisd(bytes.odd() / 2, axis.normalized());
    } else if (kind == 4) {
      const double x = bytes.number(), y = bytes.number(), z = bytes.number();
      pose.rotation = Eigen::Quaterniond(bytes.number(), x, y, z);
    } else if (kind == 5 && i > 0) {
      pose = motion.poses.back();
    }
    if (kind != 5) pose.translation = bytes.point();
    time += bytes.chance(250) ? 1 : bytes.number();
    pose.timeSeconds = time;
    motion.poses.push_back(pose);
  }
  return motion;
}

bool printsInputs() { return std::getenv("SWEPT_FUZZ_SHOW") != nullptr; }

void show(const Trajectory& motion) {
  std::printf("%s\n", interpolationName(motion.interpolation));
  for (const Pose& p : motion.poses) {
    std::printf("pose %g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", p.timeSeconds,
                p.translation.x(), p.translation.y(), p.translation.z(), p.rotation.x(),
                p.rotation.y(), p.rotation.z(), p.rotation.w());
  }
}

void show(const TriMesh& mesh) {
  for (const auto& v : mesh.vertices) std::printf("v %.17g %.17g %.17g\n", v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles) std::printf("f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
  std::fflush(stdout);
}

}  // namespace swept::fuzz
