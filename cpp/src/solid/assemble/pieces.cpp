// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/pieces.h"

#include <BOPAlgo_MakerVolume.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "base/union_find.h"

namespace swept::step {
namespace {

/// A piece with fewer samples is judged by its neighbours.
constexpr int kMinSamples = 3;

}  // namespace

Pieces::Pieces(const TopoDS_Shape& fused, const Sides& sides, const TopTools_MapOfShape& unlikely)
    : fused_(fused), sides_(sides) {
  TopExp::MapShapes(fused, TopAbs_FACE, faces_);
  TopExp::MapShapesAndAncestors(fused, TopAbs_EDGE, TopAbs_FACE, edges_);
  votes_.resize(faces_.Extent() + 1);
  area_.resize(votes_.size());
  narrow_.resize(votes_.size());
  width_.resize(votes_.size());
  parallelBlocks(faces_.Extent(), 1, [&](std::size_t begin, std::size_t end) {
    for (int f = static_cast<int>(begin) + 1; f <= static_cast<int>(end); ++f) {
      // Few points of a fine grid lie in a piece that fills little of its range of parameters.
      const TopoDS_Face piece = face(f);
      for (const int count : {9, 100, 1000}) {
        votes_[f] = votesOf(samplesOf(piece, count));
        if (votes_[f].count() >= kMinSamples) break;
      }
      measure(f);
      if (isUnanimous(f) || votes_[f].count() < kMinSamples) continue;
      // Next to the border, another face may lie between a sample and the piece.
      const Votes inner = votesOf(samplesInside(piece));
      if (inner.count() >= kMinSamples) votes_[f] = inner;
    }
  });
  choose(unlikely);
}

Votes Pieces::votesOf(const std::vector<FaceSample>& samples) const {
  Votes votes;
  for (const FaceSample& sample : samples) sides_.vote(sample, votes);
  return votes;
}

std::vector<FaceSample> Pieces::samplesInside(const TopoDS_Face& piece) const {
  constexpr int kSamples = 100;
  constexpr double kBorder = 10;  // times the distance of the samples
  std::vector<FaceSample> samples = samplesOf(piece, kSamples);
  const auto isAtBorder = [&](const FaceSample& sample) {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(sample.point);
    for (TopExp_Explorer edge(piece, TopAbs_EDGE); edge.More(); edge.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()))) continue;
      const BRepExtrema_DistShapeShape distance(vertex, edge.Current());
      if (distance.IsDone() && distance.Value() < kBorder * sides_.distance()) return true;
    }
    return false;
  };
  samples.erase(std::remove_if(samples.begin(), samples.end(), isAtBorder), samples.end());
  return samples;
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

std::vector<TopoDS_Face> Pieces::turnedFaces(const std::vector<char>& pieces) const {
  std::vector<TopoDS_Face> result;
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (!pieces[f]) continue;
    result.push_back(TopoDS::Face(turned_[f] ? faces_(f).Reversed() : faces_(f)));
  }
  return result;
}

std::vector<TopoDS_Face> Pieces::certain() const {
  std::vector<char> kept = chosen_;
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (int e = 1; e <= edges_.Extent(); ++e) {
      const int count = uses(e, kept);
      if (count == 0 || count == 2) continue;
      for (const TopoDS_Shape& owner : edges_(e)) {
        const int f = faces_.FindIndex(owner);
        if (!kept[f] || (count == 1 && !isDoubtful(f))) continue;
        kept[f] = 0;
        isChanged = true;
      }
    }
  }
  return turnedFaces(kept);
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

int Pieces::uses(int e, const std::vector<char>& pieces) const {
  const TopoDS_Edge& edge = TopoDS::Edge(edges_.FindKey(e));
  if (BRep_Tool::Degenerated(edge)) return 0;
  int count = 0;
  TopTools_MapOfShape seen;
  for (const TopoDS_Shape& owner : edges_(e)) {
    const int f = faces_.FindIndex(owner);
    if (seen.Add(owner) && pieces[f]) count += BRep_Tool::IsClosed(edge, face(f)) ? 2 : 1;
  }
  return count;
}

Chain Pieces::borderOf(int f) const {
  TopTools_MapOfShape seen;
  Chain border;
  for (TopExp_Explorer it(faces_(f), TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!seen.Add(edge) || BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face(f)))
      continue;
    border.push_back(edges_.FindIndex(edge));
  }
  std::sort(border.begin(), border.end());
  return border;
}

void Pieces::choose(const TopTools_MapOfShape& unlikely) {
  chosen_.assign(faces_.Extent() + 1, 0);
  turned_.assign(faces_.Extent() + 1, 0);
  std::vector<std::pair<double, int>> costs;  // of inverting a choice
  for (int f = 1; f <= faces_.Extent(); ++f) {
    const Votes& votes = votes_[f];
    const int yes = std::max(votes.behind, votes.before), no = votes.both + votes.none;
    const bool isUnlikely = unlikely.Contains(faces_(f));
    chosen_[f] = hasSide(f) && !isUnlikely;
    turned_[f] = votes.before > votes.behind;
    if (isDoubtful(f) || isUnlikely) costs.emplace_back(area_[f] * (1 + std::abs(yes - no)), f);
  }
  std::sort(costs.begin(), costs.end());
  for (const auto& [cost, f] : costs) doubtful_.push_back(f);
  byVotes_ = chosen_;
  closeWith(doubtful_);
  dropBubbles(doubtful_);
  orient();
}

