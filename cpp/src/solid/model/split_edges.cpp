// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/split_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swept::step {
namespace {

std::pair<Curve, Curve> split(const Curve& curve, double at) {
  return {partOf(curve, 0, at), partOf(curve, at, curve.last)};
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
