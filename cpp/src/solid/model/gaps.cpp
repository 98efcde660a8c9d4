// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/gaps.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/sort_unique.h"
#include "solid/carrier/section.h"

namespace swept::step {
namespace {

/// Mm. A kernel starts from this tolerance; an edge within it needs no larger one.
constexpr double kHeld = 1e-7;
double facetGap(double tolerance) { const char* t = getenv("GAP"); return t == nullptr ? kHeld : std::max(kHeld, std::min(0.01, atof(t) * tolerance)); }

}  // namespace

std::vector<std::int32_t> findLoosePatches(const Model& model, std::int32_t known,
                                           double tolerance) {
  std::vector<std::array<std::int32_t, 2>> patches(model.edges.size(), {-1, -1});
  for (const ModelFace& face : model.faces) {
    for (const auto& loop : face.loops) {
      for (const ModelUse& use : loop) patches[use.edge][use.forward ? 0 : 1] = face.patch;
    }
  }
  std::vector<std::int32_t> loose;
  for (const ModelFace& face : model.faces) {
    if (face.surface.kind == CarrierKind::Facet) continue;
    for (const auto& loop : face.loops) {
      for (const ModelUse& use : loop) {
        const ModelEdge& edge = model.edges[use.edge];
        if (edge.tolerance <= kHeld) continue;
        const double gap = largestGap(edge.curve, face.surface);
        const auto [one, two] = patches[use.edge];
        const bool bothKnown = one >= 0 && two >= 0 && one < known && two < known;
        if (gap > (bothKnown ? tolerance : facetGap(tolerance))) {
          loose.push_back(face.patch);
          if (getenv("DBG") != nullptr) {
            const double a = face.surface.distance(edge.curve.at(0)), b = face.surface.distance(edge.curve.at(edge.curve.last));
            fprintf(stderr, "  loose %d %s(%s other %d) kind %d gap %g ends %g %g length %g\n", face.patch, surfaceKindName(face.surface.kind), bothKnown ? "known" : "facet", one==face.patch?two:one, int(edge.curve.kind), gap, a, b, (edge.curve.at(0)-edge.curve.at(edge.curve.last)).norm());
          }
        }
      }
    }
  }
  sortUnique(loose);
  return loose;
}

}  // namespace swept::step