void Pieces::fillGrooves() {
  constexpr double kThin = 30;  // times the detail
  std::vector<std::pair<double, int>> thin;
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (!isDoubtful(f) && width_[f] < kThin * sides_.detail()) thin.emplace_back(width_[f], f);
  }
  std::sort(thin.begin(), thin.end());
  for (const auto& [width, f] : thin) doubtful_.push_back(f);
  closeWith(doubtful_);
  for (const int f : doubtful_) {
    if (chosen_[f] != byVotes_[f] && !narrow_[f]) filled_ = std::max(filled_, width_[f]);
  }
  orient();
}

void Pieces::closeWith(const std::vector<int>& doubtful) {
  Chain open;
  for (int e = 1; e <= edges_.Extent(); ++e) {
    if (uses(e) % 2 == 1) open.push_back(e);
  }
  if (open.empty()) return;
  ChainBasis basis;
  for (const int f : doubtful) basis.add(borderOf(f), f);
  for (Chain& border : connectedParts(open)) {
    const std::vector<int> inverted = basis.reduce(border);
    if (!border.empty()) continue;
    for (const int f : inverted) chosen_[f] = !chosen_[f];
  }
}

std::vector<Chain> Pieces::connectedParts(const Chain& edges) const {
  TopTools_IndexedMapOfShape vertices;
  const auto endsOf = [&](int e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges_.FindKey(e));
    return std::array<int, 2>{vertices.Add(TopExp::FirstVertex(edge)) - 1,
                              vertices.Add(TopExp::LastVertex(edge)) - 1};
  };
  for (const int e : edges) endsOf(e);
  std::vector<int> groups = singleSets<int>(vertices.Extent());
  for (const int e : edges) {
    const auto [a, b] = endsOf(e);
    unite(groups, a, b);
  }
  std::map<int, Chain> parts;
  for (const int e : edges) parts[findRoot(groups, endsOf(e)[0])].push_back(e);
  std::vector<Chain> result;
  for (auto& [group, part] : parts) result.push_back(std::move(part));
  return result;
}

void Pieces::dropBubbles(const std::vector<int>& doubtful) {
  ChainBasis basis;
  for (const int f : doubtful) {
    if (!chosen_[f] || !narrow_[f]) continue;
    const std::vector<int> others = basis.add(borderOf(f), f);
    const bool isBubble = !others.empty() && std::all_of(others.begin(), others.end(),
                                                         [&](int g) { return chosen_[g] != 0; });
    if (!isBubble) continue;
    chosen_[f] = 0;
    for (const int g : others) chosen_[g] = 0;
  }
}

void Pieces::orient() {
  std::vector<char> isKnown(chosen_.size());
  for (int f = 1; f <= faces_.Extent(); ++f)
    isKnown[f] = chosen_[f] && hasSide(f) && (isUnanimous(f) || !narrow_[f]);
  const auto orientFrom = [&](int f, int e) {
    if (uses(e) != 2) return;
    for (const TopoDS_Shape& owner : edges_(e)) {
      const int g = faces_.FindIndex(owner);
      if (g == f || !chosen_[g] || !isKnown[g]) continue;
      if (orientationIn(f, e) == orientationIn(g, e)) turned_[f] = !turned_[f];
      isKnown[f] = 1;
      return;
    }
  };
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (int f = 1; f <= faces_.Extent(); ++f) {
      if (!chosen_[f] || isKnown[f]) continue;
      for (const int e : borderOf(f)) {
        if (!isKnown[f]) orientFrom(f, e);
      }
      isChanged = isChanged || isKnown[f];
    }
  }
}

TopAbs_Orientation Pieces::orientationIn(int f, int e) const {
  const TopoDS_Shape turned = turned_[f] ? faces_(f).Reversed() : faces_(f);
  for (TopExp_Explorer it(turned, TopAbs_EDGE); it.More(); it.Next()) {
    if (it.Current().IsSame(edges_.FindKey(e))) return it.Current().Orientation();
  }
  return TopAbs_EXTERNAL;
}

bool Pieces::hasSide(int f) const {
  const Votes& votes = votes_[f];
  return std::max(votes.behind, votes.before) > votes.both + votes.none;
}

bool Pieces::isUnanimous(int f) const {
  const Votes& votes = votes_[f];
  const int most = std::max({votes.behind, votes.before, votes.both + votes.none});
  return most == votes.count() && most >= kMinSamples;
}

void Pieces::measure(int f) {
  constexpr double kNarrow = 30;  // times the distance of the samples
  GProp_GProps area, length;
  BRepGProp::SurfaceProperties(faces_(f), area);
  BRepGProp::LinearProperties(faces_(f), length);
  area_[f] = std::abs(area.Mass());
  width_[f] = 2 * area_[f] / length.Mass();
  narrow_[f] = width_[f] < kNarrow * sides_.distance();
}

bool Pieces::areCertain() const {
  for (int f = 1; f <= faces_.Extent(); ++f) {
    if (chosen_[f] && !isUnanimous(f) && !narrow_[f]) return false;
  }
  return true;
}

}  // namespace swept::step
