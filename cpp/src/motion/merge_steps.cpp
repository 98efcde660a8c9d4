// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/merge_steps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/mesh_parts.h"
#include "motion/step_path.h"

namespace swept {
namespace {

/// Motions with fewer placements are not changed, because their runs are short anyway.
constexpr std::size_t kMinPlacements = 256;
/// A merge must save at least this fraction of the steps. A smaller saving would cost accuracy but
/// save little time.
constexpr double kMinSaved = 0.5;
/// Fraction of `chord` that the deviations at dropped placements may use. The rest is for arcs and
/// warped patches.
constexpr double kDropFraction = 0.5;

/// The bounding box of the body at a placement, or the difference of two such boxes. Columns:
/// position of the centre, and the three half axes.
struct Frame {
  Eigen::Matrix<double, 3, 4> columns;

  /// Returns the largest length of the vectors from the origin to the eight corners.
  double largestAtCorners() const {
    double most = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d axes = columns.col(1) + (corner & 1 ? -1 : 1) * columns.col(2) +
                                   (corner & 2 ? -1 : 1) * columns.col(3);
      // The opposite corner of the box has the negative half axes.
      most = std::max(
          {most, (columns.col(0) + axes).squaredNorm(), (columns.col(0) - axes).squaredNorm()});
    }
    return std::sqrt(most);
  }
};

class Merger {
 public:
  Merger(const Motion& motion, const TriMesh& body, double chord)
      : motion_(motion), chord_(chord), longest_(longestEdge(body)) {
    const Eigen::AlignedBox3d box = boxOf(body);
    const Eigen::Vector3d half = box.sizes() / 2;
    frames_.reserve(motion.placements.size());
    for (const Placement& p : motion.placements) {
      Frame frame;
      frame.columns << p.apply(box.center()), p.rotation * half.asDiagonal();
      frames_.push_back(frame);
    }
    for (std::size_t k = 0; k < motion.steps(); ++k) arcs_.push_back(arcOf(motion, k, box));
  }

  /// Returns the end of a merged step that starts at placement `begin`. Doubles the length of the
  /// step while the step fits, and then refines the length by halving. `bound` receives the bound
  /// of the merged step.
  std::size_t endOfStep(std::size_t begin, double& bound) const {
    const std::size_t last = motion_.placements.size() - 1;
    std::size_t end = begin + 1, stride = 1;
    bound = 0;
    const auto tryEnd = [&](std::size_t to) {
      if (to > last || !fits(begin, to, bound)) return false;
      end = to;
      return true;
    };
    while (tryEnd(end + stride)) stride *= 2;
    for (; stride > 0; stride /= 2) tryEnd(end + stride);
    return end;
  }

 private:
  /// Returns whether the steps from `begin` to `end` can become one step. If so, sets `bound`.
  bool fits(std::size_t begin, std::size_t end, double& bound) const {
    const Placement &p = motion_.placements[begin], &q = motion_.placements[end];
    const double duration = q.timeSeconds - p.timeSeconds;
    if (!(duration > 0)) return false;
    // |R - S| = 2 sqrt(2) sin(turn / 2) in the Frobenius norm, where `turn` is the angle between R
    // and S.
    const double sine = (p.rotation - q.rotation).norm() / (2 * std::sqrt(2.0));
    const double warp = warpOf(2 * std::asin(std::min(1.0, sine)), longest_);
    if (warp > chord_) return false;
    double farthest = 0, arc = arcs_[begin];
    const Frame &from = frames_[begin], &to = frames_[end];
    for (std::size_t k = begin + 1; k < end; ++k) {
      const double s = (motion_.placements[k].timeSeconds - p.timeSeconds) / duration;
      const Frame deviation{frames_[k].columns - (1 - s) * from.columns - s * to.columns};
      farthest = std::max(farthest, deviation.largestAtCorners());
      arc = std::max(arc, arcs_[k]);
      if (farthest > kDropFraction * chord_ || farthest + arc + warp > chord_) return false;
    }
    bound = farthest + arc + warp;
    return true;
  }

  const Motion& motion_;
  double chord_, longest_;
  std::vector<Frame> frames_;
  std::vector<double> arcs_;  // arcOf() of each step, in mm
};

Placement between(const Placement& p, const Placement& q, double s) {
  return {(1 - s) * p.rotation + s * q.rotation, (1 - s) * p.translation + s * q.translation,
          (1 - s) * p.timeSeconds + s * q.timeSeconds};
}

/// Returns the placement half way in time between two placements of the motion.
Placement middleOf(const Motion& motion, std::size_t begin, std::size_t end) {
  if (end == begin + 1) return motion.midpoints[begin];
  const auto first = motion.placements.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = motion.placements.begin() + static_cast<std::ptrdiff_t>(end);
  const double time = (first->timeSeconds + last->timeSeconds) / 2;
  // The first inner placement at or after this time; the end if there is none.
  const auto after = std::lower_bound(
      first + 1, last, time, [](const Placement& p, double at) { return p.timeSeconds < at; });
  const Placement &p = *(after - 1), &q = *after;
  const double duration = q.timeSeconds - p.timeSeconds;
  return between(p, q, duration > 0 ? (time - p.timeSeconds) / duration : 1);
}

}  // namespace

Motion mergeSteps(Motion motion, const TriMesh& body, double chord, RunContext& run) {
  if (!motion.continuous || motion.placements.size() < kMinPlacements) return motion;
  const Merger merger(motion, body, chord);
  const std::size_t last = motion.placements.size() - 1;
  const auto most = static_cast<std::size_t>((1 - kMinSaved) * static_cast<double>(last));
  std::vector<std::size_t> kept{0};
  double bound = 0;  // of all merged steps
  while (kept.back() != last) {
    run.checkpoint(Phase::Motion, kept.back(), last);
    double stepBound;
    kept.push_back(merger.endOfStep(kept.back(), stepBound));
    bound = std::max(bound, stepBound);
    if (kept.size() > most + 1) return motion;
  }
  Motion merged;
  merged.continuous = true;
  merged.largestStepTravel = motion.largestStepTravel;
  merged.chordError = std::max(motion.chordError, bound);
  merged.mergeError = bound;
  merged.placements.reserve(kept.size());
  for (std::size_t n = 0; n < kept.size(); ++n) {
    merged.placements.push_back(motion.placements[kept[n]]);
    if (n > 0) merged.midpoints.push_back(middleOf(motion, kept[n - 1], kept[n]));
  }
  std::size_t n = 0;
  for (const std::uint32_t placement : motion.poses) {
    while (n + 1 < kept.size() && kept[n + 1] <= placement) ++n;
    merged.poses.push_back(static_cast<std::uint32_t>(n));
  }
  return merged;
}

}  // namespace swept
