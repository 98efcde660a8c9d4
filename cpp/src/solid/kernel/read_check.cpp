// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/read_check.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <sstream>
#include <utility>

#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/text/step_text.h"

namespace swept::step {
namespace {

// Returns a model of the curved faces only. Each has a shell of its own, so that the reader keeps
// their order. `from` receives their indices in `model`.
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

}  // namespace

std::vector<std::int32_t> ReadCheck::findUnreadable(const Model& model) {
  std::vector<std::int32_t> from;
  const Model part = curvedPart(model, from);
  if (from.empty()) return {};
  std::stringstream stream;
  writeStepText(part, stream, "curved", options_, run_);
  const std::string text = std::move(stream).str();
  // Only the data section is compared, since the header contains the time of writing.
  std::string data = text.substr(std::min(text.size(), text.find("DATA;")));
  if (data != lastText_) {
    answer_ = read(text, from.size());
    lastText_ = std::move(data);
  }
  std::vector<std::int32_t> bad;
  for (const std::int32_t i : answer_) bad.push_back(from[i]);
  return bad;
}

std::vector<std::int32_t> ReadCheck::read(const std::string& text, std::size_t count) {
  std::istringstream stream(text);
  const TopoDS_Shape shape = readStepText(stream, kernel_, run_);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  // If the reader has split faces, their order is lost; the later check of the whole file decides.
  if (faces.size() != count) return {};
  return findBadFaces(faces, run_, 0.3, 0.3);
}

}  // namespace swept::step
