// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/exact_sections.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
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
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/carrier/fit_spline.h"

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
  /// Returns whether the curve on the face is exact already. `spans`: parameters of the edge,
  /// between which its curve is smooth.
  bool isOn(const BRepAdaptor_Curve& edge, const std::vector<double>& spans) const {
    constexpr int kParts = 4;
    for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
      for (int k = 0; k < kParts; ++k) {
        const double t = spans[i] + (spans[i + 1] - spans[i]) * k / kParts;
        if (at(curve_->Value(t)).Distance(edge.Value(t)) > kCurveBound / 2) return false;
      }
    }
    return true;
  }
  bool isKnown() const { return !curve_.IsNull(); }
  bool isSpline() const { return Geom2dAdaptor_Curve(curve_).GetType() == GeomAbs_BSplineCurve; }

  gp_Pnt at(const gp_Pnt2d& p) const { return surface_->Value(p.X(), p.Y()); }
  /// Starts at the point of the edge with this parameter.
  void start(double t) { at_ = curve_->Value(t); }
  /// Returns the distance of the point from the surface, along the normal there.
  double distance(const gp_Pnt& p, gp_Vec& normal) {
    constexpr int kRounds = 2;  // the kernel stops before rounding errors
    at_ = foot_->NextValueOfUV(at_, p, Precision::Confusion());
    gp_Pnt foot;
    for (int round = 0; round <= kRounds; ++round) {
      surface_->D1(at_.X(), at_.Y(), foot, alongU_, alongV_);
      if (round < kRounds) at_.Translate(parametersAlong(gp_Vec(foot, p), alongU_, alongV_));
    }
    normal = alongU_.Crossed(alongV_);
    if (normal.Magnitude() > gp::Resolution()) normal.Normalize();
    return gp_Vec(p, foot).Dot(normal);
  }
  /// Returns the parameters of the last foot point.
  const gp_Pnt2d& foot() const { return at_; }
  /// Returns the lengths of the derivatives of the surface at a point of the edge.
  Eigen::Vector2d scaleAt(double t) const {
    const gp_Pnt2d on = curve_->Value(t);
    gp_Pnt p;
    gp_Vec u, v;
    surface_->D1(on.X(), on.Y(), p, u, v);
    return {std::max(u.Magnitude(), gp::Resolution()), std::max(v.Magnitude(), gp::Resolution())};
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
  Handle(Geom_Curve) curve;
  std::array<Handle(Geom2d_Curve), 2> onSides;
  double length;  // of the range of parameters, which starts at 0
};

class Section {
 public:
  Section(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b)
      : curve_(edge),
        range_{curve_.FirstParameter(), curve_.LastParameter()},
        sides_{FaceAtEdge(edge, a), FaceAtEdge(edge, b)} {}

  /// Returns nothing if the edge is a line or circle, or if the faces do not cross.
  std::optional<ExactSection> exact() {
    constexpr double kSpineBound = 1e-4;  // times the length
    constexpr double kBound = 1e-8;       // mm
    if (curve_.GetType() != GeomAbs_BSplineCurve || !sides_[0].isKnown() || !sides_[1].isKnown())
      return std::nullopt;
    // The parameter of the new curve is that of a smooth curve nearby. The point at a parameter
    // lies in the plane across this curve. (The given curve consists of cubics.)
    const double length = curve_.Value(range_.from).Distance(curve_.Value(range_.at(0.5))) +
                          curve_.Value(range_.at(0.5)).Distance(curve_.Value(range_.to));
    const auto spine = fitSpline([&](double t) { return vectorOf(curve_.Value(t).XYZ()); }, range_,
                                 kSpineBound * length);
    if (!spine) return std::nullopt;
    spine_ = kernelCurve(*spine);
    std::array<Eigen::Vector2d, 2> scales;
    for (const int k : {0, 1}) scales[k] = sides_[k].scaleAt(range_.at(0.5));
    const auto fitted = fitSplines(
        [&](double t) -> Eigen::RowVectorXd {
          Eigen::RowVectorXd row = Eigen::RowVectorXd::Constant(9, NAN);
          const auto point = pointAt(t);
          if (!point) return row;
          row.segment<3>(0) = vectorOf(point->XYZ()).transpose();
          for (const int k : {0, 1}) {
            const gp_Pnt2d& at = sides_[k].foot();
            row.segment<3>(3 + 3 * k) << at.X() * scales[k].x(), at.Y() * scales[k].y(), 0;
          }
          return row;
        },
        range_, kBound);
    if (!fitted) return std::nullopt;
    return ExactSection{
        kernelCurve(fitted->at(0)),
        {kernelCurveOn(fitted->at(1), scales[0]), kernelCurveOn(fitted->at(2), scales[1])},
        range_.length()};
  }

