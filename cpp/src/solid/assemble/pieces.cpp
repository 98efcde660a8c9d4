// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/pieces.h"

#include <BOPAlgo_MakerVolume.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace swept::step {
namespace {

/// A piece with fewer samples is judged by its neighbours.
constexpr int kMinSamples = 3;

}  // namespace

Pieces::Pieces(const TopoDS_Shape& fused, const Sides& sides) : fused_(fused), sides_(sides) {
  TopExp::MapShapes(fused, TopAbs_FACE, faces_);
  TopExp::MapShapesAndAncestors(fused, TopAbs_EDGE, TopAbs_FACE, edges_);
  votes_.resize(faces_.Extent() + 1);
  parallelBlocks(faces_.Extent(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin + 1; f <= end; ++f) {
      // Few points of a fine grid lie in a piece that fills little of its range of parameters.
      for (const int count : {9, 100, 1000}) {
        votes_[f] = {};
        for (const FaceSample& sample : samplesOf(face(static_cast<int>(f)), count))
          sides_.vote(sample, votes_[f]);
        if (votes_[f].count() >= kMinSamples) break;
      }
    }
  });
  choose();
}

std::vector<TopoDS_Face> Pieces::aroundCells() const {
  BOPAlgo_MakerVolume maker;
  TopTools_ListOfShape arguments;
  arguments.Append(fused_);
  maker.SetArguments(arguments);
  maker.SetIntersect(Standard_False);
  maker.SetAvoidInternalShapes(Standard_True);
  maker.SetRunParallel(Standard_True);
  maker.Perform();
  if (maker.HasErrors()) return {};
  std::vector<std::vector<TopoDS_Shape>> uses(faces_.Extent() + 1);
  for (TopExp_Explorer cell(maker.Shape(), TopAbs_SOLID); cell.More(); cell.Next()) {
    if (!isInside(cell.Current())) continue;
    for (TopExp_Explorer it(cell.Current(), TopAbs_FACE); it.More(); it.Next())
      uses[faces_.FindIndex(it.Current())].push_back(it.Current());
  }
  std::vector<TopoDS_Face> result;
  for (const auto& use : uses) {
    if (use.size() == 1) result.push_back(TopoDS::Face(use.front()));
  }
  return result;
}

std::vector<TopoDS_Face> Pieces::chosen() const {
  std::vector<TopoDS_Face> result;
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (!chosen_[f]) continue;
    const bool isTurned = votes_[f].before > votes_[f].behind;
    result.push_back(TopoDS::Face(isTurned ? faces_(f).Reversed() : faces_(f)));
  }
  return result;
}

TopTools_ListOfShape Pieces::looseNear(const std::vector<TopoDS_Edge>& edges) const {
  TopTools_MapOfShape loose;
  for (const TopoDS_Edge& edge : edges) {
    for (const TopoDS_Shape& piece : edges_.FindFromKey(edge)) loose.Add(piece);
  }
  const BRep_Builder builder;
  TopoDS_Compound others;
  builder.MakeCompound(others);
  TopTools_ListOfShape result;
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (loose.Contains(faces_(f))) {
      result.Append(faces_(f));
    } else {
      builder.Add(others, faces_(f));
    }
  }
  result.Append(others);
  return result;
}

std::vector<TopoDS_Edge> Pieces::openEdges() const {
  std::vector<TopoDS_Edge> open;
  for (int e = 1; e <= edges_.Extent(); ++e) {
    if (uses(e) % 2 == 1) open.push_back(TopoDS::Edge(edges_.FindKey(e)));
  }
  return open;
}

bool Pieces::isInside(const TopoDS_Shape& cell) const {
  int inside = 0, count = 0;
  for (TopExp_Explorer it(cell, TopAbs_FACE); it.More(); it.Next()) {
    const int f = faces_.FindIndex(it.Current());
    const Votes& votes = votes_[f];
    const bool isBehind = it.Current().Orientation() == faces_(f).Orientation();
    inside += votes.both + (isBehind ? votes.behind : votes.before);
    count += votes.count();
  }
  return 2 * inside > count;
}

int Pieces::uses(int e, int flipped) const {
  const TopoDS_Edge& edge = TopoDS::Edge(edges_.FindKey(e));
  if (BRep_Tool::Degenerated(edge)) return 0;
  int count = 0;
  TopTools_MapOfShape seen;
  for (const TopoDS_Shape& owner : edges_(e)) {
    const int f = faces_.FindIndex(owner);
    const bool isChosen = (chosen_[f] != 0) != (f == flipped);
    if (seen.Add(owner) && isChosen) count += BRep_Tool::IsClosed(edge, face(f)) ? 2 : 1;
  }
  return count;
}

int Pieces::openEdgesOf(int f, bool isFlipped) const {
  int count = 0;
  for (TopExp_Explorer it(faces_(f), TopAbs_EDGE); it.More(); it.Next())
    count += uses(edges_.FindIndex(it.Current()), isFlipped ? f : 0) % 2;
  return count;
}

void Pieces::choose() {
  constexpr int kMaxChanges = 200;
  chosen_.assign(faces_.Extent() + 1, 0);
  for (int f = 1; f <= faces_.Extent(); ++f) {
    const Votes& votes = votes_[f];
    chosen_[f] = std::max(votes.behind, votes.before) > votes.both + votes.none;
  }
  for (int changes = 0, before = -1; changes != before && changes < kMaxChanges;) {
    before = changes;
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const int open = openEdgesOf(f, false);
      if (open == 0) continue;
      const int left = openEdgesOf(f, true);
      if (left >= open || (left > 0 && isUnanimous(f) && !isNarrow(f))) continue;
      chosen_[f] = !chosen_[f];
      ++changes;
    }
  }
}

bool Pieces::isUnanimous(int f) const {
  const Votes& votes = votes_[f];
  const int most = std::max({votes.behind, votes.before, votes.both + votes.none});
  return most == votes.count() && most >= kMinSamples;
}

bool Pieces::isNarrow(int f) const {
  constexpr double kNarrow = 30;  // times the distance of the samples
  GProp_GProps area, length;
  BRepGProp::SurfaceProperties(faces_(f), area);
  BRepGProp::LinearProperties(faces_(f), length);
  return 2 * std::abs(area.Mass()) < kNarrow * sides_.distance() * length.Mass();
}

bool Pieces::areCertain() const {
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (chosen_[f] && !isUnanimous(f) && !isNarrow(f)) return false;
  }
  return true;
}

}  // namespace swept::step
