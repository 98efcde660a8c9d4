// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <algorithm>

#include "base/parallel.h"
#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/turning_step.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Where a contact curve bends quickly, splines of a high degree need fewer poles.
std::optional<FittedSheet> fittedGraze(const ExactSurface& exact, Range w, Range t,
                                       const Knots* given) {
  constexpr std::size_t kFewPoles = 1500;
  constexpr int kHighDegree = 9;
  if (auto fitted = fitSheet(exact, w, t, given, kSurfaceBound, kFewPoles)) return fitted;
  return fitSheet(exact, w, t, given, kSurfaceBound, kMaxTurningPoles, kHighDegree);
}

}  // namespace

bool TurningStep::endsExactly(const Contact& contact) const {
  return contact.s.length() < kSameTime || motion_.slidesAt(body_.edges[contact.edge]);
}

void TurningStep::appendGrazes(int surface, int curve) {
  constexpr double kWider = 0.05;
  const ContactCurves& curves = curves_[surface];
  std::vector<Range> times;
  for (const Contact& contact : contacts_) {
    if (body_.faces[contact.face].surface != surface || contact.curve != curve) continue;
    const double wider = endsExactly(contact) ? 0 : kOneStep;
    const Range within = curves.times(curve);
    times.push_back(
        {std::max(within.from, contact.s.from - wider), std::min(within.to, contact.s.to + wider)});
  }
  const bool isHalf = curves.otherHalf(curve) != ContactCurves::kNoCurve;
  // All around the axis, it may touch no edge.
  if (isHalf) times.push_back(curves.times(curve));
  std::sort(times.begin(), times.end(),
            [](const Range& a, const Range& b) { return a.from < b.from; });
  std::vector<Range> joined;
  for (const Range& s : times) {
    if (joined.empty() || s.from > joined.back().to + kOneStep) {
      joined.push_back(s);
    } else {
      joined.back().to = std::max(joined.back().to, s.to);
    }
  }
  const auto exact = [&](double x, double t) -> Vector3d {
    return motion_.at(curves.at(curve, x, t / motion_.length()), t / motion_.length());
  };
  for (const Range& s : joined) {
    if (s.length() < kSameTime) continue;
    Range w = curves.extent(curve);
    if (body_.surfaces[surface].kind == BodySurface::Kind::Torus) {
      // Elsewhere the curve may be far outside of the face, and irregular.
      if (!isHalf) w = {HUGE_VAL, -HUGE_VAL};
      for (const Contact& contact : contacts_) {
        if (belongs(contact, surface, curve, s)) w = w.with(contact.w.from).with(contact.w.to);
      }
    }
    w = w.grown(kWider);
    const Knots straight(1, {w.from, w.to});
    if (isFixed(exact, w, motion_.timeOf(s))) {
      dropContacts(surface, curve, s);
      continue;
    }
    const auto fitted =
        fittedGraze(exact, w, motion_.timeOf(s), curves.areStraight() ? &straight : nullptr);
    if (!fitted) continue;
    grazes_.push_back({surface, curve, w, s, static_cast<int>(to_.faces.size())});
    SweptFace& added = to_.faces.emplace_back();
    added.face =
        BRepBuilderAPI_MakeFace(kernelSheet(*fitted->sheet), w.from, w.to, motion_.timeOf(s.from),
                                motion_.timeOf(s.to), Precision::Confusion());
    added.conditions = conditions_.ofGraze(surface, curves, curve);
  }
}

bool TurningStep::isFixed(const ExactSurface& exact, Range w, Range t) const {
  constexpr int kPoints = 4;
  std::vector<Vector3d> points;
  for (int i = 0; i <= kPoints; ++i) {
    for (int j = 0; j <= kPoints; ++j)
      points.push_back(
          exact(w.at(static_cast<double>(i) / kPoints), t.at(static_cast<double>(j) / kPoints)));
  }
  return fixed_.doesContain(points);
}

bool TurningStep::belongs(const Contact& contact, int surface, int curve, Range s) const {
  return body_.faces[contact.face].surface == surface && contact.curve == curve &&
         contact.s.from >= s.from && contact.s.to <= s.to;
}

void TurningStep::dropContacts(int surface, int curve, Range s) {
  const auto isDropped = [&](const Contact& contact) {
    return belongs(contact, surface, curve, s);
  };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), isDropped), contacts_.end());
}

const TurningStep::Graze* TurningStep::grazeOf(const Contact& contact) const {
  for (const Graze& graze : grazes_) {
    if (belongs(contact, graze.surface, graze.curve, graze.s)) return &graze;
  }
  return nullptr;
}

