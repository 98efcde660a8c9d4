// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/body_motion.h"

#include <algorithm>
#include <cmath>

#include "solid/sweep/contact.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

BodyMotion::BodyMotion(const ElementaryBody& body, const StepPath& path)
    : body_(body), path_(path) {
  constexpr int kChords = 16;
  for (int v = 0; v < body.vertices.Extent(); ++v) {
    double travel = 0;
    for (int i = 0; i < kChords; ++i)
      travel += (at(body.point(v), (i + 1.0) / kChords) -
                 at(body.point(v), static_cast<double>(i) / kChords))
                    .norm();
    length_ = std::max(length_, travel);
    shortest_ = std::min(shortest_, travel);
  }
}

double BodyMotion::speedOf(int f, const Vector3d& p, double s) const {
  return body_.surfaceOf(f).normalAt(p).dot(Moment(path_, s).velocityAt(p));
}

OfTwo BodyMotion::speedOn(const BodyEdge& edge, int f) const {
  return [this, &edge, f](const Vector2d& on) { return speedOf(f, edge.at(on[0]), on[1]); };
}

std::vector<ZeroArc> BodyMotion::contactsOf(const BodyEdge& edge, int f, Range s) const {
  return zeroArcs(speedOn(edge, f), edge.range, s, {edge.scale, length_});
}

bool BodyMotion::doesSlide() const {
  constexpr int kTimes = 16, kPoints = 4;
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    double largest = 0;
    for (const int e : body_.faces[f].edges) {
      const BodyEdge& edge = body_.edges[e];
      for (int i = 0; i <= kTimes; ++i) {
        for (int j = 0; j <= kPoints; ++j) {
          const Vector3d p = edge.at(edge.range.at(static_cast<double>(j) / kPoints));
          largest = std::max(
              largest, std::abs(speedOf(static_cast<int>(f), p, static_cast<double>(i) / kTimes)));
        }
      }
    }
    if (largest <= kNoSpeed * length_) return true;
  }
  return false;
}

bool BodyMotion::isOutline(const BodyEdge& edge) const {
  constexpr int kTimes = 128, kPoints = 16;
  for (int i = 0; i <= kTimes; ++i) {
    const double s = static_cast<double>(i) / kTimes;
    for (int j = 0; j <= kPoints; ++j) {
      const Vector3d p = edge.at(edge.range.at(static_cast<double>(j) / kPoints));
      if (speedOf(edge.faces[0], p, s) * speedOf(edge.faces[1], p, s) < 0) return true;
    }
  }
  return false;
}

std::vector<double> BodyMotion::pinches() const {
  std::vector<double> times{0, 1};
  for (const BodyEdge& edge : body_.edges) {
    if (edge.faces[1] < 0 || !body_.isConvex(edge)) continue;
    const OfTwo other = speedOn(edge, edge.faces[1]);
    for (const ZeroArc& arc : contactsOf(edge, edge.faces[0], {0, 1})) {
      for (const double t : zerosOf([&](double x) { return other(arc.at(x)); }, arc.range()))
        times.push_back(arc.at(t).y());
    }
  }
  std::sort(times.begin(), times.end());
  constexpr double kSameTime = 1e-6;
  times.erase(
      std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < kSameTime; }),
      times.end());
  times.back() = 1;
  return times;
}

}  // namespace swept::step
