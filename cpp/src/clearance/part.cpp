// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/part.h"

#include <algorithm>

#include "base/limits.h"
#include "base/number_text.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_numbers.h"
#include "geometry/shells.h"
#include "input/body_weld.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

void requireUsable(const TriMesh& mesh, const std::string& who) {
  if (mesh.triangles.empty())
    throw Error(Status::InvalidInput, "EmptyMesh",
                who + " has no triangles; choose a part with a surface");
  const Coordinates numbers = measureCoordinates(mesh);
  if (numbers.nonFinite > 0)
    throw Error(Status::InvalidInput, "NonFiniteVertex",
                who + ": vertex " + std::to_string(numbers.firstNonFinite.front()) +
                    " (counted from 0) has a coordinate that is not a finite number; export the "
                    "part again");
  if (numbers.largest > kMaxLength)
    throw Error(Status::InvalidInput, "OutOfRange",
                who + ": vertex " + std::to_string(numbers.farthest) + " (counted from 0) lies " +
                    numberText(numbers.largest, kTellingDigits) +
                    " mm from the origin, but the limit is 1e9 mm; check the unit of length of "
                    "the part");
  if (const std::optional<BadIndex> bad = findBadIndex(mesh))
    throw Error(Status::InvalidInput, "BadIndex",
                who + ": " + badIndexText(*bad, mesh) + "; export the part again");
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

// Returns whether each edge is used equally often in both directions. Edges of length 0 do not
// count.
bool balanced(const TriMesh& welded) {
  bool any = false, even = true;
  EdgeTable(welded).forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                                    const std::uint64_t* last) {
    if (low == high) return;
    any = true;
    const auto ascending = std::count_if(first, last, EdgeTable::ascending);
    even = even && 2 * ascending == last - first;
  });
  return any && even;
}

std::vector<Vector3d> onePointAPiece(const TriMesh& welded) {
  const std::vector<std::int32_t> piece = smallestJoinedVertices(welded);
  std::vector<char> seen(welded.vertices.size(), 0);
  std::vector<Vector3d> points;
  for (const auto& t : welded.triangles) {
    char& flag = seen[piece[t[0]]];
    if (flag == 0) points.push_back(welded.vertices[t[0]]);
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
                who + " has " + std::to_string(count) +
                    " triangles, but the limit is 500 million; use a coarser mesh");
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
  plates_ = Plates(tree_, corners_);
  // Vertices at the same position are merged, so that triangle soups (STL) share edges.
  auto welded = std::make_unique<TriMesh>(mesh);
  applyMap(exactWeld(mesh.vertices), *welded);
  pieces_ = onePointAPiece(*welded);
  if (!balanced(*welded)) return;
  mesh_ = std::move(welded);
  rays_.emplace(*mesh_);
}

std::vector<Part::Piece> Part::cutSlivers(const TriMesh& mesh) {
  // A triangle is cut if its longest edge exceeds this multiple of its height.
  constexpr double kSlender = 6;
  const std::size_t count = mesh.triangles.size();
  std::vector<Piece> parts(count);
  std::vector<std::array<double, 2>> sizes(count);  // longest edge, height above it
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Triangle3d& c = parts[i].corners;
    for (int k = 0; k < 3; ++k) c[k] = mesh.vertices[mesh.triangles[i][k]];
    parts[i].triangle = static_cast<std::int64_t>(i);
    const double edge = std::sqrt(longestEdge(c).second);
    sizes[i] = {edge, edge > 0 ? (c[1] - c[0]).cross(c[2] - c[0]).norm() / edge : 0.0};
    sum += edge;
  }
  // Least length of the pieces into which slivers are cut. It is increased until there are at most
  // half as many new pieces as triangles.
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
      // The edge is too short to be halved.
      if (middle == second.corners[edge] || middle == second.corners[next]) continue;
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

Part::Depth Part::depth(const Vector3d& point, std::int32_t hint) const {
  const auto& [low, high] = tree_.bounds();
  const double outside = (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
  if (outside > 0) return {-outside};
  double within = std::numeric_limits<double>::infinity();
  if (hint >= 0) {
    const double d = footOnTriangle(point, corners_[static_cast<std::size_t>(hint)]).offset.norm();
    within = std::nextafter(d, within);  // so that the query finds the triangle `hint` again
  }
  const NearestOnPart near = nearest(point, within);
  return {inside(point) ? near.distance : -near.distance, near.place};
}

}  // namespace swept::clearance
