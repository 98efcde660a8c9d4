// Closed meshes and a motion for the tests of the solid export.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "support/shapes.h"
#include "swept/types.h"

namespace swept::test {

/// Returns the boundary of a set of voxels of size `cell`: two triangles per face, shared vertices.
inline TriMesh voxelMesh(const std::function<bool(int, int, int)>& inside, int nx, int ny, int nz,
                         double cell = 1.0) {
  TriMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> ids;
  auto filled = [&](std::array<int, 3> c) {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < nx && c[1] < ny && c[2] < nz &&
           inside(c[0], c[1], c[2]);
  };
  auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, fresh] = ids.try_emplace(p, static_cast<std::int32_t>(mesh.vertices.size()));
    if (fresh) mesh.vertices.emplace_back(cell * p[0], cell * p[1], cell * p[2]);
    return it->second;
  };
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) {
        if (!filled({i, j, k})) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (int side = 0; side < 2; ++side) {
            std::array<int, 3> other{i, j, k};
            other[axis] += side == 1 ? 1 : -1;
            if (filled(other)) continue;
            std::array<std::int32_t, 4> quad{};
            for (int corner = 0; corner < 4; ++corner) {
              std::array<int, 3> p{i, j, k};
              p[axis] += side;
              p[(axis + 1) % 3] += corner == 1 || corner == 2 ? 1 : 0;
              p[(axis + 2) % 3] += corner >= 2 ? 1 : 0;
              quad[corner] = vertex(p);
            }
            if (side == 0) std::swap(quad[1], quad[3]);
            mesh.triangles.push_back({quad[0], quad[1], quad[2]});
            mesh.triangles.push_back({quad[0], quad[2], quad[3]});
          }
        }
      }
    }
  }
  return mesh;
}

inline TriMesh boxMesh(int nx, int ny, int nz, double cell = 1.0) {
  return voxelMesh([](int, int, int) { return true; }, nx, ny, nz, cell);
}

/// Returns a body of revolution about z. The profile (radius, z) runs so that the material lies on
/// its left seen with r to the right and z up. Open profiles start and end on the axis, closed ones
/// do not touch it.
inline TriMesh revolved(const std::vector<Eigen::Vector2d>& profile, bool closed, int around) {
  TriMesh mesh;
  std::vector<std::vector<std::int32_t>> rows;
  for (const auto& p : profile) {
    std::vector<std::int32_t> row;
    const int count = p.x() > 0 ? around : 1;
    for (int i = 0; i < count; ++i) {
      const double u = 2 * M_PI * i / around;
      row.push_back(static_cast<std::int32_t>(mesh.vertices.size()));
      mesh.vertices.emplace_back(p.x() * std::cos(u), p.x() * std::sin(u), p.y());
    }
    rows.push_back(row);
  }
  const std::size_t steps = closed ? rows.size() : rows.size() - 1;
  for (std::size_t k = 0; k < steps; ++k) {
    const auto& a = rows[k];
    const auto& b = rows[(k + 1) % rows.size()];
    for (std::size_t i = 0; i < static_cast<std::size_t>(around); ++i) {
      const std::size_t j = (i + 1) % static_cast<std::size_t>(around);
      if (b.size() == 1) {
        mesh.triangles.push_back({a[i], a[j], b[0]});
      } else if (a.size() == 1) {
        mesh.triangles.push_back({a[0], b[j], b[i]});
      } else {
        mesh.triangles.push_back({a[i], a[j], b[j]});
        mesh.triangles.push_back({a[i], b[j], b[i]});
      }
    }
  }
  return mesh;
}

/// Appends points from a to b to the profile. Leaves out a if skipFirst.
inline void line(std::vector<Eigen::Vector2d>& profile, const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b, int steps, bool skipFirst = true) {
  for (int i = skipFirst ? 1 : 0; i <= steps; ++i)
    profile.push_back(a + (b - a) * (double(i) / steps));
}

inline void append(TriMesh& mesh, const TriMesh& other) {
  const auto base = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

inline TriMesh transformed(TriMesh mesh, const Eigen::Quaterniond& rotation,
                           const Eigen::Vector3d& shift) {
  for (auto& p : mesh.vertices) p = rotation * p + shift;
  return mesh;
}

inline Eigen::Quaterniond oddTurn() {
  return Eigen::Quaterniond(0.71, 0.23, -0.41, 0.52).normalized();
}

inline double meshVolume(const TriMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  }
  return volume;
}

/// Returns a straight motion from the present position of the body.
inline Trajectory along(const Eigen::Vector3d& travel) {
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[1].timeSeconds = 1;
  trajectory.poses[1].translation = travel;
  return trajectory;
}

}  // namespace swept::test
