// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/thin.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kRounds = 6;
constexpr double kFirstFraction = 0.1;  // of the tolerance, in the first round
constexpr double kMeanFraction = 0.35;  // of the tolerance: root mean square distance of the planes
constexpr double kMinCosine = 0.5;      // a triangle may turn by less than 60 degrees
// Surfaces are found by growing over triangles: these stay many and well shaped.
constexpr double kMinShape = 0.15;  // area vector / longest side squared
constexpr double kLongest = 8;      // of the mean edge before: no edge becomes longer
constexpr int kMaxNeighbours = 40;
// Worked on at the same time; fixed, so that the result does not depend on the number of threads.
constexpr std::size_t kParts = 16;

// Squared distances to planes, summed; about an origin of its own to keep the digits.
struct Quadric {
  Eigen::Matrix<double, 6, 1> a = Eigen::Matrix<double, 6, 1>::Zero();  // xx xy xz yy yz zz
  Vector3d b = Vector3d::Zero();
  double c = 0, weight = 0;

  void addPlane(const Vector3d& n, double d, double w) {
    a[0] += w * n.x() * n.x();
    a[1] += w * n.x() * n.y();
    a[2] += w * n.x() * n.z();
    a[3] += w * n.y() * n.y();
    a[4] += w * n.y() * n.z();
    a[5] += w * n.z() * n.z();
    b += w * d * n;
    c += w * d * d;
    weight += w;
  }
  void add(const Quadric& o) {
    a += o.a;
    b += o.b;
    c += o.c;
    weight += o.weight;
  }
  double meanAt(const Vector3d& p) const {
    const double x = p.x(), y = p.y(), z = p.z();
    const double sum = a[0] * x * x + a[3] * y * y + a[5] * z * z +
                       2 * (a[1] * x * y + a[2] * x * z + a[4] * y * z) + 2 * b.dot(p) + c;
    return weight > 0 ? std::max(0.0, sum / weight) : 0.0;
  }
};