 private:
  // Returns the point of both surfaces in the plane across the spine. The sides then know its foot
  // points.
  std::optional<gp_Pnt> pointAt(double t) {
    constexpr int kRounds = 10;
    constexpr double kExact = 1e-11;  // mm
    gp_Pnt middle;
    gp_Vec forward;
    spine_->D1(t - range_.from, middle, forward);
    if (forward.Magnitude() < gp::Resolution()) return std::nullopt;
    forward.Normalize();
    gp_Pnt p = curve_.Value(t);
    const gp_Pnt start = p;
    for (FaceAtEdge& side : sides_) side.start(t);
    for (int round = 0; round < kRounds; ++round) {
      gp_Vec n, m;
      const double toA = sides_[0].distance(p, n), toB = sides_[1].distance(p, m);
      const double toPlane = gp_Vec(p, middle).Dot(forward);
      const gp_Vec tangent = n.Crossed(m);
      const double square = tangent.SquareMagnitude(), cosine = n.Dot(m),
                   advance = tangent.Dot(forward);
      if (square < kMinCrossing * kMinCrossing) return std::nullopt;
      if (std::max({std::abs(toA), std::abs(toB), std::abs(toPlane)}) < kExact) {
        const gp_Vec moved(start, p);
        const double across = (moved - moved.Dot(forward) * forward).Magnitude();
        return across <= kMaxMove ? std::optional<gp_Pnt>(p) : std::nullopt;
      }
      // The shortest step to both tangent planes, and from there along both to the plane across.
      gp_Vec step = n * ((toA - cosine * toB) / square) + m * ((toB - cosine * toA) / square);
      step += tangent * ((toPlane - step.Dot(forward)) / advance);
      p.Translate(step);
    }
    return std::nullopt;
  }

  const BRepAdaptor_Curve curve_;
  const Range range_;
  Handle(Geom_Curve) spine_;
  std::array<FaceAtEdge, 2> sides_;
};

// Returns the ends of a curve, and between them the parameters at which its pieces join.
std::vector<double> spansOf(const BRepAdaptor_Curve& curve) {
  const GeomAbs_Shape smooth = GeomAbs_CN;
  TColStd_Array1OfReal joints(1, curve.NbIntervals(smooth) + 1);
  curve.Intervals(joints, smooth);
  return {joints.begin(), joints.end()};
}

// Returns the curve in the parameters of the face, with the parameters of the edge. Null if the
// kernel has an exact one, or if no spline is exact enough.
Handle(Geom2d_BSplineCurve) exactParameters(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr std::size_t kPieces = 16, kMaxPoints = 1000;
  constexpr int kRounds = 20;  // at a fold, the parameters change like a square root
  const BRepAdaptor_Curve curve(edge);
  FaceAtEdge side(edge, face);
  if (!side.isSpline()) return {};
  const std::vector<double> spans = spansOf(curve);
  if (side.isOn(curve, spans)) return {};
  std::vector<double> ts{spans.front()};
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    const auto pieces = std::max<std::size_t>(1, kPieces / (spans.size() - 1));
    for (std::size_t k = 1; k <= pieces; ++k)
      ts.push_back(spans[i] + (spans[i + 1] - spans[i]) * static_cast<double>(k) /
                                  static_cast<double>(pieces));
  }
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
    if (finer.size() > kMaxPoints) break;
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
    builder.Range(edge, 0, section->length);
  }
}

}  // namespace swept::step
