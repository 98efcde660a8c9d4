// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplified_sources.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/mesh_parts.h"

namespace swept {
namespace {

using Eigen::Vector3d;

/// A triangle is divided into at most this many rows of equal triangles, and sampled at their
/// centroids.
constexpr int kMaxRows = 4;

bool sameSource(const SurfaceSource& a, const SurfaceSource& b) {
  return a.kind == b.kind && a.step == b.step && a.faces == b.faces;
}

/// Counts the rows found on one triangle, grouped by source.
class Votes {
 public:
  explicit Votes(const std::vector<SurfaceSource>& rows) : rows_(rows) {}

  void add(std::uint32_t row, double fromMiddle) {
    for (std::size_t n = 0; n < count_; ++n) {
      Group& group = groups_[n];
      if (!sameSource(rows_[group.row], rows_[row])) continue;
      ++group.points;
      if (fromMiddle < group.fromMiddle) group.row = row, group.fromMiddle = fromMiddle;
      return;
    }
    groups_[count_++] = {row, 1, fromMiddle};
  }
  /// Of the rows in the largest group, returns the one whose sample point is nearest to the middle
  /// of the triangle. Returns kNone if there are no rows.
  std::uint32_t winner() const {
    if (count_ == 0) return Sources::kNone;
    return std::max_element(groups_.begin(), groups_.begin() + static_cast<std::ptrdiff_t>(count_),
                            [](const Group& a, const Group& b) { return a.points < b.points; })
        ->row;
  }

 private:
  struct Group {
    std::uint32_t row = 0;
    int points = 0;
    double fromMiddle = 0;
  };
  const std::vector<SurfaceSource>& rows_;
  std::array<Group, static_cast<std::size_t>(kMaxRows) * kMaxRows> groups_;
  std::size_t count_ = 0;
};

}  // namespace

Sources sourcesOfSimplified(const TriMesh& surface, const NearestTriangle& nearest,
                            const Sources& sources, const TriMesh& mesh, double spacing) {
  Sources out{std::vector<std::uint32_t>(mesh.triangles.size()), sources.rows};
  constexpr std::size_t kBlock = 64;
  parallelBlocks(out.of.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t hint = -1;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& tri = mesh.triangles[t];
      const Vector3d &a = mesh.vertices[tri[0]], ab = mesh.vertices[tri[1]] - a,
                     ac = mesh.vertices[tri[2]] - a, normal = areaVector(mesh, tri),
                     middle = a + (ab + ac) / 3;
      const int n = static_cast<int>(
          std::clamp(std::ceil(std::sqrt(normal.norm()) / spacing), 1.0, double{kMaxRows}));
      Votes votes(*sources.rows);
      const auto sample = [&](double u, double v) {
        const Vector3d p = a + u / (3 * n) * ab + v / (3 * n) * ac;
        nearest.query(p, HUGE_VAL, 0, hint);
        const std::uint32_t row = sources.of[hint];
        if (row == Sources::kNone || areaVector(surface, surface.triangles[hint]).dot(normal) <= 0)
          return;
        votes.add(row, (p - middle).squaredNorm());
      };
      for (int i = 0; i < n; ++i) {
        for (int k = 0; i + k < n; ++k) {
          sample(3 * i + 1, 3 * k + 1);
          if (i + k + 1 < n) sample(3 * i + 2, 3 * k + 2);
        }
      }
      out.of[t] = votes.winner();
    }
  });
  return out;
}

}  // namespace swept
