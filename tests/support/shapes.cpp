// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/shapes.h"

#include <cmath>
#include <map>

namespace swept::test {
TriMesh makeBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriMesh makeBall(const Eigen::Vector3d& centre, double radius, int levels) {
  TriMesh mesh;
  const double g = (1 + std::sqrt(5.0)) / 2;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (auto& v : mesh.vertices) v.normalize();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto key = std::minmax(a, b);
      auto [it, fresh] = middles.try_emplace(key, static_cast<std::int32_t>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return it->second;
    };
    std::vector<std::array<std::int32_t, 3>> next;
    for (const auto& t : mesh.triangles) {
      const auto ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      next.push_back({t[0], ab, ca});
      next.push_back({t[1], bc, ab});
      next.push_back({t[2], ca, bc});
      next.push_back({ab, bc, ca});
    }
    mesh.triangles = std::move(next);
  }
  for (auto& v : mesh.vertices) v = centre + radius * v;
  return mesh;
}

TriMesh makeCylinder(double radius, double z0, double z1, int sides) {
  TriMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    for (const double z : {z0, z1}) {
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  mesh.vertices.emplace_back(0, 0, z0);
  mesh.vertices.emplace_back(0, 0, z1);
  for (std::int32_t i = 0; i < sides; ++i) {
    const std::int32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    mesh.triangles.push_back({2 * sides, b, a});
    mesh.triangles.push_back({2 * sides + 1, a + 1, b + 1});
  }
  return mesh;
}

TriMesh makeSquareRing(double outer, double inner, double z0, double z1) {
  TriMesh mesh;
  for (const double z : {z0, z1}) {
    for (const double r : {outer, inner}) {
      mesh.vertices.emplace_back(-r, -r, z);
      mesh.vertices.emplace_back(r, -r, z);
      mesh.vertices.emplace_back(r, r, z);
      mesh.vertices.emplace_back(-r, r, z);
    }
  }
  auto quad = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t j = (i + 1) % 4;
    quad(i, j, j + 8, i + 8);            // outer wall
    quad(i + 4, i + 12, j + 12, j + 4);  // inner wall
    quad(i + 8, j + 8, j + 12, i + 12);  // top
    quad(i, i + 4, j + 4, j);            // bottom
  }
  return mesh;
}

TriMesh makeTorus(double ringRadius, double tubeRadius, int around, int across) {
  TriMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = ringRadius + tubeRadius * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v));
    }
  }
  auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

void append(TriMesh& mesh, const TriMesh& other) {
  const auto shift = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto t : other.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
}

TriMesh inverted(TriMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriMesh transformed(TriMesh mesh, const Eigen::Isometry3d& placement) {
  for (auto& v : mesh.vertices) v = placement * v;
  return mesh;
}

TriMesh soup(const TriMesh& mesh) {
  TriMesh result;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<std::int32_t>(result.vertices.size());
    for (const std::int32_t v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

double signedVolume(const TriMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[0]] - mesh.vertices[0];
    const Eigen::Vector3d b = mesh.vertices[t[1]] - mesh.vertices[0];
    const Eigen::Vector3d c = mesh.vertices[t[2]] - mesh.vertices[0];
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

double surfaceArea(const TriMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d u = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Eigen::Vector3d v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    sum += u.cross(v).norm() / 2;
  }
  return sum;
}

Eigen::Isometry3d placement(const Eigen::Vector3d& axis, double degrees,
                            const Eigen::Vector3d& translation) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (degrees != 0) {
    result.linear() = Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
  }
  result.translation() = translation;
  return result;
}

Pose poseOf(double timeSeconds, const Eigen::Isometry3d& placement) {
  Pose pose;
  pose.timeSeconds = timeSeconds;
  pose.rotation = Eigen::Quaterniond(placement.linear());
  pose.translation = placement.translation();
  return pose;
}

}  // namespace swept::test
