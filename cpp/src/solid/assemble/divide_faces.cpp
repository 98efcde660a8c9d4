// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/divide_faces.h"

#include <BOPAlgo_BuilderFace.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BOPTools_AlgoTools2D.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "solid/assemble/fitted_edge.h"

namespace swept::step {
namespace {

// Gives the vertices of edges a larger tolerance, until it is destroyed.
class LargeVertices {
 public:
  LargeVertices(const TopTools_ListOfShape& edges, double tolerance) {
    for (const TopoDS_Shape& edge : edges) {
      for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next()) {
        const auto vertex = Handle(BRep_TVertex)::DownCast(it.Current().TShape());
        if (vertex->Tolerance() >= tolerance) continue;
        before_.emplace_back(vertex, vertex->Tolerance());
        vertex->Tolerance(tolerance);
      }
    }
  }
  ~LargeVertices() {
    for (const auto& [vertex, tolerance] : before_) vertex->Tolerance(tolerance);
  }
  LargeVertices(const LargeVertices&) = delete;
  LargeVertices& operator=(const LargeVertices&) = delete;

 private:
  std::vector<std::pair<Handle(BRep_TVertex), double>> before_;
};

class Divider {
 public:
  Divider(const std::vector<TopoDS_Face>& faces, double near)
      : faces_(faces), least_(joiningDistance(faces, near)) {
    TopTools_IndexedMapOfShape found;
    for (const TopoDS_Face& face : faces) {
      TopExp::MapShapes(face, TopAbs_EDGE, edges_);
      TopExp::MapShapes(face, TopAbs_VERTEX, found);
    }
    for (int i = 1; i <= found.Extent(); ++i) {
      vertices_.push_back(TopoDS::Vertex(found(i)));
      near_.push_back(2 * BRep_Tool::Tolerance(vertices_.back()));
    }
    inner_.resize(faces.size());
  }

  void add(const SweptSection& section) {
    double from, to;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(section.edge, from, to);
    const TopoDS_Vertex first = vertexAt(curve->Value(from)), last = vertexAt(curve->Value(to));
    if (first.IsSame(last) && curve->Value((from + to) / 2).Distance(curve->Value(from)) < least_)
      return;
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, curve, Precision::Confusion());
    builder_.Add(edge, first.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, last.Oriented(TopAbs_REVERSED));
    builder_.Range(edge, from, to);
    edges_.Add(edge);
    for (const int f : section.faces) {
      inner_[f].push_back(edge);
      const Handle(Geom2d_Curve) on = BRep_Tool::CurveOnSurface(section.edge, faces_[f], from, to);
      if (!on.IsNull()) builder_.UpdateEdge(edge, on, faces_[f], Precision::Confusion());
    }
  }

