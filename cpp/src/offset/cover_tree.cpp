// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/cover_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace swept::offset {

using Eigen::Vector3d;

Vector3d nearestOnTriangle(const Vector3d& x, const CoverTriangle& triangle) {
  const Vector3d &a = triangle.corner[0], &b = triangle.corner[1], &c = triangle.corner[2];
  const Vector3d ab = b - a, ac = c - a, ax = x - a;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vector3d bx = x - b;
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 > d3 ? Vector3d(a + ab * (d1 / (d1 - d3))) : a;
  const Vector3d cx = x - c;
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 > d6 ? Vector3d(a + ac * (d2 / (d2 - d6))) : a;
  const double va = d3 * d6 - d5 * d4;
  const double e1 = d4 - d3, e2 = d5 - d6;
  if (va <= 0 && e1 >= 0 && e2 >= 0) {
    return e1 + e2 > 0 ? Vector3d(b + (c - b) * (e1 / (e1 + e2))) : b;
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return a;
  return a + ab * (vb / sum) + ac * (vc / sum);
}

namespace {

/// Nodes go along the largest spread of the middles of their triangles.
int widestAxis(const CoverTriangle* first, const CoverTriangle* last) {
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (const CoverTriangle* t = first; t != last; ++t) {
    const Vector3d sum = t->corner[0] + t->corner[1] + t->corner[2];
    low = low.cwiseMin(sum);
    high = high.cwiseMax(sum);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

}  // namespace

CoverTree::CoverTree(std::vector<CoverTriangle>& triangles) : triangles_(triangles) {
  if (triangles_.empty()) return;
  nodes_.resize(nodesFor(triangles_.size()));
  build(0, triangles_.size(), 0);
}

/// A node halves its triangles twice; both halvings depend on the count alone, so that places of
/// nodes are known before they are filled.
std::size_t CoverTree::nodesFor(std::size_t count) {
  if (count <= static_cast<std::size_t>(kWidth)) return 1;
  const std::size_t half = count / 2;
  std::size_t sum = 1;
  for (const std::size_t part :
       {half / 2, half - half / 2, (count - half) / 2, count - half - (count - half) / 2}) {
    if (part > 1) sum += nodesFor(part);
  }
  return sum;
}

void CoverTree::split(std::size_t first, std::size_t last, std::size_t middle) {
  CoverTriangle* begin = triangles_.data();
  const int axis = widestAxis(begin + first, begin + last);
  const auto key = [axis](const CoverTriangle& t) {
    return t.corner[0][axis] + t.corner[1][axis] + t.corner[2][axis];
  };
  std::nth_element(begin + first, begin + middle, begin + last,
                   [&](const CoverTriangle& a, const CoverTriangle& b) { return key(a) < key(b); });
}

std::int32_t CoverTree::build(std::size_t first, std::size_t last, std::int32_t node) {
  const std::size_t count = last - first;
  std::array<std::size_t, kWidth + 1> cut{first, first, first, first, last};
  if (count <= static_cast<std::size_t>(kWidth)) {
    for (int c = 0; c < kWidth; ++c) cut[c + 1] = std::min(first + c + 1, last);
  } else {
    cut[2] = first + count / 2;
    cut[1] = first + (cut[2] - first) / 2;
    cut[3] = cut[2] + (last - cut[2]) / 2;
    split(first, last, cut[2]);
    const auto lower = [&] { split(first, cut[2], cut[1]); };
    const auto upper = [&] { split(cut[2], last, cut[3]); };
    if (count > 8192) {
      tbb::parallel_invoke(lower, upper);
    } else {
      lower();
      upper();
    }
  }
  std::array<std::int32_t, kWidth> child;
  auto next = static_cast<std::size_t>(node) + 1;
  for (int c = 0; c < kWidth; ++c) {
    const std::size_t part = cut[c + 1] - cut[c];
    child[c] = part == 0   ? Node::kEmpty
               : part == 1 ? ~static_cast<std::int32_t>(cut[c])
                           : static_cast<std::int32_t>(next);
    if (part > 1) next += nodesFor(part);
  }
  const auto fill = [&](int c) {
    Node& n = nodes_[static_cast<std::size_t>(node)];
    n.child[c] = child[c];
    Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array3f high = -low;
    if (child[c] >= 0 && child[c] != Node::kEmpty) {
      build(cut[c], cut[c + 1], child[c]);
      const Node& m = nodes_[static_cast<std::size_t>(child[c])];
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = *std::min_element(m.low[axis], m.low[axis] + kWidth);
        high[axis] = *std::max_element(m.high[axis], m.high[axis] + kWidth);
      }
    } else if (child[c] < 0) {
      const CoverTriangle& t = triangles_[cut[c]];
      for (int axis = 0; axis < 3; ++axis) {
        const double a = t.corner[0][axis], b = t.corner[1][axis], d = t.corner[2][axis];
        const double room = t.slack + 1e-6 * (1 + std::abs(a) + std::abs(b) + std::abs(d));
        low[axis] = static_cast<float>(std::min({a, b, d}) - room);
        high[axis] = static_cast<float>(std::max({a, b, d}) + room);
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      n.low[axis][c] = low[axis];
      n.high[axis][c] = high[axis];
    }
  };
  if (count > 8192) {
    tbb::parallel_invoke([&] { fill(0); }, [&] { fill(1); }, [&] { fill(2); }, [&] { fill(3); });
  } else {
    for (int c = 0; c < kWidth; ++c) fill(c);
  }
  return node;
}

CoverTree::Nearest CoverTree::nearest(const Vector3d& x, double below, std::int32_t hint,
                                      double enough) const {
  Nearest best{below, -1};
  float limit = 0;  // squared, with room for the rounding of the box distances
  const auto setLimit = [&] {
    const double reach = std::max(best.reach, 0.0);
    limit = static_cast<float>(std::min(reach * reach * 1.00001 + 1e-9, 1e37));
  };
  const auto tryTriangle = [&](std::int32_t t) {
    const CoverTriangle& triangle = triangles_[static_cast<std::size_t>(t)];
    const double reach = (x - nearestOnTriangle(x, triangle)).norm() - triangle.slack;
    if (reach < best.reach) {
      best = {reach, t};
      setLimit();
    }
  };
  if (nodes_.empty()) return best;
  setLimit();
  if (hint >= 0) tryTriangle(hint);
  struct Item {
    std::int32_t child;
    float squared;
  };
  Item stack[128];
  int top = 0;
  stack[top++] = {0, 0};
  const Eigen::Vector3f p = x.cast<float>();
  while (top > 0) {
    const Item item = stack[--top];
    if (item.squared >= limit) continue;
    if (best.triangle >= 0 && best.reach <= enough) break;
    if (item.child < 0) {
      tryTriangle(~item.child);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(item.child)];
    float squared[kWidth] = {0, 0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      for (int c = 0; c < kWidth; ++c) {
        const float d =
            std::max(std::max(node.low[axis][c] - p[axis], p[axis] - node.high[axis][c]), 0.0f);
        squared[c] += d * d;
      }
    }
    // Pushed from far to near, so that the nearest is looked at first.
    int order[kWidth], count = 0;
    for (int c = 0; c < kWidth; ++c) {
      if (node.child[c] == Node::kEmpty || squared[c] >= limit) continue;
      int at = count++;
      for (; at > 0 && squared[order[at - 1]] < squared[c]; --at) order[at] = order[at - 1];
      order[at] = c;
    }
    for (int i = 0; i < count; ++i) stack[top++] = {node.child[order[i]], squared[order[i]]};
  }
  return best;
}

}  // namespace swept::offset
