// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/gaps.h"

#include <algorithm>
#include <array>

#include "solid/carrier/section.h"

namespace swept::step {

std::vector<std::int32_t> findLooseFaces(const Model& model, std::int32_t recognisedCount,
                                         double tolerance) {
  std::vector<std::array<bool, 2>> isRecognised(model.edges.size(), {false, false});
  for (const ModelFace& face : model.faces) {
    for (const auto& loop : face.loops) {
      for (const ModelUse& use : loop)
        isRecognised[use.edge][use.forward ? 0 : 1] = face.patch < recognisedCount;
    }
  }
  std::vector<std::int32_t> loose;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const ModelFace& face = model.faces[f];
    if (face.surface.kind == CarrierKind::Facet) continue;
    const auto isOff = [&](const ModelUse& use) {
      const ModelEdge& edge = model.edges[use.edge];
      const double allowed =
          isRecognised[use.edge][0] && isRecognised[use.edge][1] ? tolerance : kKernelTolerance;
      return edge.tolerance > allowed && largestGap(edge.curve, face.surface) > allowed;
    };
    const bool isLoose = std::any_of(face.loops.begin(), face.loops.end(), [&](const auto& loop) {
      return std::any_of(loop.begin(), loop.end(), isOff);
    });
    if (isLoose) loose.push_back(static_cast<std::int32_t>(f));
  }
  return loose;
}

}  // namespace swept::step
