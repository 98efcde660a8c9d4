// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/divide_faces.h"

#include <BOPAlgo_BuilderFace.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BOPTools_AlgoTools2D.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

namespace swept::step {
namespace {

/// mm: ends of sections within this distance from a vertex or an edge lie on it. Sections are
/// exact; edges of bodies from files are not.
constexpr double kMinNear = 1e-4;

class Divider {
 public:
  explicit Divider(const std::vector<TopoDS_Face>& faces) : faces_(faces) {
    TopTools_IndexedMapOfShape found;
    for (const TopoDS_Face& face : faces) {
      TopExp::MapShapes(face, TopAbs_EDGE, edges_);
      TopExp::MapShapes(face, TopAbs_VERTEX, found);
    }
    for (int i = 1; i <= found.Extent(); ++i) {
      vertices_.push_back(TopoDS::Vertex(found(i)));
      near_.push_back(std::max(kMinNear, 2 * BRep_Tool::Tolerance(vertices_.back())));
    }
    inner_.resize(faces.size());
  }

  void add(const SweptSection& section) {
    double from, to;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(section.edge, from, to);
    const TopoDS_Vertex first = vertexAt(curve->Value(from)), last = vertexAt(curve->Value(to));
    if (first.IsSame(last) && curve->Value((from + to) / 2).Distance(curve->Value(from)) < kMinNear)
      return;
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, curve, Precision::Confusion());
    builder_.Add(edge, first.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, last.Oriented(TopAbs_REVERSED));
    builder_.Range(edge, from, to);
    edges_.Add(edge);
    for (const int f : section.faces) inner_[f].push_back(edge);
  }

  TopoDS_Shape divide() {
    splitEdges();
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
      if (distance >= nearest || distance > near_[i]) continue;
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
    near_.push_back(kMinNear);
    added_.push_back(vertex);
    return vertex;
  }

  // Cuts all edges at the new vertices that lie on them.
  void splitEdges() {
    parts_.resize(edges_.Extent() + 1);
    for (int e = 1; e <= edges_.Extent(); ++e) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges_(e));
      if (BRep_Tool::Degenerated(edge)) continue;
      const double near = std::max(kMinNear, 2 * BRep_Tool::Tolerance(edge));
      Bnd_Box box;
      BRepBndLib::Add(edge, box);
      box.Enlarge(near);
      double from, to;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
      const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
      std::vector<std::pair<double, TopoDS_Vertex>> cuts;
      for (const TopoDS_Vertex& vertex : added_) {
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
      cuts.emplace_back(to, last);
      for (const auto& [next, end] : cuts) {
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

  // Returns the parts of an edge, in its direction.
  std::vector<TopoDS_Edge> partsOf(const TopoDS_Shape& edge) const {
    const int e = edges_.FindIndex(edge);
    if (!parts_[e].empty()) return parts_[e];
    return {TopoDS::Edge(edges_(e).Oriented(TopAbs_FORWARD))};
  }

  bool divide(std::size_t f, TopoDS_Compound& to) {
    const TopoDS_Face face = TopoDS::Face(faces_[f].Oriented(TopAbs_FORWARD));
    TopTools_ListOfShape edges;
    bool isCut = !inner_[f].empty();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const std::vector<TopoDS_Edge> parts = partsOf(it.Current());
      isCut = isCut || parts.size() > 1;
      for (const TopoDS_Edge& part : parts) edges.Append(part.Oriented(it.Current().Orientation()));
    }
    if (!isCut) {
      builder_.Add(to, faces_[f]);
      return true;
    }
    for (const TopoDS_Edge& edge : inner_[f]) {
      for (const TopoDS_Edge& part : partsOf(edge)) {
        BOPTools_AlgoTools2D::BuildPCurveForEdgeOnFace(part, face, context_);
        edges.Append(part.Oriented(TopAbs_FORWARD));
        edges.Append(part.Oriented(TopAbs_REVERSED));
      }
    }
    BOPAlgo_BuilderFace maker;
    maker.SetFace(face);
    maker.SetShapes(edges);
    maker.SetContext(context_);
    maker.Perform();
    if (maker.HasErrors()) return false;
    for (const TopoDS_Shape& piece : maker.Areas())
      builder_.Add(to, piece.Oriented(faces_[f].Orientation()));
    return true;
  }

  const std::vector<TopoDS_Face>& faces_;
  const BRep_Builder builder_{};
  const Handle(IntTools_Context) context_ = new IntTools_Context;
  TopTools_IndexedMapOfShape edges_;
  std::vector<std::vector<TopoDS_Edge>> parts_;  // by edge; empty if it is not cut
  std::vector<TopoDS_Vertex> vertices_, added_;
  std::vector<double> near_;  // by vertex: a section that ends at this distance ends there
  std::vector<std::vector<TopoDS_Edge>> inner_;  // by face
};

}  // namespace

TopoDS_Shape divideFaces(const std::vector<TopoDS_Face>& faces,
                         const std::vector<SweptSection>& sections) {
  Divider divider(faces);
  for (const SweptSection& section : sections) divider.add(section);
  return divider.divide();
}

}  // namespace swept::step
