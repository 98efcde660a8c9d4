// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/exact_sections.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solid/assemble/interpolate_curve.h"

namespace swept::step {
namespace {

/// Sine of the angle between two faces. If they are closer to tangent, the edge stays as it is.
constexpr double kMinCrossing = 0.02;
/// mm: points of an edge that move farther belong to another intersection.
constexpr double kMaxMove = 1e-3;

// A face along one of its edges.
class FaceAtEdge {
 public:
  FaceAtEdge(const TopoDS_Edge& edge, const TopoDS_Face& face)
      : surface_(BRep_Tool::Surface(face)), foot_(new ShapeAnalysis_Surface(surface_)) {
    double from, to;
    curve_ = BRep_Tool::CurveOnSurface(edge, face, from, to);
  }
  bool isKnown() const { return !curve_.IsNull(); }
  bool isSpline() const { return !Handle(Geom2d_BSplineCurve)::DownCast(curve_).IsNull(); }

  gp_Pnt at(const gp_Pnt2d& p) const { return surface_->Value(p.X(), p.Y()); }
  /// Starts at the point of the edge with this parameter.
  void start(double t) { at_ = curve_->Value(t); }
  /// Returns the distance of the point from the surface, along the normal there.
  double distance(const gp_Pnt& p, gp_Vec& normal) {
    at_ = foot_->NextValueOfUV(at_, p, Precision::Confusion());
    gp_Pnt foot;
    surface_->D1(at_.X(), at_.Y(), foot, alongU_, alongV_);
    normal = alongU_.Crossed(alongV_);
    if (normal.Magnitude() > gp::Resolution()) normal.Normalize();
    return gp_Vec(p, foot).Dot(normal);
  }
  /// Returns the parameters of the last foot point, and how they change along the tangent.
  std::pair<gp_Pnt2d, gp_Vec2d> parameters(const gp_Vec& tangent) const {
    return {at_, parametersAlong(tangent, alongU_, alongV_)};
  }

 private:
  Handle(Geom_Surface) surface_;
  Handle(ShapeAnalysis_Surface) foot_;
  Handle(Geom2d_Curve) curve_;
  gp_Pnt2d at_;
  gp_Vec alongU_, alongV_;
};

struct ExactSection {
  Handle(Geom_BSplineCurve) curve;
  std::array<Handle(Geom2d_BSplineCurve), 2> onSides;
};

class Section {
 public:
  Section(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b)
      : curve_(edge), sides_{FaceAtEdge(edge, a), FaceAtEdge(edge, b)} {}

  /// Returns nothing if the edge is a line or circle, or if the faces do not cross.
  std::optional<ExactSection> exact() {
    if (curve_.GetType() != GeomAbs_BSplineCurve || !sides_[0].isKnown() || !sides_[1].isKnown())
      return std::nullopt;
    constexpr int kPieces = 16, kRounds = 6;
    const double from = curve_.FirstParameter(), to = curve_.LastParameter();
    std::vector<double> parameters;
    for (int i = 0; i <= kPieces; ++i) parameters.push_back(from + (to - from) * i / kPieces);
    for (int round = 0; round < kRounds; ++round) {
      std::vector<CurvePoint> points;
      std::array<std::vector<CurvePoint2d>, 2> onSides;
      for (const double t : parameters) {
        const auto point = pointNear(t, curve_.Value(t));
        if (!point) return std::nullopt;
        points.push_back(*point);
        for (const int k : {0, 1}) {
          const auto [at, tangent] = sides_[k].parameters(point->tangent);
          onSides[k].push_back({at, tangent});
        }
      }
      std::vector<double> lengths;
      ExactSection result{interpolated(points, lengths), {}};
      for (const int k : {0, 1}) result.onSides[k] = interpolated(onSides[k], lengths);
      if (result.curve.IsNull() || result.onSides[0].IsNull() || result.onSides[1].IsNull())
        return std::nullopt;
      std::vector<double> finer;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        finer.push_back(parameters[i]);
        if (i + 1 == parameters.size()) break;
        const double t = (parameters[i] + parameters[i + 1]) / 2;
        if (!isExact(result, t, (lengths[i] + lengths[i + 1]) / 2)) finer.push_back(t);
      }
      if (finer.size() == parameters.size()) return result;
      parameters = std::move(finer);
    }
    return std::nullopt;
  }

