// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/split_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "geometry/cut_triangle.h"
#include "geometry/half_edges.h"
#include "motion/step_path.h"

namespace swept {
namespace {

// Sampling time in ns: per copy of a face (with its side patches), per cell of length of a face
// that is not culled, and per crossing. Only the ratios matter. The constants are fitted to the
// times of 40 runs of eight random inputs with edges of 1 to 75 cells.
constexpr double kFaceCost = 70, kLengthCost = 28, kCrossingCost = 7;
/// Largest number of triangles after splitting. The body must not need more memory than the
/// envelope.
constexpr double kMaxTriangles = 2e6;
/// Required ratio of the estimated time before to the time after: for splitting at all, and for
/// each further reduction of the edge length. Smaller gains are within the uncertainty of the
/// estimates.
constexpr double kGain = 2, kFurtherGain = 1.2;

struct Step {
  double radius, angle;
};

/// The longest side of a triangle and the height on that side.
struct Extent {
  double side, height;
};

/// Estimates the sampling time if all edges are at most `longest` mm long.
class SamplingCost {
 public:
  SamplingCost(const TriMesh& body, const Trajectory& trajectory, double cell, RunContext& run) {
    const Sphere sphere = boundingSphere(body);
    cell_ = cell;
    radius_ = sphere.radius;
    const auto& poses = trajectory.poses;
    for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
      run.checkpoint(Phase::Motion, i, poses.size());
      const StepPath path(poses[i], poses[i + 1], trajectory.interpolation);
      steps_.push_back({path.radius(sphere), path.angle()});
    }
    double area = 0;
    for (const auto& t : body.triangles) {
      const Eigen::Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]],
                            &c = body.vertices[t[2]];
      const double side = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      const double twice = (b - a).cross(c - a).norm();
      extents_.push_back({side, twice / side});
      area += twice / 2;
    }
    constexpr double kThreeAxes = 1.5;  // crossings per square cell, averaged over all directions
    crossings_ = kThreeAxes * area / (cell * cell);
  }

  double triangles(double longest) const {
    double count = 0;
    for (const Extent& e : extents_) count += pieces(e, longest);
    return count;
  }

  double placements(double longest, double chord) const {
    double count = 1;
    for (const Step& s : steps_)
      count += std::max(1.0, piecesOf(s.radius, s.angle, longest, chord));
    return count;
  }

  double copies(double longest, double chord) const {
    return triangles(longest) * placements(longest, chord);
  }

  /// Returns the estimated sampling time in ns, or infinity if there would be too many triangles.
  double nanoseconds(double longest, double chord) const {
    const double count = triangles(longest);
    if (count > std::max(kMaxTriangles, static_cast<double>(extents_.size()))) {
      return std::numeric_limits<double>::infinity();
    }
    return placements(longest, chord) *
           (count * kFaceCost + unculledLength(longest) * kLengthCost + crossings_ * kCrossingCost);
  }

  /// Returns the edge length (mm) with the shortest time. `longest`: longest edge of the unsplit
  /// body.
  double bestEdge(double longest, double chord, double cell) const {
    double best = longest, limit = nanoseconds(longest, chord) / kGain;
    for (double edge = longest / 2; edge > cell; edge /= 2) {
      const double time = nanoseconds(edge, chord);
      if (time >= limit) continue;
      limit = time / kFurtherGain;
      best = edge;
    }
    return best;
  }

 private:
  /// Returns the number of pieces into which splitEdges() cuts a triangle. The pieces have an area
  /// of about a quarter of longest^2.
  static double pieces(const Extent& e, double longest) {
    return e.side <= longest ? 1 : 2 * e.side / longest * std::max(1.0, e.height / longest);
  }

  /// Returns the total length, in cells, of the longest sides of the triangles of one copy that are
  /// not culled. A triangle is not culled if one part of it moves outward and another part inward.
  /// The longer the triangle is compared with the body, the more often this happens.
  double unculledLength(double longest) const {
    double sum = 0;
    for (const Extent& e : extents_) {
      const double side = std::min(e.side, longest);
      sum += pieces(e, longest) * side / cell_ * std::min(1.0, side / radius_);
    }
    return sum;
  }

  double cell_ = 1, radius_ = 1;  // mm
  double crossings_ = 0;
  std::vector<Step> steps_;
  std::vector<Extent> extents_;
};

/// Creates vertices in the middle of edges, one per edge.
class Midpoints {
 public:
  explicit Midpoints(TriMesh& mesh) : mesh_(mesh) {}
  std::int32_t of(std::int32_t a, std::int32_t b) {
    const auto [at, isNew] =
        made_.try_emplace(edgeKey(a, b), static_cast<std::int32_t>(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.emplace_back((mesh_.vertices[a] + mesh_.vertices[b]) / 2);
    return at->second;
  }

 private:
  TriMesh& mesh_;
  std::unordered_map<std::uint64_t, std::int32_t> made_;
};

}  // namespace

MotionApproximation planApproximation(const TriMesh& body, const Trajectory& trajectory,
                                      double chord, double cell, double mostCopies, bool maySplit,
                                      RunContext& run) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (trajectory.interpolation == Interpolation::None || trajectory.poses.size() < 2) {
    return {kNone, chord};
  }
  const double longest = longestEdge(body);
  const SamplingCost cost(body, trajectory, cell, run);
  const auto bestAt = [&](double within) {
    return maySplit ? cost.bestEdge(longest, within, cell) : longest;
  };
  const double most = std::max(mostCopies, 2 * cost.copies(bestAt(cell), cell));
  double edge = bestAt(chord);
  while (cost.copies(edge, chord) > most) edge = bestAt(chord *= 2);
  return {edge < longest ? edge : kNone, chord};
}

TriMesh splitEdges(const TriMesh& body, double longest, RunContext& run) {
  TriMesh mesh = body;
  const double longest2 = longest * longest;
  for (bool changed = true; changed;) {
    run.checkpoint(Phase::Motion);
    changed = false;
    Midpoints midpoints(mesh);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t n = 0; n < count; ++n) {
      const auto t = mesh.triangles[n];
      const auto length2 = [&](int c) {
        return (mesh.vertices[t[c]] - mesh.vertices[t[(c + 1) % 3]]).squaredNorm();
      };
      std::array<bool, 3> isLong{};
      int split = 0;
      for (int c = 0; c < 3; ++c) split += (isLong[c] = length2(c) > longest2) ? 1 : 0;
      if (split == 0) continue;
      changed = true;
      // The order of new vertices decides the bytes of the result: the side after a short one is
      // the first.
      const auto firstShort = std::find(isLong.begin(), isLong.end(), false);
      const auto start = firstShort == isLong.end() ? 1 : firstShort - isLong.begin() + 1;
      std::array<std::int32_t, 3> middle{kNotCut, kNotCut, kNotCut};
      for (int i = 0; i < 3; ++i) {
        const auto c = (start + i) % 3;
        if (isLong[c]) middle[c] = midpoints.of(t[c], t[(c + 1) % 3]);
      }
      bool isFirst = true;
      cutTriangle(
          t, middle,
          [&](std::int32_t p, std::int32_t q) {
            return (mesh.vertices[p] - mesh.vertices[q]).squaredNorm();
          },
          [&](std::int32_t p, std::int32_t q, std::int32_t r) {
            if (std::exchange(isFirst, false)) {
              mesh.triangles[n] = {p, q, r};
              return;
            }
            mesh.triangles.push_back({p, q, r});
            if (!mesh.faceOf.empty()) mesh.faceOf.push_back(std::int32_t{mesh.faceOf[n]});
          });
    }
  }
  return mesh;
}

}  // namespace swept
