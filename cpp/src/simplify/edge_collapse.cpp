// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/edge_collapse.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

#include "base/parallel.h"
#include "geometry/spread_points.h"

namespace swept {
namespace {

using Eigen::Vector3d;

constexpr double kMinCosine = 0.2;      ///< a triangle may turn by less than 78 degrees
constexpr double kMinShape = 0.01;      ///< height / longest side of a new triangle
constexpr double kLengthWeight = 1e-3;  ///< of tolerance^2: long edges of flat parts go last
constexpr double kRankCut = 1e-3;
/// Of tolerance^2: where the mean squared distance is less, no points are spread on large meshes.
constexpr double kFlatFraction = 0.02;
constexpr std::size_t kLarge = 50'000;  ///< triangles; on smaller meshes points are always spread
constexpr double kNearFraction = 0.05;  ///< of a sample's squared limit
constexpr double kNetFraction = 0.96;   ///< of tolerance^2: limit of points on new triangles

struct Candidate {
  double cost;
  std::int32_t u, v;
  std::uint32_t stamp;
  bool operator<(const Candidate& o) const {  // of a queue that takes the largest first
    if (cost != o.cost) return cost > o.cost;
    return u != o.u ? u > o.u : v > o.v;
  }
};

class Collapser {
 public:
  Collapser(CollapseMesh& mesh, Samples& samples, const NearestTriangle& original, double tolerance,
            RunContext& run)
      : mesh_(mesh),
        samples_(samples),
        original_(original),
        tolerance_(tolerance),
        run_(run),
        large_(mesh.triangles.size() > kLarge),
        around_(mesh.vertices.size()),
        stamp_(mesh.vertices.size(), 0),
        first_(mesh.triangles.size(), -1),
        next_(samples.points.size(), -1) {}

  void run() {
    prepare();
    std::uint64_t steps = 0;
    while (!queue_.empty()) {
      if ((++steps & 1023u) == 0) run_.checkpoint(Phase::Simplify, 2, 4);
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.stamp != stamp_[c.u] + stamp_[c.v] || around_[c.u].empty() || around_[c.v].empty()) {
        continue;
      }
      tryCollapse(c.u, c.v);
    }
    finish();
  }

 private:
  using Corners = std::array<std::int32_t, 3>;

  const Vector3d& at(std::int32_t v) const { return mesh_.vertices[v].position; }
  double distance(std::int32_t sample, const Corners& t) const {
    return squaredDistance(samples_.points[sample], at(t[0]), at(t[1]), at(t[2]));
  }