 private:
  bool isExact(const ExactSection& section, double t, double length) {
    const gp_Pnt p = section.curve->Value(length);
    for (const int k : {0, 1}) {
      sides_[k].start(t);
      gp_Vec normal;
      if (std::abs(sides_[k].distance(p, normal)) > kCurveBound) return false;
      const gp_Pnt2d at = section.onSides[k]->Value(length);
      if (sides_[k].at(at).Distance(p) > kCurveBound) return false;
    }
    return true;
  }

  // Returns the point of both surfaces near p, and the tangent of the curve there.
  std::optional<CurvePoint> pointNear(double t, gp_Pnt p) {
    const gp_Pnt start = p;
    gp_Pnt unused;
    gp_Vec along;
    curve_.D1(t, unused, along);
    for (FaceAtEdge& side : sides_) side.start(t);
    for (int round = 0; round < 8; ++round) {
      gp_Vec n, m;
      const double toA = sides_[0].distance(p, n), toB = sides_[1].distance(p, m);
      gp_Vec tangent = n.Crossed(m);
      const double sine = tangent.Magnitude(), cosine = n.Dot(m);
      if (sine < kMinCrossing) return std::nullopt;
      if (std::max(std::abs(toA), std::abs(toB)) < 1e-3 * kCurveBound) {
        if (p.Distance(start) > kMaxMove) return std::nullopt;
        if (tangent.Dot(along) < 0) tangent.Reverse();
        return CurvePoint{p, tangent / sine};
      }
      // The shortest step to both tangent planes.
      const double square = sine * sine;
      p.Translate(n * ((toA - cosine * toB) / square) + m * ((toB - cosine * toA) / square));
    }
    return std::nullopt;
  }

  const BRepAdaptor_Curve curve_;
  std::array<FaceAtEdge, 2> sides_;
};

// Returns the curve in the parameters of the face, with the parameters of the edge. Null if the
// kernel has an exact one, or if no spline is exact enough.
Handle(Geom2d_BSplineCurve) exactParameters(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kPieces = 16, kRounds = 6;
  const BRepAdaptor_Curve curve(edge);
  FaceAtEdge side(edge, face);
  if (!side.isSpline()) return {};
  const double from = curve.FirstParameter(), to = curve.LastParameter();
  std::vector<double> ts;
  for (int i = 0; i <= kPieces; ++i) ts.push_back(from + (to - from) * i / kPieces);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<CurvePoint2d> points;
    for (const double t : ts) {
      gp_Pnt p;
      gp_Vec along, normal;
      curve.D1(t, p, along);
      side.start(t);
      side.distance(p, normal);
      const auto [at, tangent] = side.parameters(along);
      points.push_back({at, tangent});
    }
    const Handle(Geom2d_BSplineCurve) result = interpolated(points, ts);
    if (result.IsNull()) return {};
    std::vector<double> finer;
    for (std::size_t i = 0; i < ts.size(); ++i) {
      finer.push_back(ts[i]);
      if (i + 1 == ts.size()) break;
      const double t = (ts[i] + ts[i + 1]) / 2;
      if (side.at(result->Value(t)).Distance(curve.Value(t)) > kCurveBound) finer.push_back(t);
    }
    if (finer.size() == ts.size()) return result;
    ts = std::move(finer);
  }
  return {};
}

}  // namespace

void makeSectionsExact(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  const BRep_Builder builder;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
    if (BRep_Tool::Degenerated(edge) || edges(i).Size() != 2) continue;
    const TopoDS_Face& a = TopoDS::Face(edges(i).First());
    const TopoDS_Face& b = TopoDS::Face(edges(i).Last());
    if (a.IsSame(b)) continue;
    if (BRep_Tool::IsClosed(edge, a) || BRep_Tool::IsClosed(edge, b)) continue;
    const auto section = Section(edge, a, b).exact();
    if (!section) {
      for (const TopoDS_Face& face : {a, b}) {
        const Handle(Geom2d_BSplineCurve) parameters = exactParameters(edge, face);
        if (!parameters.IsNull())
          builder.UpdateEdge(edge, parameters, face, Precision::Confusion());
      }
      continue;
    }
    builder.UpdateEdge(edge, section->curve, TopLoc_Location(), Precision::Confusion());
    builder.UpdateEdge(edge, section->onSides[0], a, Precision::Confusion());
    builder.UpdateEdge(edge, section->onSides[1], b, Precision::Confusion());
    builder.Range(edge, section->curve->FirstParameter(), section->curve->LastParameter());
  }
}

}  // namespace swept::step
