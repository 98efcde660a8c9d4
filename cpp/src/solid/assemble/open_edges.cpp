// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/open_edges.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace swept::step {

bool keepMarked(std::vector<TopoDS_Face>& faces, const std::vector<char>& isMarked) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (isMarked[f]) faces[count++] = faces[f];
  }
  const bool isLess = count < faces.size();
  faces.resize(count);
  return isLess;
}

std::vector<OpenEdge> openEdgesOf(std::vector<TopoDS_Face>& faces) {
  std::vector<OpenEdge> open;
  for (bool areFit = false; !areFit;) {
    TopTools_IndexedMapOfShape edges;
    std::vector<std::vector<OpenEdge>> uses;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (TopExp_Explorer it(faces[f], TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        const auto index = static_cast<std::size_t>(edges.Add(edge));
        if (index > uses.size()) uses.emplace_back();
        uses[index - 1].push_back({TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), static_cast<int>(f),
                                   edge.Orientation() == TopAbs_FORWARD});
      }
    }
    open.clear();
    std::vector<char> isFit(faces.size(), 1);
    for (const std::vector<OpenEdge>& of : uses) {
      if (of.size() == 1) {
        open.push_back(of.front());
      } else if (of.size() > 2 || of[0].isForward == of[1].isForward) {
        for (const OpenEdge& use : of) isFit[use.face] = 0;
      }
    }
    areFit = !keepMarked(faces, isFit);
  }
  return open;
}

}  // namespace swept::step