  void prepare() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        around_[v].push_back(static_cast<std::int32_t>(t));
      }
    }
    const std::size_t n = next_.size();
    samples_.triangle.assign(n, -1);
    parallelBlocks(n, 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        double best = 1e300;
        for (const std::int32_t t : around_[samples_.vertex[s]]) {
          const double d = distance(static_cast<std::int32_t>(s), mesh_.triangles[t]);
          if (d < best) {
            best = d;
            samples_.triangle[s] = t;
          }
        }
      }
    });
    for (std::size_t s = 0; s < n; ++s) attach(static_cast<std::int32_t>(s), samples_.triangle[s]);
    std::vector<Candidate> all;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Corners& c = mesh_.triangles[t];
      for (int k = 0; k < 3; ++k) {
        if (c[k] < c[(k + 1) % 3]) all.push_back({0, c[k], c[(k + 1) % 3], 0});
      }
    }
    parallelBlocks(all.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Target target = rate(all[i].u, all[i].v);
        all[i].cost = target.possible ? target.cost : -1;
      }
    });
    std::erase_if(all, [](const Candidate& c) { return c.cost < 0; });
    queue_ = std::priority_queue<Candidate>(std::less<Candidate>{}, std::move(all));
  }

  void attach(std::int32_t sample, std::int32_t triangle) {
    next_[sample] = first_[triangle];
    first_[triangle] = sample;
    samples_.triangle[sample] = triangle;
  }

  struct Target {
    Vector3d position;
    double cost;
    bool possible = true;
    bool flat = false;
  };
  Target rate(std::int32_t u, std::int32_t v) const {
    const CollapseVertex &a = mesh_.vertices[u], &b = mesh_.vertices[v];
    Quadric q = a.quadric;
    q += b.quadric;
    const Vector3d middle = (a.position + b.position) / 2;
    const double length2 = (a.position - b.position).squaredNorm();
    int rank = 0;
    Target best{q.minimise(middle, kRankCut, rank), 0, true, false};
    double error = q.error(best.position);
    if ((best.position - middle).squaredNorm() > 4 * length2) error = 1e300;
    for (const Vector3d* p : {&a.position, &b.position}) {
      const double e = q.error(*p);
      if (e < error) {
        error = e;
        best.position = *p;
      }
    }
    // The mean distance of the planes is no more than the largest: no need to look at samples.
    const double weight = a.quadric.weight + b.quadric.weight;
    best.flat = large_ && error <= weight * kFlatFraction * tolerance_ * tolerance_;
    best.possible = error <= weight * tolerance_ * tolerance_;
    best.cost = error + kLengthWeight * tolerance_ * tolerance_ * length2;
    return best;
  }

  void push(std::int32_t u, std::int32_t v) {
    if (u > v) std::swap(u, v);
    const Target target = rate(u, v);
    if (target.possible) queue_.push({target.cost, u, v, stamp_[u] + stamp_[v]});
  }

  static bool holds(const Corners& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
  }

  void neighbours(std::int32_t v, std::vector<std::int32_t>& out) const {
    out.clear();
    for (const std::int32_t t : around_[v]) {
      for (const std::int32_t w : mesh_.triangles[t]) {
        if (w != v) out.push_back(w);
      }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

  /// Exactly the two vertices beside the edge are common, and they keep three triangles.
  bool linkHolds(std::int32_t u, std::int32_t v) {
    neighbours(u, ringU_);
    neighbours(v, ringV_);
    common_.clear();
    std::set_intersection(ringU_.begin(), ringU_.end(), ringV_.begin(), ringV_.end(),
                          std::back_inserter(common_));
    if (common_.size() != 2) return false;
    return around_[common_[0]].size() > 3 && around_[common_[1]].size() > 3;
  }

  bool shapeHolds(const Corners& was, std::int32_t moved, const Vector3d& p) const {
    Vector3d c[3];
    for (int k = 0; k < 3; ++k) c[k] = was[k] == moved ? p : at(was[k]);
    const Vector3d before = (at(was[1]) - at(was[0])).cross(at(was[2]) - at(was[0]));
    const Vector3d after = (c[1] - c[0]).cross(c[2] - c[0]);
    const double area = after.norm();
    if (before.dot(after) <= kMinCosine * before.norm() * area) return false;
    const auto longest2 = [](const Vector3d& x, const Vector3d& y, const Vector3d& z) {
      return std::max({(x - y).squaredNorm(), (y - z).squaredNorm(), (z - x).squaredNorm()});
    };
    const double shape = area / longest2(c[0], c[1], c[2]);
    if (shape >= kMinShape) return true;
    return shape > before.norm() / longest2(at(was[0]), at(was[1]), at(was[2]));
  }

  /// Finds for every sample of the ring a new triangle within its limit.
  bool samplesHold() {
    moves_.clear();
    for (const std::int32_t t : ring_) {
      for (std::int32_t s = first_[t]; s >= 0; s = next_[s]) {
        const double limit = static_cast<double>(samples_.limit[s]) * samples_.limit[s];
        double best = 1e300;
        std::int32_t nearest = -1;
        // Where it lay before is likely where it lies now; near enough there, none else is asked.
        const auto before = std::find(kept_.begin(), kept_.end(), t);
        if (before != kept_.end()) {
          nearest = static_cast<std::int32_t>(before - kept_.begin());
          best = distance(s, newTriangles_[nearest]);
        }
        for (std::size_t n = 0; n < newTriangles_.size() && best > kNearFraction * limit; ++n) {
          const double d = distance(s, newTriangles_[n]);
          if (d < best) {
            best = d;
            nearest = static_cast<std::int32_t>(n);
          }
        }
        if (best > limit) return false;
        moves_.push_back({s, nearest});
      }
    }
    return true;
  }

  /// Points spread over the new triangles lie within the tolerance of the original.
  bool trianglesHold() const {
    const double limit = kNetFraction * tolerance_ * tolerance_;
    std::int32_t hint = -1;
    for (const Corners& t : newTriangles_) {
      const bool far = spreadPoints(at(t[0]), at(t[1]), at(t[2]), [&](const Vector3d& p) {
        return original_.query(p, 2 * limit, limit, hint) > limit;
      });
      if (far) return false;
    }
    return true;
  }

  void tryCollapse(std::int32_t u, std::int32_t v) {
    if (!linkHolds(u, v)) return;
    const Target target = rate(u, v);
    const Vector3d& p = target.position;
    ring_.clear();
    kept_.clear();
    newTriangles_.clear();
    for (const auto& [x, other] : {std::pair{u, v}, std::pair{v, u}}) {
      for (const std::int32_t t : around_[x]) {
        const Corners& c = mesh_.triangles[t];
        if (holds(c, other)) {
          if (x == u) ring_.push_back(t);
          continue;
        }
        if (!shapeHolds(c, x, p)) return;
        ring_.push_back(t);
        kept_.push_back(t);
        Corners to = c;
        for (auto& w : to) {
          if (w == v) w = u;
        }
        newTriangles_.push_back(to);
      }
    }
    const double limit = tolerance_ * tolerance_;
    if (!target.flat && original_.query(p, 1.0001 * limit, limit) > limit) return;
    const Vector3d old = at(u);
    mesh_.vertices[u].position = p;
    if (!samplesHold() || (!target.flat && !trianglesHold())) {
      mesh_.vertices[u].position = old;
      return;
    }
    accept(u, v);
  }

  void accept(std::int32_t u, std::int32_t v) {
    CollapseVertex &a = mesh_.vertices[u], &b = mesh_.vertices[v];
    a.quadric += b.quadric;
    if ((b.samplePoint - a.position).squaredNorm() < (a.samplePoint - a.position).squaredNorm()) {
      a.sample = b.sample;
      a.samplePoint = b.samplePoint;
    }
    for (const std::int32_t t : ring_) first_[t] = -1;
    for (const std::int32_t t : ring_) {
      if (!holds(mesh_.triangles[t], u) || !holds(mesh_.triangles[t], v)) continue;
      for (const std::int32_t w : mesh_.triangles[t]) {
        if (w != u && w != v) std::erase(around_[w], t);
      }
      mesh_.triangles[t] = {-1, -1, -1};
    }
    for (std::size_t n = 0; n < kept_.size(); ++n) mesh_.triangles[kept_[n]] = newTriangles_[n];
    for (const auto& [sample, n] : moves_) attach(sample, kept_[n]);
    around_[u] = kept_;
    around_[v].clear();
    ++stamp_[u];
    ++stamp_[v];
    neighbours(u, ringU_);
    for (const std::int32_t w : ringU_) push(u, w);
  }

  void finish() {
    std::vector<std::int32_t> vertexTo(mesh_.vertices.size(), -1),
        triangleTo(mesh_.triangles.size(), -1);
    std::size_t count = 0;
    for (std::size_t v = 0; v < vertexTo.size(); ++v) {
      if (around_[v].empty()) continue;
      vertexTo[v] = static_cast<std::int32_t>(count);
      mesh_.vertices[count++] = mesh_.vertices[v];
    }
    mesh_.vertices.resize(count);
    count = 0;
    for (std::size_t t = 0; t < triangleTo.size(); ++t) {
      Corners c = mesh_.triangles[t];
      if (c[0] < 0) continue;
      for (auto& v : c) v = vertexTo[v];
      triangleTo[t] = static_cast<std::int32_t>(count);
      mesh_.triangles[count++] = c;
    }
    mesh_.triangles.resize(count);
    double largest = 0;
    for (std::size_t i = 0; i < samples_.triangle.size(); ++i) {
      auto& t = samples_.triangle[i];
      t = triangleTo[t];
      largest = std::max(largest, distance(static_cast<std::int32_t>(i), mesh_.triangles[t]));
    }
    samples_.largest = std::sqrt(largest);
  }

  CollapseMesh& mesh_;
  Samples& samples_;
  const NearestTriangle& original_;
  double tolerance_;
  RunContext& run_;
  bool large_;
  std::vector<std::vector<std::int32_t>> around_;
  std::vector<std::uint32_t> stamp_;
  std::vector<std::int32_t> first_, next_;  ///< samples of a triangle, chained
  std::priority_queue<Candidate> queue_;
  std::vector<std::int32_t> ringU_, ringV_, common_, ring_, kept_;
  std::vector<Corners> newTriangles_;
  std::vector<std::pair<std::int32_t, std::int32_t>> moves_;
};

}  // namespace

void collapseEdges(CollapseMesh& mesh, Samples& samples, const NearestTriangle& original,
                   double tolerance, RunContext& run) {
  Collapser(mesh, samples, original, tolerance, run).run();
}

}  // namespace swept
