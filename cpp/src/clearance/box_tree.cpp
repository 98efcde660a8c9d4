// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/box_tree.h"

#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

#include "base/limits.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

void requireUsable(const TriMesh& mesh, const std::string& who) {
  if (mesh.triangles.empty())
    throw Error(Status::InvalidInput, "EmptyMesh",
                who + " has no triangles; choose a part with a surface");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite())
      throw Error(Status::InvalidInput, "NonFiniteVertex",
                  who + ": vertex " + std::to_string(i) + " is not finite; export the part again");
    if (mesh.vertices[i].cwiseAbs().maxCoeff() > kLargestLength)
      throw Error(Status::InvalidInput, "OutOfRange",
                  who + ": vertex " + std::to_string(i) +
                      " lies more than 1e9 mm from the origin; check the unit of the part");
  }
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::int32_t v : mesh.triangles[i]) {
      if (v < 0 || v >= count)
        throw Error(Status::InvalidInput, "BadIndex",
                    who + ": triangle " + std::to_string(i) + " names vertex " + std::to_string(v) +
                        " of " + std::to_string(count) + "; export the part again");
    }
  }
}

// Vertices at the same place get one number, so that triangle soups (STL) have edges in common.
std::vector<std::int32_t> weldedIndices(const TriMesh& mesh) {
  const auto& v = mesh.vertices;
  std::vector<std::int32_t> order(v.size());
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](std::int32_t a, std::int32_t b) {
    for (int k = 0; k < 3; ++k)
      if (v[a][k] != v[b][k]) return v[a][k] < v[b][k];
    return a < b;
  };
  tbb::parallel_sort(order.begin(), order.end(), less);
  std::vector<std::int32_t> welded(v.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && v[order[i]] == v[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

std::pair<int, double> longestEdge(const Corners& c) {
  int longest = 0;
  double best = -1;
  for (int k = 0; k < 3; ++k) {
    const double squared = (c[(k + 1) % 3] - c[k]).squaredNorm();
    if (squared > best) {
      best = squared;
      longest = k;
    }
  }
  return {longest, best};
}

struct DirectedEdge {
  std::int32_t low, high, sign;
};

bool balanced(const TriMesh& mesh, const std::vector<std::int32_t>& welded) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = welded[t[k]];
      const std::int32_t b = welded[t[(k + 1) % 3]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  tbb::parallel_sort(edges.begin(), edges.end(), [](const DirectedEdge& x, const DirectedEdge& y) {
    return x.low != y.low ? x.low < y.low : x.high < y.high;
  });
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    std::size_t j = i;
    for (; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high; ++j)
      sum += edges[j].sign;
    if (sum != 0) return false;
    i = j;
  }
  return !edges.empty();
}

std::vector<Vector3d> onePointAPiece(const TriMesh& mesh, const std::vector<std::int32_t>& welded) {
  std::vector<std::int32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    const std::int32_t a = root(welded[t[0]]);
    for (int k = 1; k < 3; ++k) {
      const std::int32_t b = root(welded[t[k]]);
      if (a != b) parent[std::max(root(a), b)] = std::min(root(a), b);
    }
  }
  std::vector<char> seen(mesh.vertices.size(), 0);
  std::vector<Vector3d> points;
  for (const auto& t : mesh.triangles) {
    char& flag = seen[root(welded[t[0]])];
    if (flag == 0) points.push_back(mesh.vertices[t[0]]);
    flag = 1;
  }
  return points;
}

}  // namespace

BoxTree::BoxTree(const TriMesh& mesh, const std::string& who) {
  requireUsable(mesh, who);
  const std::size_t count = mesh.triangles.size();
  if (count > 500'000'000)
    throw Error(Status::ResourceLimit, "TooManyTriangles",
                who + " has " + std::to_string(count) + " triangles, the limit is 500 million");
  const std::vector<Piece> parts = cutSlivers(mesh);
  std::vector<std::int32_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.resize(2 * parts.size() - 1);
  corners_.resize(parts.size());
  triangles_.resize(parts.size());
  build(0, order.data(), order.data() + parts.size(), parts, 0);
  const std::vector<std::int32_t> welded = weldedIndices(mesh);
  closed_ = balanced(mesh, welded);
  pieces_ = onePointAPiece(mesh, welded);
}

