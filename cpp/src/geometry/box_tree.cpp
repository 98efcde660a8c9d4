// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/box_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace swept {
namespace {

constexpr std::size_t kGrain = 1 << 13;
constexpr std::uint32_t kHilbertBits = 10;  // an axis
using Range = tbb::blocked_range<std::size_t>;

/// Position along a Hilbert curve through a cube of 2^10 cells a side (Skilling 2004: the
/// transpose of the index is found by undoing the rotations bit by bit, then Gray coded).
std::uint32_t hilbertKey(std::array<std::uint32_t, 3> x) {
  for (std::uint32_t q = 1u << (kHilbertBits - 1); q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (int i = 0; i < 3; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1u << (kHilbertBits - 1); q > 1; q >>= 1) {
    if ((x[2] & q) != 0) t ^= q - 1;
  }
  std::uint32_t key = 0;
  for (int bit = static_cast<int>(kHilbertBits) - 1; bit >= 0; --bit) {
    for (int i = 0; i < 3; ++i) key = (key << 1) | (((x[i] ^ t) >> bit) & 1u);
  }
  return key;
}

struct Frame {
  Eigen::Vector3d middle;
  double scale;  ///< grid cells a mm
};

Frame frameOf(const TriMesh& mesh) {
  using Box = std::pair<Eigen::Vector3d, Eigen::Vector3d>;
  const auto [low, high] = tbb::parallel_reduce(
      Range(0, mesh.vertices.size(), kGrain), Box{mesh.vertices[0], mesh.vertices[0]},
      [&](const Range& range, Box box) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
          box.first = box.first.cwiseMin(mesh.vertices[v]);
          box.second = box.second.cwiseMax(mesh.vertices[v]);
        }
        return box;
      },
      [](const Box& a, const Box& b) {
        return Box{a.first.cwiseMin(b.first), a.second.cwiseMax(b.second)};
      });
  const double extent = (high - low).maxCoeff();
  return {(low + high) / 2, extent > 0 ? ((1u << kHilbertBits) - 1) / extent : 0};
}

double extentOf(const TriMesh& mesh, std::size_t t) {
  const auto& tri = mesh.triangles[t];
  const auto &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
  return (a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c)).maxCoeff();
}

/// Middle of the extents of about a thousand triangles spread over the mesh.
double typicalExtent(const TriMesh& mesh) {
  const std::size_t step = mesh.triangles.size() / 1024 + 1;
  std::vector<double> sample;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    sample.push_back(extentOf(mesh, t));
  }
  std::nth_element(sample.begin(), sample.begin() + sample.size() / 2, sample.end());
  return sample[sample.size() / 2];
}

/// Key in the upper half, triangle in the lower.
RawArray<std::uint64_t> makeKeys(const TriMesh& mesh, const Frame& frame) {
  const double typical = typicalExtent(mesh);
  const double half = (1u << kHilbertBits) / 2.0;
  RawArray<std::uint64_t> keys(mesh.triangles.size());
  tbb::parallel_for(Range(0, keys.size(), kGrain), [&](const Range& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      const auto& tri = mesh.triangles[t];
      const Eigen::Vector3d centre =
          ((mesh.vertices[tri[0]] - frame.middle) + (mesh.vertices[tri[1]] - frame.middle) +
           (mesh.vertices[tri[2]] - frame.middle)) *
          (frame.scale / 3);
      std::array<std::uint32_t, 3> cell{};
      for (int i = 0; i < 3; ++i) {
        cell[i] = static_cast<std::uint32_t>(std::clamp(centre[i] + half, 0.0, 2 * half - 1));
      }
      const double extent = extentOf(mesh, t);
      const std::uint64_t sizeClass =
          extent <= 4 * typical ? 0
                                : (extent <= 16 * typical ? 1 : (extent <= 64 * typical ? 2 : 3));
      keys[t] = ((sizeClass << 30 | hilbertKey(cell)) << 32) | t;
    }
  });
  return keys;
}

