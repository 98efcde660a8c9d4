// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/bent_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "solid/model/split_edges.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSpans = 22;  // number of spans of a reader's spline
/// mm, largest allowed error. A reader gives every edge a tolerance of at least 1e-7; the rest is a
/// margin for rounding.
constexpr double kMaxError = 0.8e-7;

using Values = std::array<double, kSpans + 1>;

// Returns the slopes, per span, of the spline through evenly spaced values.
Values slopesOf(const Values& f) {
  constexpr std::size_t n = kSpans;
  const auto atEnd = [](double a, double b, double c, double d) {
    return (-11 * a + 18 * b - 9 * c + 2 * d) / 6;
  };
  Values slopes{}, weight{};
  slopes[0] = atEnd(f[0], f[1], f[2], f[3]);
  slopes[n] = -atEnd(f[n], f[n - 1], f[n - 2], f[n - 3]);
  // Solves slopes[i - 1] + 4 slopes[i] + slopes[i + 1] = 3 (f[i + 1] - f[i - 1]) for all i.
  for (std::size_t i = 1; i < n; ++i) {
    weight[i] = 1 / (4 - weight[i - 1]);
    slopes[i] = weight[i] * (3 * (f[i + 1] - f[i - 1]) - slopes[i - 1]);
  }
  for (std::size_t i = n - 1; i > 0; --i) slopes[i] -= weight[i] * slopes[i + 1];
  return slopes;
}

double middleOfSpan(const Values& f, const Values& slopes, std::size_t i) {
  return (f[i] + f[i + 1]) / 2 + (slopes[i] - slopes[i + 1]) / 8;
}

class SphereParameters {
 public:
  explicit SphereParameters(const Carrier& sphere)
      : sphere_(sphere),
        x_(sphere.xdir.norm() > 0.5 ? sphere.xdir : anyOrthogonal(sphere.axis)),
        y_(sphere.axis.cross(x_)) {}

  // The seam, where the angle jumps, is at xdir, outside the face.
  double longitude(const Vector3d& p) const {
    const Vector3d d = p - sphere_.point;
    return std::atan2(-d.dot(y_), -d.dot(x_));
  }
  double latitude(const Vector3d& p) const {
    const Vector3d d = p - sphere_.point;
    return std::atan2(d.dot(sphere_.axis), std::hypot(d.dot(x_), d.dot(y_)));
  }
  double distance(double longitude, double latitude, const Vector3d& p) const {
    const double off = longitude - this->longitude(p);
    return sphere_.radius * std::hypot(std::cos(latitude) * off, latitude - this->latitude(p));
  }

 private:
  const Carrier& sphere_;
  Vector3d x_, y_;
};

// Returns how far the parameter curve of a reader is off the arc, in mm.
double splineError(const Curve& arc, const Carrier& sphere) {
  const SphereParameters on(sphere);
  const double step = arc.last / kSpans;
  Values u{}, v{};
  for (std::size_t i = 0; i <= kSpans; ++i) {
    const Vector3d p = arc.at(step * static_cast<double>(i));
    u[i] = on.longitude(p);
    v[i] = on.latitude(p);
  }
  const Values uSlopes = slopesOf(u), vSlopes = slopesOf(v);
  double largest = 0;
  for (std::size_t i = 0; i < kSpans; ++i) {
    const Vector3d p = arc.at(step * (static_cast<double>(i) + 0.5));
    largest =
        std::max(largest, on.distance(middleOfSpan(u, uSlopes, i), middleOfSpan(v, vSlopes, i), p));
  }
  return largest;
}

std::vector<EdgeCut> findBentArcs(const Model& model) {
  std::vector<char> isBent(model.edges.size(), 0);
  for (const ModelFace& face : model.faces) {
    if (face.surface.kind != CarrierKind::Sphere) continue;
    for (const auto& loop : face.loops) {
      for (const ModelUse& use : loop) {
        const Curve& curve = model.edges[use.edge].curve;
        if (curve.kind == CurveKind::Circle && splineError(curve, face.surface) > kMaxError)
          isBent[use.edge] = 1;
      }
    }
  }
  std::vector<EdgeCut> cuts;
  for (std::size_t e = 0; e < isBent.size(); ++e) {
    if (isBent[e] == 0) continue;
    cuts.push_back({static_cast<std::int32_t>(e), middleOf(model.edges[e].curve)});
  }
  return cuts;
}

}  // namespace

void cutBentArcs(Model& model) {
  constexpr int kMaxRounds = 6;
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<EdgeCut> bent = findBentArcs(model);
    if (bent.empty()) return;
    splitEdges(bent, model);
  }
}

}  // namespace swept::step