std::vector<BoxTree::Piece> BoxTree::cutSlivers(const TriMesh& mesh) {
  constexpr double kSlender = 6;  // longest edge over height from which a triangle is cut
  const std::size_t count = mesh.triangles.size();
  std::vector<Piece> parts(count);
  std::vector<std::array<double, 2>> sizes(count);  // longest edge, height over it
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Corners& c = parts[i].corners;
    for (int k = 0; k < 3; ++k) c[k] = mesh.vertices[mesh.triangles[i][k]];
    parts[i].triangle = static_cast<std::int64_t>(i);
    const double edge = std::sqrt(longestEdge(c).second);
    sizes[i] = {edge, edge > 0 ? (c[1] - c[0]).cross(c[2] - c[0]).norm() / edge : 0.0};
    sum += edge;
  }
  // The length to which slivers are cut grows until the pieces are no more than the triangles.
  double least = sum / static_cast<double>(count) / 16;
  const auto lengthFor = [&](std::size_t i) { return std::max(3 * sizes[i][1], least); };
  const auto extra = [&] {
    double pieces = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (sizes[i][0] > kSlender * sizes[i][1]) pieces += sizes[i][0] / lengthFor(i);
    return pieces;
  };
  while (least > 0 && extra() > 0.5 * static_cast<double>(count)) least *= 1.5;
  for (std::size_t i = 0; i < count && least > 0; ++i) {
    if (sizes[i][0] <= kSlender * sizes[i][1]) continue;
    const double limit = lengthFor(i) * lengthFor(i);
    std::vector<std::size_t> todo{i};
    while (!todo.empty()) {
      const std::size_t at = todo.back();
      const auto [edge, squared] = longestEdge(parts[at].corners);
      todo.pop_back();
      if (squared <= limit) continue;
      Piece second = parts[at];
      const int next = (edge + 1) % 3;
      const Vector3d middle = 0.5 * (second.corners[edge] + second.corners[next]);
      if (middle == second.corners[edge] || middle == second.corners[next]) continue;  // rounded
      second.corners[edge] = middle;
      parts[at].corners[next] = middle;
      todo.push_back(at);
      todo.push_back(parts.size());
      parts.push_back(second);
    }
  }
  return parts;
}

void BoxTree::build(std::int32_t node, std::int32_t* first, std::int32_t* last,
                    const std::vector<Piece>& parts, std::int32_t leafOffset) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  Vector3d centreLow = low;
  Vector3d centreHigh = high;
  for (const std::int32_t* i = first; i != last; ++i) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& x : parts[*i].corners) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      sum += x;
    }
    centreLow = centreLow.cwiseMin(sum);
    centreHigh = centreHigh.cwiseMax(sum);
  }
  BoxNode& box = nodes_[node];
  box.centre = 0.5 * (low + high);
  // Rounding of the centre must not leave a corner outside.
  box.half = (high - box.centre).cwiseMax(box.centre - low);
  const auto count = static_cast<std::int32_t>(last - first);
  if (count == 1) {
    box.leaf = leafOffset;
    triangles_[leafOffset] = parts[*first].triangle;
    corners_[leafOffset] = parts[*first].corners;
    return;
  }
  int axis = 0;
  (centreHigh - centreLow).maxCoeff(&axis);
  const auto key = [&](std::int32_t i) {
    const Corners& c = parts[i].corners;
    return c[0][axis] + c[1][axis] + c[2][axis];
  };
  std::int32_t* middle = first + count / 2;
  std::nth_element(first, middle, last, [&](std::int32_t a, std::int32_t b) {
    const double x = key(a);
    const double y = key(b);
    return x != y ? x < y : a < b;
  });
  const std::int32_t onLeft = count / 2;
  box.right = node + 2 * onLeft;
  const auto left = [&] { build(node + 1, first, middle, parts, leafOffset); };
  const auto right = [&] { build(node + 2 * onLeft, middle, last, parts, leafOffset + onLeft); };
  if (count > 4096) {
    tbb::parallel_invoke(left, right);
  } else {
    left();
    right();
  }
}