class Thinner {
 public:
  Thinner(const HalfEdgeMesh& mesh, double tolerance, RunContext& run)
      : tolerance_(tolerance), run_(run), opposite_(mesh.opposite) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : mesh.points) middle += p / static_cast<double>(mesh.points.size());
    origin_ = middle;
    points_.reserve(mesh.points.size());
    for (const Vector3d& p : mesh.points) points_.push_back(p - middle);
    vertex_.resize(mesh.opposite.size());
    quadric_.resize(mesh.points.size());
    fan_.assign(mesh.points.size(), -1);
    off_.assign(mesh.points.size(), 0);
    double sum = 0;
    for (std::size_t h = 0; h < opposite_.size(); ++h) {
      const auto half = static_cast<std::int32_t>(h);
      sum += (mesh.points[mesh.origin(half)] - mesh.points[mesh.target(half)]).norm();
    }
    const double longest = kLongest * sum / static_cast<double>(opposite_.size());
    longest_ = longest * longest;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vector3d area = mesh.areaVector(static_cast<std::int32_t>(t));
      const double twice = area.norm();
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = mesh.triangles[t][k];
        const auto h = static_cast<std::int32_t>(3 * t + k);
        vertex_[h] = v;
        fan_[v] = h;
        if (twice > 0) quadric_[v].addPlane(area / twice, -area.dot(points_[v]) / twice, twice);
      }
    }
  }

  HalfEdgeMesh work() {
    partOf_.resize(points_.size());
    for (std::size_t part = 0; part < kParts; ++part)
      std::fill(partOf_.begin() + firstOf(part), partOf_.begin() + firstOf(part + 1),
                static_cast<char>(part));
    for (int round = 0; round < kRounds; ++round) {
      const double share = kFirstFraction * std::pow(1 / kFirstFraction, round / (kRounds - 1.0));
      const double limit = share * tolerance_;
      findInner();
      parallelFor(kParts,
                  [&](std::size_t part) { pass(firstOf(part), firstOf(part + 1), limit, true); });
      pass(0, static_cast<std::int32_t>(points_.size()), limit, false);
    }
    TriMesh small;
    std::vector<std::int32_t> id(points_.size(), -1);
    for (std::size_t t = 0; t < vertex_.size() / 3; ++t) {
      if (vertex_[3 * t] < 0) continue;
      std::array<std::int32_t, 3> corners{};
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = vertex_[3 * t + k];
        if (id[v] < 0) {
          id[v] = static_cast<std::int32_t>(small.vertices.size());
          small.vertices.push_back(origin_ + points_[v]);
        }
        corners[k] = id[v];
      }
      small.triangles.push_back(corners);
    }
    return buildHalfEdges(small, run_);
  }

 private:
  // Parts of the mesh by the numbers of its vertices, which lie in layers.
  std::int32_t firstOf(std::size_t part) const {
    return static_cast<std::int32_t>(part * points_.size() / kParts);
  }
  void findInner() {
    inner_.assign(points_.size(), 1);
    for (std::size_t h = 0; h < vertex_.size(); ++h) {
      const std::int32_t v = vertex_[h];
      if (v < 0) continue;
      const std::int32_t w = target(static_cast<std::int32_t>(h));
      if (partOf_[v] != partOf_[w]) inner_[v] = inner_[w] = 0;
    }
  }
  // Vertices whose neighbours all lie in their own part stay so while only such are worked on: what
  // happens at those of another part does not touch the triangles about them.
  void pass(std::int32_t begin, std::int32_t end, double limit, bool inner) {
    for (std::int32_t v = begin; v < end; ++v) {
      if ((v & 8191) == 0) run_.checkpoint(Phase::Export);
      if (fan_[v] >= 0 && (inner_[v] != 0) == inner) removeIfClose(v, limit);
    }
  }

  static std::int32_t next(std::int32_t h) { return HalfEdgeMesh::next(h); }
  static std::int32_t previous(std::int32_t h) { return HalfEdgeMesh::previous(h); }
  // The next half-edge out of the same vertex.
  std::int32_t turn(std::int32_t h) const { return opposite_[previous(h)]; }
  std::int32_t target(std::int32_t h) const { return vertex_[next(h)]; }

  // The cheapest neighbour within the limit takes the vertex in.
  void removeIfClose(std::int32_t u, double limit) {
    double best = kMeanFraction * kMeanFraction * limit * limit;
    std::int32_t chosen = -1;
    int neighbours = 0;
    std::int32_t h = fan_[u];
    do {
      const std::int32_t v = target(h);
      const double mean = quadric_[u].meanAt(points_[v]);
      if (mean < best) {
        best = mean;
        chosen = h;
      }
      if (++neighbours > kMaxNeighbours) return;
      h = turn(h);
    } while (h != fan_[u]);
    if (chosen >= 0 && mayCollapse(chosen, limit)) collapse(chosen);
  }

  int valence(std::int32_t v) const {
    int count = 0;
    std::int32_t h = fan_[v];
    do {
      ++count;
      h = turn(h);
    } while (h != fan_[v]);
    return count;
  }

  bool mayCollapse(std::int32_t edge, double limit) {
    const std::int32_t v = target(edge);
    // Just the two corners beside the edge are neighbours of both ends, and keep three neighbours.
    std::array<std::int32_t, kMaxNeighbours> ring;
    std::int32_t h = fan_[v];
    auto end = ring.begin();
    do {
      if (end == ring.end()) return false;
      *end++ = target(h);
      h = turn(h);
    } while (h != fan_[v]);
    std::ptrdiff_t common = 0;
    h = edge;
    do {
      common += std::count(ring.begin(), end, target(h));
      h = turn(h);
    } while (h != edge);
    if (common != 2) return false;
    if (valence(vertex_[previous(edge)]) <= 3) return false;
    if (valence(vertex_[previous(opposite_[edge])]) <= 3) return false;
    return trianglesHold(edge, limit);
  }

  bool trianglesHold(std::int32_t edge, double limit) {
    const std::int32_t u = vertex_[edge];
    const Vector3d &from = points_[u], &to = points_[target(edge)];
    double nearest = 1e300;
    for (std::int32_t h = turn(edge); h != edge; h = turn(h)) {
      const Vector3d &b = points_[target(h)], &c = points_[vertex_[previous(h)]];
      if (vertex_[previous(h)] == target(edge)) continue;
      const Vector3d before = (b - from).cross(c - from), after = (b - to).cross(c - to);
      const double area = after.norm();
      const double longest =
          std::max({(b - to).squaredNorm(), (c - to).squaredNorm(), (b - c).squaredNorm()});
      if (before.dot(after) < kMinCosine * before.norm() * area) return false;
      if (longest > longest_ || area < kMinShape * longest) return false;
      nearest = std::min(nearest, squaredDistance(from, to, b, c));
    }
    // What this vertex has taken in before may lie as much farther off.
    const double off = off_[u] + std::sqrt(nearest);
    if (!(off <= limit)) return false;
    double& taken = off_[target(edge)];
    taken = std::max(taken, off);
    return true;
  }

  void collapse(std::int32_t edge) {
    const std::int32_t u = vertex_[edge], v = target(edge), back = opposite_[edge];
    quadric_[v].add(quadric_[u]);
    std::int32_t h = edge;
    do {
      const std::int32_t following = turn(h);
      vertex_[h] = v;
      h = following;
    } while (h != edge);
    for (const std::int32_t side : {edge, back}) {
      const std::int32_t a = opposite_[next(side)], b = opposite_[previous(side)];
      opposite_[a] = b;
      opposite_[b] = a;
      // Half-edges that survive stand in for those of the two triangles that go.
      fan_[vertex_[a]] = a;
      fan_[vertex_[b]] = b;
    }
    for (const std::int32_t side : {edge, back}) {
      for (int k = 0; k < 3; ++k) vertex_[side / 3 * 3 + k] = -1;
    }
    fan_[u] = -1;
  }

  double tolerance_;
  RunContext& run_;
  Vector3d origin_;
  std::vector<Vector3d> points_;
  std::vector<std::int32_t> vertex_;  // per half-edge: where it starts; -1: gone
  std::vector<std::int32_t> opposite_;
  std::vector<std::int32_t> fan_;  // per vertex: a half-edge that starts there; -1: gone
  std::vector<Quadric> quadric_;
  std::vector<double> off_;  // per vertex: how far what it took in may lie from the triangles
  double longest_ = 0;       // mm^2
  std::vector<char> partOf_;
  std::vector<char> inner_;  // per vertex: all its neighbours are in its own part
};

}  // namespace

HalfEdgeMesh thinOut(const HalfEdgeMesh& mesh, double tolerance, RunContext& run) {
  return Thinner(mesh, tolerance, run).work();
}

}  // namespace swept::step
