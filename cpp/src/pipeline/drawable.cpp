// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/drawable.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/lists_by_key.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_parts.h"

namespace swept {
namespace {

using Triangle = std::array<std::int32_t, 3>;
using Eigen::Vector3d;

/// Thinning stops if the number of triangles is at most this many times the requested number.
constexpr double kMaxExcess = 1.2;
/// Weight of the mean point of a cell, relative to the planes in the cell.
constexpr double kMeanWeight = 0.001;
/// Largest index of a cell along one side of the grid: a key holds 21 bits per axis.
constexpr double kMaxCells = 0x1fffff;
/// Corners of one vertex share a point if the cosine between their normals is above this.
constexpr double kSameNormal = 0.999;

double areaOf(const TriMesh& mesh) {
  double twice = 0;
  for (const Triangle& t : mesh.triangles) twice += areaVector(mesh, t).norm();
  return 0.5 * twice;
}

/// Gives consecutive numbers to keys, in the order of their first use.
class Numbering {
 public:
  explicit Numbering(std::size_t most) {
    std::size_t size = 16;
    while (size < 2 * most) size *= 2;
    keys_.assign(size, kFree);
    numbers_.resize(size);
  }
  std::int32_t of(std::uint64_t key) {
    const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
    std::size_t at = (mixed ^ mixed >> 32) & (keys_.size() - 1);
    while (keys_[at] != key) {
      if (keys_[at] == kFree) {
        keys_[at] = key;
        numbers_[at] = count_++;
        break;
      }
      at = (at + 1) & (keys_.size() - 1);
    }
    return numbers_[at];
  }
  std::int32_t count() const { return count_; }

 private:
  // Not a key: keys of cells have 63 bits.
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  std::vector<std::uint64_t> keys_;
  std::vector<std::int32_t> numbers_;
  std::int32_t count_ = 0;
};

/// Returns for each vertex the number of its grid cell. Only cells with vertices get a number.
std::vector<std::int32_t> cellsOf(const TriMesh& mesh, double cell, std::int32_t& count) {
  Vector3d low = mesh.vertices[0];
  for (const Vector3d& v : mesh.vertices) low = low.cwiseMin(v);
  Numbering numbering(mesh.vertices.size());
  std::vector<std::int32_t> cells(mesh.vertices.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vector3d at = (mesh.vertices[i] - low) / cell;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      key = (key << 21) | static_cast<std::uint64_t>(std::clamp(at[k], 0.0, kMaxCells));
    }
    cells[i] = numbering.of(key);
  }
  count = numbering.count();
  return cells;
}

/// The planes in a cell, as the normal equations (least squares) of the point nearest to all of
/// them. Coordinates are relative to the mean point of the cell.
struct Planes {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;  ///< symmetric matrix
  Vector3d rightSide = Vector3d::Zero();                  ///< of the normal equations

