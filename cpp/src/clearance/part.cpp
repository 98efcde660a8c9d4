// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/part.h"

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

std::pair<int, double> longestEdge(const Triangle3d& c) {
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

Part::Part(const TriMesh& mesh, const std::string& who) {
  requireUsable(mesh, who);
  const std::size_t count = mesh.triangles.size();
  if (count > 500'000'000)
    throw Error(Status::ResourceLimit, "TooManyTriangles",
                who + " has " + std::to_string(count) + " triangles, the limit is 500 million");
  const std::vector<Piece> parts = cutSlivers(mesh);
  tree_ = BoxTree(
      parts.size(),
      [&](std::size_t i) {
        BoxTree::Bounds box;
        for (const Vector3d& x : parts[i].corners) box.extend(x);
        return box;
      },
      BoxTree::Order::Medians);
  corners_.resize(parts.size());
  triangles_.resize(parts.size());
  for (std::size_t place = 0; place < parts.size(); ++place) {
    const Piece& piece = parts[static_cast<std::size_t>(tree_.item(place))];
    corners_[place] = piece.corners;
    triangles_[place] = piece.triangle;
  }
  const std::vector<std::int32_t> welded = weldedIndices(mesh);
  pieces_ = onePointAPiece(mesh, welded);
  if (!balanced(mesh, welded)) return;
  mesh_ = std::make_unique<TriMesh>(mesh);
  rays_.emplace(*mesh_);
}

std::vector<Part::Piece> Part::cutSlivers(const TriMesh& mesh) {
  constexpr double kSlender = 6;  // longest edge over height from which a triangle is cut
  const std::size_t count = mesh.triangles.size();
  std::vector<Piece> parts(count);
  std::vector<std::array<double, 2>> sizes(count);  // longest edge, height over it
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Triangle3d& c = parts[i].corners;
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

Box Part::box(BoxTree::Node node) const {
  if (node.level == tree_.root().level) {
    const auto& [low, high] = tree_.bounds();
    const Vector3d centre = 0.5 * (low + high);
    return {centre, (high - centre).cwiseMax(centre - low)};
  }
  const BoxTree::Group& group = tree_.groupOf(node);
  const std::uint32_t lane = node.index % BoxTree::kWidth;
  const Eigen::Array3d low(group.low[0][lane], group.low[1][lane], group.low[2][lane]);
  const Eigen::Array3d high(group.high[0][lane], group.high[1][lane], group.high[2][lane]);
  return {tree_.middle() + (0.5 * (low + high)).matrix(), (0.5 * (high - low)).matrix()};
}

NearestOnPart Part::nearest(const Vector3d& point, double within) const {
  NearestOnPart best;
  double squared = within * within;
  tree_.searchNear(point, within, [&](std::uint32_t place, double& reach) {
    const Foot foot = footOnTriangle(point, corners_[place]);
    const double d = foot.offset.squaredNorm();
    if (d >= squared) return true;
    squared = d;
    reach = std::sqrt(d);
    best.point = foot.point;
    best.place = static_cast<std::int32_t>(place);
    return d > 0;
  });
  best.distance = std::sqrt(squared);
  return best;
}

bool Part::inside(const Vector3d& point) const { return rays_ && rays_->winding(point) != 0; }

double Part::depth(const Vector3d& point) const {
  const auto& [low, high] = tree_.bounds();
  const double outside = (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
  if (outside > 0) return -outside;
  const double distance = nearest(point, std::numeric_limits<double>::infinity()).distance;
  return inside(point) ? distance : -distance;
}

}  // namespace swept::clearance