void TurningStep::appendContact(const Contact& contact) {
  const BodyEdge& edge = body_.edges[contact.edge];
  const Graze* graze = grazeOf(contact);  // null if there is no regular surface
  const std::vector<SheetPart>& sheets = sheets_[contact.edge];
  const int sheet = sheets.empty() ? -1 : sheets[contact.sheet].face;
  const ZeroArc& arc = contact.arc;
  const TopoDS_Edge shape = fittedEdge(
      [&](double t) {
        const Vector2d on = arc.at(t);
        return motion_.at(edge.at(on.x()), on.y());
      },
      arc.range());
  if (shape.IsNull()) return;
  SweptSection divider{shape, {}};
  if (graze != nullptr) {
    const ContactCurves& curves = curves_[graze->surface];
    const auto onGraze = [&](double t) {
      const Vector2d on = arc.at(t);
      return Vector2d(curves.positionAt(graze->curve, edge.at(on.x()), on.y()),
                      motion_.timeOf(on.y()));
    };
    if (!addCurveOn(to_.faces[graze->face].face, shape, onGraze, {1, 1}, arc.range())) return;
    divider.faces.push_back(graze->face);
  }
  if (sheet >= 0) {
    const auto onSheet = [&](double t) {
      const Vector2d on = arc.at(t);
      return Vector2d(on.x(), motion_.timeOf(on.y()));
    };
    if (!addCurveOn(to_.faces[sheet].face, shape, onSheet, {edge.scale, 1}, arc.range())) return;
    divider.faces.push_back(sheet);
  }
  if (!divider.faces.empty()) to_.dividers.push_back(divider);
}

void TurningStep::appendContactCurves(const Graze& graze, int time) {
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (body_.faces[f].surface != graze.surface) continue;
    const int face = static_cast<int>(f);
    for (const Range& w : partsIn(face, graze, time)) appendContactCurve(graze, time, face, w);
  }
}

std::vector<Range> TurningStep::partsIn(int f, const Graze& graze, double s,
                                        const Graze* next) const {
  const ContactCurves& curves = curves_[graze.surface];
  std::vector<double> crossings;
  if (curves.otherHalf(graze.curve) != ContactCurves::kNoCurve) {
    const Range half = curves.extent(graze.curve);
    crossings = {half.from, half.to};
  }
  if (next != nullptr && curves.otherHalf(next->curve) != ContactCurves::kNoCurve) {
    const Range half = curves.extent(next->curve);
    for (const double end : {half.from, half.to}) {
      const double w = curves.positionAt(graze.curve, curves.at(next->curve, end, s), s);
      if (curves.doesOwn(graze.curve, w)) crossings.push_back(w);
    }
  }
  for (const Vector3d& p : contactsOnBorder(f, s)) {
    const double w = curves.positionAt(graze.curve, p, s);
    constexpr double kOnCurve = 1e-6;  // mm
    if ((curves.at(graze.curve, w, s) - p).norm() < kOnCurve && curves.doesOwn(graze.curve, w))
      crossings.push_back(w);
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Range> parts;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const Range w{crossings[i], crossings[i + 1]};
    if (w.length() < Precision::Confusion()) continue;
    const Vector3d middle = curves.at(graze.curve, w.at(0.5), s);
    if (body_.placeOf(f, middle) == TopAbs_IN) parts.push_back(w);
  }
  return parts;
}

TopoDS_Edge TurningStep::contactEdge(const Graze& graze, double s, Range w) const {
  const ContactCurves& curves = curves_[graze.surface];
  const auto exact = [&](double x) { return motion_.at(curves.at(graze.curve, x, s), s); };
  const TopoDS_Face& face = to_.faces[graze.face].face;
  if (curves.areStraight()) {
    const BRep_Builder builder;
    TopoDS_Edge edge;
    const gp_Dir direction = dirOf(path_.at(s).rotation * curves.along());
    builder.MakeEdge(edge, new Geom_Line(pointOf(exact(w.from)), direction),
                     Precision::Confusion());
    builder.Range(edge, 0, w.length());
    builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(w.from, motion_.timeOf(s)), gp_Dir2d(1, 0)),
                       face, Precision::Confusion());
    return edge;
  }
  const TopoDS_Edge edge = fittedEdge(exact, w);
  const auto on = [&](double x) { return Vector2d(x, motion_.timeOf(s)); };
  return edge.IsNull() || addCurveOn(face, edge, on, {1, 1}, w) ? edge : TopoDS_Edge();
}

void TurningStep::appendContactCurve(const Graze& graze, int time, int f, Range w) {
  const ContactCurves& curves = curves_[graze.surface];
  const BodySurface& surface = body_.surfaces[graze.surface];
  const int cap = (*caps_[time])[f];
  const TopoDS_Edge edge = contactEdge(graze, time, w);
  if (edge.IsNull()) return;
  if (!surface.isPlane()) {
    const Vector2d near = body_.faces[f].range.center();
    const auto onCap = [&](double x) {
      const Vector3d p = curves.at(graze.curve, x, time);
      return cap < static_cast<int>(fixed_.count()) ? fixed_.parametersOf(cap, motion_.at(p, time))
                                                    : body_.surfaceOf(f).parametersOf(p, near);
    };
    if (!addCurveOn(to_.faces[cap].face, edge, onCap, {surface.radius + surface.tube, 1}, w))
      return;
  }
  to_.dividers.push_back({edge, {graze.face, cap}});
}