NearestOnMesh BoxTree::nearest(const Vector3d& point, double within) const {
  NearestOnMesh best;
  double bestSquared = within * within;
  struct Item {
    std::int32_t node;
    double squared;
  };
  Item stack[96];
  int top = 0;
  const auto toBox = [&](std::int32_t node) {
    const BoxNode& b = nodes_[node];
    return ((point - b.centre).cwiseAbs() - b.half).cwiseMax(0.0).squaredNorm();
  };
  stack[top++] = {0, toBox(0)};
  while (top > 0) {
    const Item item = stack[--top];
    if (item.squared >= bestSquared) continue;
    const BoxNode& box = nodes_[item.node];
    if (box.leaf >= 0) {
      const Vector3d x = nearestOnTriangle(point, corners_[box.leaf]);
      const double squared = (x - point).squaredNorm();
      if (squared < bestSquared) {
        bestSquared = squared;
        best.point = x;
        best.leaf = box.leaf;
      }
      continue;
    }
    const Item left{item.node + 1, toBox(item.node + 1)};
    const Item right{box.right, toBox(box.right)};
    const bool leftFirst = left.squared <= right.squared;
    stack[top++] = leftFirst ? right : left;
    stack[top++] = leftFirst ? left : right;
  }
  best.distance = std::sqrt(bestSquared);
  return best;
}

int BoxTree::windingAlong(const Vector3d& point, const Vector3d& direction) const {
  const Vector3d inverse = direction.cwiseInverse();
  std::int32_t stack[96];
  int top = 0;
  stack[top++] = 0;
  int winding = 0;
  while (top > 0) {
    const std::int32_t node = stack[--top];
    const BoxNode& box = nodes_[node];
    const Vector3d mid = (box.centre - point).cwiseProduct(inverse);
    const Vector3d reach = box.half.cwiseProduct(inverse.cwiseAbs());
    const double slack = 1e-12 * (mid.cwiseAbs().maxCoeff() + reach.maxCoeff());
    const double enter = std::max((mid - reach).maxCoeff(), 0.0);
    if ((mid + reach).minCoeff() < enter - slack) continue;
    if (box.leaf < 0) {
      stack[top++] = box.right;
      stack[top++] = node + 1;
      continue;
    }
    const Corners& c = corners_[box.leaf];
    const Vector3d a = c[0] - point;
    const Vector3d b = c[1] - point;
    const Vector3d d = c[2] - point;
    const double u = direction.dot(a.cross(b));
    const double v = direction.dot(b.cross(d));
    const double w = direction.dot(d.cross(a));
    // A ray through a shared edge takes zero as positive on both sides of the sum, so it may be
    // counted twice or not at all: that is what the other two rays are for.
    const bool positive = u >= 0 && v >= 0 && w >= 0 && u + v + w > 0;
    const bool negative = u < 0 && v < 0 && w < 0;
    if (!positive && !negative) continue;
    const double volume = a.dot(b.cross(d));  // same sign as the side if the crossing lies ahead
    if (positive && volume > 0) ++winding;
    if (negative && volume < 0) --winding;
  }
  return winding;
}

bool BoxTree::inside(const Vector3d& point) const {
  if (!closed_) return false;
  const BoxNode& box = nodes_[0];
  if (((point - box.centre).cwiseAbs() - box.half).maxCoeff() > 0) return false;
  static const std::array<Vector3d, 3> kDirections{Vector3d(0.36127, 0.51893, 0.77475),
                                                   Vector3d(-0.81349, 0.27611, 0.51187),
                                                   Vector3d(0.21731, -0.91117, 0.35019)};
  const bool first = windingAlong(point, kDirections[0]) != 0;
  const bool second = windingAlong(point, kDirections[1]) != 0;
  if (first == second) return first;
  return windingAlong(point, kDirections[2]) != 0;
}

double BoxTree::depth(const Vector3d& point) const {
  const BoxNode& box = nodes_[0];
  const double outside = ((point - box.centre).cwiseAbs() - box.half).cwiseMax(0.0).norm();
  if (outside > 0) return -outside;
  const double distance = nearest(point, std::numeric_limits<double>::infinity()).distance;
  return inside(point) ? distance : -distance;
}

}  // namespace swept::clearance
