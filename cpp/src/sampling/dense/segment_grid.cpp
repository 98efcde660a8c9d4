// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/segment_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept::dense {

template <class Use>
void SegmentGrid::forCubes(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                           const Use& use) const {
  std::int64_t from[3], to[3];
  for (int a = 0; a < 3; ++a) {
    from[a] = std::max<std::int64_t>(0, std::llround(std::floor((low[a] - low_[a]) / size_)));
    to[a] = std::min<std::int64_t>((1 << 20) - 1,
                                   std::llround(std::floor((high[a] - low_[a]) / size_)));
  }
  for (std::int64_t x = from[0]; x <= to[0]; ++x) {
    for (std::int64_t y = from[1]; y <= to[1]; ++y) {
      for (std::int64_t z = from[2]; z <= to[2]; ++z) {
        use(static_cast<std::uint64_t>(x) << 40 | static_cast<std::uint64_t>(y) << 20 |
            static_cast<std::uint64_t>(z));
      }
    }
  }
}

SegmentGrid::SegmentGrid(const TriMesh& body, double minSize) : body_(body) {
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  low_ = box.min();
  double area = 0;
  for (const auto& t : body.triangles) {
    const Eigen::Vector3d& a = body.vertices[t[0]];
    area += (body.vertices[t[1]] - a).cross(body.vertices[t[2]] - a).norm() / 2;
  }
  // Cubes as large as the mean triangle, but few enough where large triangles lie among small ones.
  size_ = std::max({minSize, std::sqrt(area / static_cast<double>(body.triangles.size())),
                    box.diagonal().norm() / 1e6});
  const auto cubes = [&] {
    double sum = 0;
    for (const auto& t : body.triangles) {
      Eigen::AlignedBox3d of;
      for (const std::int32_t v : t) of.extend(body.vertices[v]);
      sum += (of.sizes() / size_ + Eigen::Vector3d::Ones()).prod();
    }
    return sum;
  };
  while (cubes() > 8e6 + 4.0 * static_cast<double>(body.triangles.size())) size_ *= 1.5;
  for (std::uint32_t f = 0; f < body.triangles.size(); ++f) {
    Eigen::AlignedBox3d of;
    for (const std::int32_t v : body.triangles[f]) of.extend(body.vertices[v]);
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(1e-6 * size_);
    forCubes(of.min() - room, of.max() + room, [&](std::uint64_t cube) {
      entries_.push_back({cube, f});
    });
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& x, const Entry& y) {
    return x.cube != y.cube ? x.cube < y.cube : x.triangle < y.triangle;
  });
}

bool SegmentGrid::meets(std::uint32_t triangle, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& to) const {
  const auto& t = body_.triangles[triangle];
  const Eigen::Vector3d &a = body_.vertices[t[0]], &b = body_.vertices[t[1]],
                        &c = body_.vertices[t[2]];
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const double above = n.dot(from - a), below = n.dot(to - a);
  if ((above > 0) == (below > 0) || above == below) return false;
  const Eigen::Vector3d x = from + (to - from) * (above / (above - below));
  const double room = -1e-9 * n.squaredNorm();
  return n.dot((b - a).cross(x - a)) >= room && n.dot((c - b).cross(x - b)) >= room &&
         n.dot((a - c).cross(x - c)) >= room;
}

void SegmentGrid::hits(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                       std::vector<std::uint32_t>& out) const {
  out.clear();
  forCubes(from.cwiseMin(to), from.cwiseMax(to), [&](std::uint64_t cube) {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), cube,
                                  [](const Entry& e, std::uint64_t c) { return e.cube < c; });
    for (; entry != entries_.end() && entry->cube == cube; ++entry) {
      if (meets(entry->triangle, from, to)) out.push_back(entry->triangle);
    }
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

}  // namespace swept::dense
