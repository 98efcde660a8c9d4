// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/regular.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSearchSteps = 32;
/// Cosine of 45 degrees. If the angle between adjacent normals is larger, there is a singular
/// point.
constexpr double kMinAgreement = 0.7;

class Search {
 public:
  Search(const Sheet& sheet, Range u, Range t) : sheet_(sheet), u_(u), t_(t) {
    for (int i = 0; i <= kSearchSteps; ++i) {
      for (int j = 0; j <= kSearchSteps; ++j) {
        feet_.push_back(
            sheet.footAt(u.at(i / double{kSearchSteps}), t.at(j / double{kSearchSteps})));
        largestU_ = std::max(largestU_, feet_.back().alongU.norm());
        largestT_ = std::max(largestT_, feet_.back().alongT.norm());
      }
    }
  }

  // Returns the smallest of three numbers: the sine of the angle between both derivatives, and
  // their relative lengths. It is 0 at a singular point.
  double regularity(const Sheet::Foot& foot) const {
    const double a = foot.alongU.norm(), b = foot.alongT.norm();
    if (!(a > 0 && b > 0)) return 0;
    const double sine = foot.alongU.cross(foot.alongT).norm() / (a * b);
    return std::min({sine, a / largestU_, b / largestT_});
  }

  // Returns the least regular point: starts at that of the grid, and searches around it in smaller
  // and smaller steps.
  Vector2d worst() const {
    const auto least = std::min_element(
        feet_.begin(), feet_.end(),
        [&](const auto& a, const auto& b) { return regularity(a) < regularity(b); });
    Vector2d at(least->u, least->t);
    double value = regularity(*least);
    Vector2d step(u_.length() / kSearchSteps, t_.length() / kSearchSteps);
    for (int round = 0; round < 30; ++round) {
      Vector2d best = at;
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          const Vector2d next(std::clamp(at.x() + i * step.x(), u_.from, u_.to),
                              std::clamp(at.y() + j * step.y(), t_.from, t_.to));
          const double here = regularity(sheet_.footAt(next.x(), next.y()));
          if (here >= value) continue;
          value = here;
          best = next;
        }
      }
      if (best == at) step /= 2;
      at = best;
      if (value < kMinRegular) break;
    }
    return at;
  }

  // Returns parameters at which the normal differs much between adjacent grid points, or changes
  // its side.
  std::optional<Vector2d> turning(const std::function<Vector3d(double, double)>& side) const {
    double sign = 0;
    for (int i = 0; i <= kSearchSteps; ++i) {
      for (int j = 0; j <= kSearchSteps; ++j) {
        const Sheet::Foot& foot = at(i, j);
        const Vector3d normal = foot.normal();
        const Vector2d here(foot.u, foot.t);
        if (i > 0 && normal.dot(at(i - 1, j).normal()) < kMinAgreement) return here;
        if (j > 0 && normal.dot(at(i, j - 1).normal()) < kMinAgreement) return here;
        if (!side) continue;
        const double agreement = normal.dot(side(foot.u, foot.t));
        if (sign == 0) sign = agreement > 0 ? 1 : -1;
        if (!(sign * agreement > kMinAgreement)) return here;
      }
    }
    return std::nullopt;
  }

 private:
  const Sheet::Foot& at(int i, int j) const { return feet_[i * (kSearchSteps + 1) + j]; }

  const Sheet& sheet_;
  Range u_, t_;
  std::vector<Sheet::Foot> feet_;
  double largestU_ = 0, largestT_ = 0;
};

}  // namespace

std::optional<Vector2d> findSingular(const Sheet& sheet, Range u, Range t,
                                     const std::function<Vector3d(double, double)>& side) {
  const Search search(sheet, u, t);
  const Vector2d worst = search.worst();
  if (!(search.regularity(sheet.footAt(worst.x(), worst.y())) >= kMinRegular)) return worst;
  return search.turning(side);
}

}  // namespace swept::step
