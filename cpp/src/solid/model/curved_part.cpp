// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/curved_part.h"

namespace swept::step {

Model curvedPart(const Model& model, std::vector<std::int32_t>& from) {
  Model part;
  std::vector<std::int32_t> vertexId(model.vertices.size(), -1), edgeId(model.edges.size(), -1);
  const auto vertex = [&](std::int32_t v) {
    if (vertexId[v] < 0) {
      vertexId[v] = static_cast<std::int32_t>(part.vertices.size());
      part.vertices.push_back(model.vertices[v]);
    }
    return vertexId[v];
  };
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (model.faces[f].surface.isPlanar()) continue;
    from.push_back(static_cast<std::int32_t>(f));
    part.faces.push_back(model.faces[f]);
    const auto shell = static_cast<std::int32_t>(part.shellOwner.size());
    part.faces.back().shell = shell;
    part.shellOwner.push_back(shell);
    for (auto& loop : part.faces.back().loops) {
      for (ModelUse& use : loop) {
        if (edgeId[use.edge] < 0) {
          edgeId[use.edge] = static_cast<std::int32_t>(part.edges.size());
          part.edges.push_back(model.edges[use.edge]);
          part.edges.back().start = vertex(model.edges[use.edge].start);
          part.edges.back().end = vertex(model.edges[use.edge].end);
        }
        use.edge = edgeId[use.edge];
      }
    }
  }
  return part;
}

}  // namespace swept::step