/// Stable sort by the upper 32 bits: three passes of 11 bits over blocks of fixed size.
void sortByKey(RawArray<std::uint64_t>& keys) {
  constexpr std::size_t kDigits = 1 << 11;
  const std::size_t block = std::max<std::size_t>(1 << 15, keys.size() / 32 + 1);
  const std::size_t blocks = (keys.size() + block - 1) / block;
  RawArray<std::uint64_t> other(keys.size());
  std::vector<std::uint32_t> counts(blocks * kDigits);
  for (int shift = 32; shift < 64; shift += 11) {
    auto digit = [shift](std::uint64_t key) { return (key >> shift) & (kDigits - 1); };
    std::fill(counts.begin(), counts.end(), 0);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
      const std::size_t end = std::min(keys.size(), (b + 1) * block);
      for (std::size_t i = b * block; i < end; ++i) ++counts[b * kDigits + digit(keys[i])];
    });
    std::uint32_t sum = 0;
    for (std::size_t d = 0; d < kDigits; ++d) {
      for (std::size_t b = 0; b < blocks; ++b) {
        const std::uint32_t count = counts[b * kDigits + d];
        counts[b * kDigits + d] = sum;
        sum += count;
      }
    }
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
      const std::size_t end = std::min(keys.size(), (b + 1) * block);
      for (std::size_t i = b * block; i < end; ++i) {
        other[counts[b * kDigits + digit(keys[i])]++] = keys[i];
      }
    });
    std::swap(keys, other);
  }
}

/// Nearest float and some units more, so that neither rounding of the difference nor of the
/// conversion can move the box inward.
float roundedDown(double value) {
  const auto f = static_cast<float>(value);
  return f - std::abs(f) * 3e-7f - std::numeric_limits<float>::min();
}
float roundedUp(double value) { return -roundedDown(-value); }

void fillLeaf(const TriMesh& mesh, const Frame& frame, const RawArray<std::uint64_t>& keys,
              std::size_t index, TriangleLeaf& leaf, FloatBox& box) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  box.low.fill(kInfinity);
  box.high.fill(-kInfinity);
  for (std::size_t j = 0; j < kLeafSize; ++j) {
    const std::size_t place = index * kLeafSize + j;
    const bool filled = place < keys.size();
    const auto t = filled ? static_cast<std::int32_t>(keys[place] & 0xffffffffu) : -1;
    leaf.triangle[j] = t;
    for (int axis = 0; axis < 3; ++axis) {
      leaf.low[axis][j] = kInfinity;
      leaf.high[axis][j] = -kInfinity;
      leaf.vertex[axis][j] = -1;
    }
    if (!filled) continue;
    const auto& tri = mesh.triangles[t];
    const Eigen::Vector3d a = mesh.vertices[tri[0]] - frame.middle;
    const Eigen::Vector3d b = mesh.vertices[tri[1]] - frame.middle;
    const Eigen::Vector3d c = mesh.vertices[tri[2]] - frame.middle;
    for (int axis = 0; axis < 3; ++axis) {
      leaf.vertex[axis][j] = tri[axis];
      leaf.low[axis][j] = roundedDown(std::min({a[axis], b[axis], c[axis]}));
      leaf.high[axis][j] = roundedUp(std::max({a[axis], b[axis], c[axis]}));
      box.low[axis] = std::min(box.low[axis], leaf.low[axis][j]);
      box.high[axis] = std::max(box.high[axis], leaf.high[axis][j]);
    }
  }
}

}  // namespace

BoxTree buildBoxTree(const TriMesh& mesh) {
  BoxTree tree;
  if (mesh.triangles.empty()) return tree;
  const Frame frame = frameOf(mesh);
  RawArray<std::uint64_t> keys = makeKeys(mesh, frame);
  sortByKey(keys);
  const std::size_t count = (keys.size() + kLeafSize - 1) / kLeafSize;
  tree.leaves = RawArray<TriangleLeaf>(count);
  tree.levels.emplace_back(count);
  tbb::parallel_for(Range(0, count, kGrain / kLeafSize), [&](const Range& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      fillLeaf(mesh, frame, keys, i, tree.leaves[i], tree.levels[0][i]);
    }
  });
  while (tree.levels.back().size() > 1) {
    const auto& below = tree.levels.back();
    std::vector<FloatBox> level((below.size() + 3) / 4);
    for (std::size_t i = 0; i < level.size(); ++i) {
      level[i] = below[4 * i];
      for (std::size_t c = 4 * i + 1; c < std::min(below.size(), 4 * i + 4); ++c) {
        for (int axis = 0; axis < 3; ++axis) {
          level[i].low[axis] = std::min(level[i].low[axis], below[c].low[axis]);
          level[i].high[axis] = std::max(level[i].high[axis], below[c].high[axis]);
        }
      }
    }
    tree.levels.push_back(std::move(level));
  }
  return tree;
}

}  // namespace swept