  void add(const Vector3d& unit, double weight, double distance) {
    const Vector3d n = weight * unit;
    xx += n[0] * unit[0];
    yy += n[1] * unit[1];
    zz += n[2] * unit[2];
    xy += n[0] * unit[1];
    xz += n[0] * unit[2];
    yz += n[1] * unit[2];
    rightSide += distance * n;
  }
  /// Returns the point nearest to all planes, relative to the mean point.
  Vector3d nearestPoint() const {
    Eigen::Matrix3d m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    m.diagonal().array() += kMeanWeight * m.trace() + 1e-300;
    return m.inverse() * rightSide;
  }
};

/// Merges the vertices of each cell into one point, the point nearest to the planes of their
/// triangles.
TriMesh clustered(const TriMesh& mesh, double cell) {
  std::int32_t count = 0;
  const std::vector<std::int32_t> cells = cellsOf(mesh, cell, count);
  TriMesh out;
  out.vertices.assign(static_cast<std::size_t>(count), Vector3d::Zero());
  std::vector<std::int32_t> members(out.vertices.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    out.vertices[cells[i]] += mesh.vertices[i];
    ++members[cells[i]];
  }
  for (std::size_t c = 0; c < members.size(); ++c) out.vertices[c] /= members[c];
  std::vector<Planes> planes(out.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    const Vector3d normal = areaVector(mesh, t);
    const double weight = normal.norm();
    if (!(weight > 0)) continue;
    const Vector3d unit = normal / weight;
    const double level = unit.dot(mesh.vertices[t[0]]);
    for (const std::int32_t v : t) {
      const std::int32_t c = cells[v];
      planes[c].add(unit, weight, level - unit.dot(out.vertices[c]));
    }
    const Triangle kept = {cells[t[0]], cells[t[1]], cells[t[2]]};
    if (kept[0] != kept[1] && kept[1] != kept[2] && kept[2] != kept[0])
      out.triangles.push_back(kept);
  }
  for (std::size_t c = 0; c < planes.size(); ++c) {
    Vector3d step = planes[c].nearestPoint();
    if (step.norm() > cell) step *= cell / step.norm();
    if (step.allFinite()) out.vertices[c] += step;
  }
  return out;
}

TriMesh thinned(const TriMesh& mesh, std::size_t most) {
  const double wanted = static_cast<double>(most);
  double cell = std::sqrt(3 * areaOf(mesh) / wanted);  // about three triangles per cell in a plane
  if (!(cell > 0)) return mesh;
  TriMesh out;
  for (int round = 0; round < 4; ++round) {
    out = clustered(mesh, cell);
    const double ratio = static_cast<double>(out.triangles.size()) / wanted;
    if (ratio <= kMaxExcess) break;
    cell *= std::sqrt(ratio);
  }
  return out;
}

/// Returns the point for a corner of vertex v: an existing one with nearly this normal, or a new
/// one. `first`: the first point of the vertex.
std::int32_t pointFor(Drawable& out, std::size_t first, const Vector3d& at,
                      const Vector3d& normal) {
  const Eigen::Vector3f wanted = normal.cast<float>();
  for (std::size_t p = first; p < out.points.size(); ++p) {
    if (out.normals[p].dot(wanted) > kSameNormal) return static_cast<std::int32_t>(p);
  }
  out.points.push_back(at.cast<float>());
  out.normals.push_back(wanted);
  return static_cast<std::int32_t>(out.points.size() - 1);
}

}  // namespace

Drawable drawableOf(const TriMesh& given, std::size_t maxTriangles, double crease) {
  const bool tooMany = given.triangles.size() > maxTriangles;
  const TriMesh reduced = tooMany ? thinned(given, maxTriangles) : TriMesh{};
  const TriMesh& mesh = tooMany ? reduced : given;
  std::vector<Vector3d> normals(mesh.triangles.size()), units(mesh.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    normals[t] = areaVector(mesh, mesh.triangles[t]);
    units[t] = normals[t].normalized();
  }
  ListsByKey corners = halfEdgesByVertex(mesh);
  const double cosine = std::cos(crease), half = std::cos(crease / 2);
  Drawable out;
  out.points.reserve(mesh.vertices.size());
  out.normals.reserve(mesh.vertices.size());
  out.indices.assign(4 * mesh.triangles.size(), -1);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const std::span<const std::uint32_t> star = corners.of(v);
    const std::uint32_t *begin = star.data(), *end = star.data() + star.size();
    const std::size_t first = out.points.size();
    Vector3d all = Vector3d::Zero();
    for (const std::uint32_t* i = begin; i != end; ++i) all += normals[*i / 3];
    all.normalize();
    // If all normals are near the mean, they are near each other, and one point suffices.
    const bool smooth =
        std::all_of(begin, end, [&](std::uint32_t i) { return units[i / 3].dot(all) >= half; });
    for (const std::uint32_t* i = begin; i != end; ++i) {
      Vector3d normal = all;
      if (!smooth) {
        normal.setZero();
        for (const std::uint32_t* j = begin; j != end; ++j) {
          if (units[*j / 3].dot(units[*i / 3]) >= cosine) normal += normals[*j / 3];
        }
        if (!(normal.norm() > 0)) normal = Vector3d::UnitZ();
        normal.normalize();
      }
      const std::int32_t point = pointFor(out, first, mesh.vertices[v], normal);
      out.indices[4 * static_cast<std::size_t>(*i / 3) + *i % 3] = point;
    }
  }
  return out;
}

}  // namespace swept
