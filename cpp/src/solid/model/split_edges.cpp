// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/split_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swept::step {
namespace {

using Eigen::Vector3d;

using Size = std::ptrdiff_t;

void startAtZero(Curve& curve) {
  const double from = curve.knots.front(), length = curve.knots.back() - from;
  for (double& knot : curve.knots) knot = (knot - from) / length;
  curve.last = 1;
}

// Returns the same spline with a knot at this parameter, by de Casteljau's construction.
Curve withKnot(const Curve& curve, double at) {
  std::size_t span = 0;
  while (span + 2 < curve.knots.size() && curve.knots[span + 1] <= at) ++span;
  if (at == curve.knots[span]) return curve;
  const double w = (at - curve.knots[span]) / (curve.knots[span + 1] - curve.knots[span]);
  const Vector3d start = curve.at(curve.knots[span]), end = curve.at(curve.knots[span + 1]);
  const Vector3d &p1 = curve.poles[2 * span + 1], &p2 = curve.poles[2 * span + 2];
  const Vector3d a = start + w * (p1 - start), b = p1 + w * (p2 - p1), c = p2 + w * (end - p2);
  Curve cut = curve;
  cut.knots.push_back(at);
  std::sort(cut.knots.begin(), cut.knots.end());
  const auto place = cut.poles.erase(cut.poles.begin() + static_cast<Size>(2 * span) + 1,
                                     cut.poles.begin() + static_cast<Size>(2 * span) + 3);
  cut.poles.insert(place, {a, Vector3d(a + w * (b - a)), Vector3d(b + w * (c - b)), c});
  return cut;
}

// Splits a spline at a knot. The joint there is not a pole of the whole spline, but it becomes the
// end pole of both parts.
std::pair<Curve, Curve> splitSpline(const Curve& whole, double at) {
  const Curve curve = withKnot(whole, at);
  const Size knot = std::find(curve.knots.begin(), curve.knots.end(), at) - curve.knots.begin();
  const Vector3d middle = curve.at(at);
  Curve low = curve, high = curve;
  low.knots.resize(static_cast<std::size_t>(knot) + 1);
  low.poles.resize(2 * static_cast<std::size_t>(knot) + 1);
  low.poles.push_back(middle);
  high.knots.erase(high.knots.begin(), high.knots.begin() + knot);
  high.poles.erase(high.poles.begin(), high.poles.begin() + 2 * knot + 1);
  high.poles.insert(high.poles.begin(), middle);
  startAtZero(low);
  startAtZero(high);
  return {low, high};
}

std::pair<Curve, Curve> split(const Curve& curve, double at) {
  if (curve.kind == CurveKind::Spline) return splitSpline(curve, at);
  if (curve.kind == CurveKind::Line)
    return {lineThrough(curve.at(0), curve.at(at)),
            lineThrough(curve.at(at), curve.at(curve.last))};
  Curve low = curve, high = curve;
  low.last = at;
  high.xdir = (curve.at(at) - curve.start).normalized();
  high.last = curve.last - at;
  return {low, high};
}

}  // namespace

double middleOf(const Curve& curve) {
  double middle = 0.5 * curve.last;
  if (curve.knots.size() > 2) {
    middle =
        *std::min_element(curve.knots.begin() + 1, curve.knots.end() - 1, [&](double a, double b) {
          return std::abs(a - 0.5 * curve.last) < std::abs(b - 0.5 * curve.last);
        });
  }
  return middle;
}

void splitEdges(const std::vector<EdgeCut>& cuts, Model& model) {
  std::vector<std::int32_t> second(model.edges.size(), -1);
  for (const EdgeCut& cut : cuts) {
    const auto middle = static_cast<std::int32_t>(model.vertices.size());
    second[cut.edge] = static_cast<std::int32_t>(model.edges.size());
    const auto [low, high] = split(model.edges[cut.edge].curve, cut.at);
    ModelEdge rest = model.edges[cut.edge];
    model.vertices.push_back({low.at(low.last), rest.tolerance});
    rest.start = middle;
    rest.curve = high;
    model.edges[cut.edge].end = middle;
    model.edges[cut.edge].curve = low;
    model.edges.push_back(std::move(rest));
  }
  for (ModelFace& face : model.faces) {
    for (auto& loop : face.loops) {
      std::vector<ModelUse> uses;
      for (const ModelUse& use : loop) {
        const std::int32_t other = second[use.edge];
        if (other < 0) {
          uses.push_back(use);
        } else if (use.forward) {
          uses.insert(uses.end(), {use, {other, true}});
        } else {
          uses.insert(uses.end(), {{other, false}, use});
        }
      }
      loop = std::move(uses);
    }
  }
}

}  // namespace swept::step