  TopoDS_Shape divide() {
    splitEdges();
    joinEdges();
    TopoDS_Compound result;
    builder_.MakeCompound(result);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      try {
        if (divide(f, result)) continue;
      } catch (const Standard_Failure&) {
        // As if the kernel had reported an error.
      }
      builder_.Add(result, faces_[f]);
    }
    return result;
  }

 private:
  // Returns the vertex at the point: an existing one, if it is near.
  TopoDS_Vertex vertexAt(const gp_Pnt& p) {
    double nearest = HUGE_VAL;
    const TopoDS_Vertex* found = nullptr;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const double distance = BRep_Tool::Pnt(vertices_[i]).Distance(p);
      if (distance >= nearest || distance > std::max(least_, near_[i])) continue;
      nearest = distance;
      found = &vertices_[i];
    }
    if (found != nullptr) {
      builder_.UpdateVertex(*found, nearest + Precision::Confusion());
      return *found;
    }
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, p, Precision::Confusion());
    vertices_.push_back(vertex);
    near_.push_back(least_);
    return vertex;
  }

  // Cuts all edges at the vertices that lie on them.
  void splitEdges() {
    parts_.resize(edges_.Extent() + 1);
    for (int e = 1; e <= edges_.Extent(); ++e) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges_(e));
      if (BRep_Tool::Degenerated(edge)) continue;
      const double near = std::max(least_, 2 * BRep_Tool::Tolerance(edge));
      Bnd_Box box;
      BRepBndLib::Add(edge, box);
      box.Enlarge(near);
      double from, to;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
      const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
      std::vector<std::pair<double, TopoDS_Vertex>> cuts;
      for (const TopoDS_Vertex& vertex : vertices_) {
        const gp_Pnt p = BRep_Tool::Pnt(vertex);
        if (box.IsOut(p) || vertex.IsSame(first) || vertex.IsSame(last)) continue;
        const GeomAPI_ProjectPointOnCurve foot(p, curve, from, to);
        if (foot.NbPoints() == 0 || foot.LowerDistance() > near) continue;
        cuts.emplace_back(foot.LowerDistanceParameter(), vertex);
        builder_.UpdateVertex(vertex, foot.LowerDistance() + Precision::Confusion());
      }
      if (cuts.empty()) continue;
      std::sort(cuts.begin(), cuts.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      double at = from;
      TopoDS_Vertex vertex = first;
      const auto isShort = [&](double t, double u) {
        constexpr double kShortestPart = 1e-6;  // mm; two vertices may lie at one place
        return curve->Value(t).Distance(curve->Value(u)) < kShortestPart;
      };
      cuts.erase(std::remove_if(cuts.begin(), cuts.end(),
                                [&](const auto& cut) { return isShort(cut.first, to); }),
                 cuts.end());
      cuts.emplace_back(to, last);
      for (const auto& [next, end] : cuts) {
        if (next != to && isShort(at, next)) continue;
        TopoDS_Edge part;
        BOPTools_AlgoTools::MakeSplitEdge(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)),
                                          TopoDS::Vertex(vertex.Oriented(TopAbs_FORWARD)), at,
                                          TopoDS::Vertex(end.Oriented(TopAbs_REVERSED)), next,
                                          part);
        parts_[e].push_back(part);
        at = next;
        vertex = end;
      }
    }
  }

  // Replaces edges by others between the same vertices, if they are so near that nothing
  // lies between them.
  void joinEdges() {
    TopTools_IndexedMapOfShape vertices;
    std::map<std::pair<int, int>, std::vector<TopoDS_Edge>> kept;
    for (int e = 1; e <= edges_.Extent(); ++e) {
      const TopoDS_Edge edge = TopoDS::Edge(edges_(e).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge)) continue;
      if (parts_[e].empty()) parts_[e].push_back(edge);
      for (TopoDS_Edge& part : parts_[e]) {
        const int first = vertices.Add(TopExp::FirstVertex(part));
        const int last = vertices.Add(TopExp::LastVertex(part));
        if (first == last) continue;
        auto& others = kept[std::minmax(first, last)];
        const auto same = std::find_if(others.begin(), others.end(),
                                       [&](TopoDS_Edge& other) { return join(part, other); });
        if (same == others.end()) {
          others.push_back(part);
          continue;
        }
        const bool isReversed = vertices.FindIndex(TopExp::FirstVertex(*same)) != first;
        replacedBy_[same->TShape().get()].push_back(part);
        part = TopoDS::Edge(same->Oriented(isReversed ? TopAbs_REVERSED : TopAbs_FORWARD));
      }
    }
  }

  // Returns whether an edge lies at another one, whose tolerance then contains it.
  bool join(const TopoDS_Edge& edge, TopoDS_Edge& other) const {
    constexpr int kPoints = 8;
    constexpr double kNarrow = 0.05;  // times the distance of the vertices
    double from, to, otherFrom, otherTo, largest = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    const Handle(Geom_Curve) along = BRep_Tool::Curve(other, otherFrom, otherTo);
    const double most = std::min(least_, kNarrow * curve->Value(from).Distance(curve->Value(to)));
    for (int i = 1; i < kPoints; ++i) {
      const gp_Pnt p = curve->Value(from + (to - from) * i / kPoints);
      const GeomAPI_ProjectPointOnCurve foot(p, along, otherFrom, otherTo);
      if (foot.NbPoints() == 0 || foot.LowerDistance() > most) return false;
      largest = std::max(largest, foot.LowerDistance());
    }
    builder_.UpdateEdge(other, largest + Precision::Confusion());
    return true;
  }

  // Returns the parts of an edge, as it is turned.
  std::vector<TopoDS_Edge> partsOf(const TopoDS_Shape& edge) const {
    std::vector<TopoDS_Edge> parts = parts_[edges_.FindIndex(edge)];
    if (parts.empty()) return {TopoDS::Edge(edge)};  // degenerated
    for (TopoDS_Edge& part : parts)
      part.Orientation(TopAbs::Compose(part.Orientation(), edge.Orientation()));
    return parts;
  }

  void addCurveOn(const TopoDS_Face& face, const TopoDS_Edge& edge) const {
    double from, to;
    if (!BRep_Tool::CurveOnSurface(edge, face, from, to).IsNull()) return;
    // The kernel is quick and exact on surfaces with formulas. On splines it takes up to 0.1 s.
    const auto replaced = replacedBy_.find(edge.TShape().get());
    const bool isSpline = BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_BSplineSurface));
    if (isSpline && replaced != replacedBy_.end()) {
      const double far = 2 * BRep_Tool::Tolerance(edge);
      for (const TopoDS_Edge& twin : replaced->second) {
        if (addCurveOfTwin(face, edge, twin, far)) return;
      }
    }
    BOPTools_AlgoTools2D::BuildPCurveForEdgeOnFace(edge, face, context_);
  }

  bool divide(std::size_t f, TopoDS_Compound& to) {
    const TopoDS_Face face = TopoDS::Face(faces_[f].Oriented(TopAbs_FORWARD));
    TopTools_ListOfShape edges;
    TopTools_MapOfShape known;
    bool isCut = !inner_[f].empty();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      for (const TopoDS_Edge& part : partsOf(it.Current())) {
        isCut = isCut || !part.IsSame(it.Current());
        if (known.Add(part)) addCurveOn(face, part);
        edges.Append(part);
      }
    }
    if (!isCut) {
      builder_.Add(to, faces_[f]);
      return true;
    }
    for (const TopoDS_Edge& edge : inner_[f]) {
      for (const TopoDS_Edge& part : partsOf(edge)) {
        if (!known.Add(part)) continue;
        addCurveOn(face, part);
        edges.Append(part.Oriented(TopAbs_FORWARD));
        edges.Append(part.Oriented(TopAbs_REVERSED));
      }
    }
    const TopTools_ListOfShape pieces = piecesOf(face, edges);
    for (const TopoDS_Shape& piece : pieces)
      builder_.Add(to, piece.Oriented(faces_[f].Orientation()));
    return !pieces.IsEmpty();
  }

  // Returns the pieces into which edges divide a face. At a vertex, the kernel orders the edges by
  // their angles, which it measures at about the tolerance of the vertex. If two edges are tangent
  // to each other there, it may take the wrong one and not divide the face. Then the angles are
  // measured farther from the vertex.
  TopTools_ListOfShape piecesOf(const TopoDS_Face& face, const TopTools_ListOfShape& edges) const {
    TopTools_ListOfShape pieces;
    for (const double from : {0.0, 1e-5, 1e-4, 1e-3}) {  // mm
      const LargeVertices larger(edges, from);
      BOPAlgo_BuilderFace maker;
      maker.SetFace(face);
      maker.SetShapes(edges);
      maker.SetContext(context_);
      maker.SetAvoidInternalShapes(Standard_True);  // no edges that do not divide the face
      maker.Perform();
      if (maker.HasErrors()) continue;
      if (pieces.IsEmpty()) pieces = maker.Areas();
      if (std::none_of(maker.Areas().begin(), maker.Areas().end(), hasEdgeInside))
        return maker.Areas();
    }
    return pieces;
  }

  // Returns whether the face is on both sides of an edge that is no seam.
  static bool hasEdgeInside(const TopoDS_Shape& face) {
    TopTools_MapOfShape seen;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (!seen.Add(edge) && !BRep_Tool::IsClosed(edge, TopoDS::Face(face))) return true;
    }
    return false;
  }

  const std::vector<TopoDS_Face>& faces_;
  const BRep_Builder builder_{};
  const Handle(IntTools_Context) context_ = new IntTools_Context;
  TopTools_IndexedMapOfShape edges_;
  std::vector<std::vector<TopoDS_Edge>> parts_;  // by edge; empty if it is degenerated
  std::vector<TopoDS_Vertex> vertices_;
  std::map<const void*, std::vector<TopoDS_Edge>> replacedBy_;
  double least_;
  std::vector<double> near_;                     // by vertex: twice its tolerance
  std::vector<std::vector<TopoDS_Edge>> inner_;  // by face
};

}  // namespace

double joiningDistance(const std::vector<TopoDS_Face>& faces, double near) {
  for (const TopoDS_Face& face : faces) {
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
      near = std::clamp(2 * BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())), near, kMaxNear);
  }
  return near;
}

TopoDS_Shape divideFaces(const std::vector<TopoDS_Face>& faces,
                         const std::vector<SweptSection>& sections, double near) {
  // Dividing raises tolerances of edges and vertices, which the copies do not share.
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Face& face : faces) builder.Add(all, face);
  BRepBuilderAPI_Copy copy(all, Standard_False);
  std::vector<TopoDS_Face> copies;
  for (const TopoDS_Face& face : faces) copies.push_back(TopoDS::Face(copy.ModifiedShape(face)));
  Divider divider(copies, near);
  for (const SweptSection& section : sections) divider.add(section);
  return divider.divide();
}

}  // namespace swept::step