void TurningStep::appendChange(const Graze& graze, const Graze& next) {
  const double s = graze.s.to;
  if (graze.surface != next.surface || s >= 1 || std::abs(next.s.from - s) > kSameTime) return;
  const ContactCurves& curves = curves_[graze.surface];
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (body_.faces[f].surface != graze.surface) continue;
    for (const Range& w : partsIn(static_cast<int>(f), graze, s, &next)) {
      const auto onNext = [&](double x) {
        return curves.positionAt(next.curve, curves.at(graze.curve, x, s), s);
      };
      const Vector3d middle = curves.at(graze.curve, w.at(0.5), s);
      const double there = onNext(w.at(0.5));
      const bool isSame =
          (curves.at(next.curve, there, s) - middle).norm() < Precision::Confusion();
      if (!isSame || !curves.doesOwn(next.curve, there)) continue;
      const TopoDS_Edge edge = contactEdge(graze, s, w);
      const auto on = [&](double x) { return Vector2d(onNext(x), motion_.timeOf(s)); };
      if (!edge.IsNull() && addCurveOn(to_.faces[next.face].face, edge, on, {1, 1}, w))
        to_.dividers.push_back({edge, {graze.face, next.face}});
    }
  }
}

void TurningStep::appendSeam(const Graze& half, const Graze& other) {
  const ContactCurves& curves = curves_[half.surface];
  if (other.surface != half.surface || curves.otherHalf(half.curve) != other.curve) return;
  const Range t = motion_.timeOf(half.s);
  const double end = curves.extent(half.curve).to, start = curves.extent(other.curve).from;
  const TopoDS_Edge edge = fittedEdge(
      [&](double x) {
        const double s = x / motion_.length();
        return motion_.at(curves.at(half.curve, end, s), s);
      },
      t);
  const auto at = [](double w) { return [w](double x) { return Vector2d(w, x); }; };
  if (!edge.IsNull() && addCurveOn(to_.faces[half.face].face, edge, at(end), {1, 1}, t) &&
      addCurveOn(to_.faces[other.face].face, edge, at(start), {1, 1}, t))
    to_.dividers.push_back({edge, {half.face, other.face}});
}

void TurningStep::appendRegressions() {
  std::vector<Regression> found(grazes_.size());
  parallelBlocks(grazes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = regressionOf(grazes_[i]);
  });
  for (const Regression& of : found) {
    to_.folds.insert(to_.folds.end(), of.folds.begin(), of.folds.end());
    to_.crossings.insert(to_.crossings.end(), of.crossings.begin(), of.crossings.end());
  }
}

TurningStep::Regression TurningStep::regressionOf(const Graze& graze) const {
  const ContactCurves& curves = curves_[graze.surface];
  const auto exact = [&](const Vector2d& on) {
    return motion_.at(curves.at(graze.curve, on.x(), on.y()), on.y());
  };
  // Returns the signed area of the surface per unit of its parameters.
  const double stepW = 1e-3 * graze.w.length(), stepS = 1e-3;
  const auto slope = [&](const Vector2d& on, const Vector2d& step) -> Vector3d {
    return (8 * (exact(on + step) - exact(on - step)) -
            (exact(on + 2 * step) - exact(on - 2 * step))) /
           12;
  };
  const OfTwo area = [&](const Vector2d& on) {
    const Vector3d normal = path_.at(on.y()).rotation * body_.surfaces[graze.surface].normalAt(
                                                            curves.at(graze.curve, on.x(), on.y()));
    return slope(on, {stepW, 0}).cross(slope(on, {0, stepS})).dot(normal) /
           (stepW * stepS * motion_.length());
  };
  Regression regression;
  for (const ZeroArc& arc : zeroArcs(area, graze.w, graze.s, {1, motion_.length()})) {
    const TopoDS_Edge edge = fittedEdge([&](double t) { return exact(arc.at(t)); }, arc.range());
    const auto on = [&](double t) {
      const Vector2d p = arc.at(t);
      return Vector2d(p.x(), motion_.timeOf(p.y()));
    };
    if (!edge.IsNull() && addCurveOn(to_.faces[graze.face].face, edge, on, {1, 1}, arc.range()))
      regression.folds.push_back({edge, {graze.face}});
  }
  if (!regression.folds.empty()) regression.crossings = crossingsOf(graze, area);
  return regression;
}

std::vector<gp_Pnt> TurningStep::crossingsOf(const Graze& graze, const OfTwo& area) const {
  std::vector<gp_Pnt> crossings;
  for (const Contact& contact : contacts_) {
    if (grazeOf(contact) != &graze) continue;
    const BodyEdge& edge = body_.edges[contact.edge];
    const auto onGraze = [&](double t) {
      const Vector2d on = contact.arc.at(t);
      return Vector2d(curves_[graze.surface].positionAt(graze.curve, edge.at(on.x()), on.y()),
                      on.y());
    };
    for (const double t :
         zerosOf([&](double x) { return area(onGraze(x)); }, contact.arc.range())) {
      const Vector2d on = contact.arc.at(t);
      crossings.push_back(pointOf(motion_.at(edge.at(on.x()), on.y())));
    }
  }
  return crossings;
}

}  // namespace swept::step
