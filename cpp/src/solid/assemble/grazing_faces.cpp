// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <algorithm>

#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/turning_step.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::optional<FittedSheet> TurningStep::fittedGraze(const ExactSurface& exact, Range w, Range t,
                                                    const Knots* given) {
  constexpr std::size_t kFewPoles = 1500;
  constexpr int kHighDegree = 9;
  if (auto fitted = fitSheet(exact, w, t, given, kSurfaceBound, kFewPoles)) return fitted;
  return fitSheet(exact, w, t, given, kSurfaceBound, kMaxTurningPoles, kHighDegree);
}

bool TurningStep::endsExactly(const Contact& contact) const {
  return contact.s.length() < kSameTime || motion_.slidesAt(body_.edges[contact.edge]);
}

void TurningStep::appendGrazes(int surface, int curve) {
  const ContactCurves& curves = curves_[surface];
  if (const auto fan = curves.fanOf(curve)) {
    appendFan(surface, curve, *fan);
    return;
  }
  std::vector<Range> times;
  for (const Contact& contact : contacts_) {
    if (body_.faces[contact.face].surface != surface || contact.curve != curve) continue;
    const double wider = endsExactly(contact) ? 0 : kOneStep;
    const Range within = curves.times(curve);
    times.push_back(
        {std::max(within.from, contact.s.from - wider), std::min(within.to, contact.s.to + wider)});
  }
  const bool isPart = curves.isPart(curve);
  // All around the axis, it may touch no edge.
  if (isPart) times.push_back(curves.times(curve));
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
      if (!isPart) w = {HUGE_VAL, -HUGE_VAL};
      for (const Contact& contact : contacts_) {
        if (belongs(contact, surface, curve, s)) w = w.with(contact.w.from).with(contact.w.to);
      }
    }
    w = rangeOf(curves, curve, w);
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

Range TurningStep::rangeOf(const ContactCurves& curves, int curve, Range w) const {
  constexpr double kWider = 0.05;
  Range wide = w.grown(kWider);
  // In a window, the curve would bend too much.
  const Range own = curves.extent(curve);
  if (curves.isAtWindow(curve, false)) wide.from = own.from;
  if (curves.isAtWindow(curve, true)) wide.to = own.to;
  return wide;
}

Vector2d TurningStep::onGraze(const Graze& graze, double w, double s) const {
  if (!graze.fan) return {w, motion_.timeOf(s)};
  return parametersOn(graze, curves_[graze.surface].at(graze.curve, w, s), s);
}

Vector2d TurningStep::parametersOn(const Graze& graze, const Vector3d& p, double s) const {
  const ContactCurves& curves = curves_[graze.surface];
  if (!graze.fan) return {curves.positionAt(graze.curve, p, s), motion_.timeOf(s)};
  const Vector2d on = curves.parametersOf(*graze.fan, p, s);
  return {on.x(), motion_.timeOf(on.y())};
}

ContactCurves::Touch TurningStep::touchOf(const Graze& graze, const Vector2d& on) const {
  const ContactCurves& curves = curves_[graze.surface];
  const double s = on.y() / motion_.length();
  if (graze.fan) return curves.at(*graze.fan, {on.x(), s});
  return {curves.at(graze.curve, on.x(), s), s};
}

Vector3d TurningStep::pointOn(const Graze& graze, const Vector2d& on) const {
  const auto touch = touchOf(graze, on);
  return motion_.at(touch.p, touch.s);
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
      contact.along);
  if (shape.IsNull()) return;
  SweptSection divider{shape, {}};
  if (graze != nullptr) {
    const auto onFace = [&](double t) {
      const Vector2d on = arc.at(t);
      return parametersOn(*graze, edge.at(on.x()), on.y());
    };
    if (!addCurveOn(to_.faces[graze->face].face, shape, onFace, {1, 1}, contact.along)) return;
    divider.faces.push_back(graze->face);
  }
  if (sheet >= 0) {
    const auto onSheet = [&](double t) {
      const Vector2d on = arc.at(t);
      return Vector2d(on.x(), motion_.timeOf(on.y()));
    };
    if (!addCurveOn(to_.faces[sheet].face, shape, onSheet, {edge.scale, 1}, contact.along)) return;
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
  std::vector<double> cuts;
  if (curves.isPart(graze.curve)) {
    const Range own = curves.extent(graze.curve);
    cuts = {own.from, own.to};
  }
  if (next != nullptr && curves.isPart(next->curve)) {
    const Range other = curves.extent(next->curve);
    for (const double end : {other.from, other.to}) {
      const double w = curves.positionAt(graze.curve, curves.at(next->curve, end, s), s);
      if (curves.doesOwn(graze.curve, w)) cuts.push_back(w);
    }
  }
  for (const Vector3d& p : contactsOnBorder(f, s)) {
    const double w = curves.positionAt(graze.curve, p, s);
    if (isAt(curves.at(graze.curve, w, s), p) && curves.doesOwn(graze.curve, w)) cuts.push_back(w);
  }
  return insideOf(f, std::move(cuts), [&](double w) { return curves.at(graze.curve, w, s); });
}

std::vector<Range> TurningStep::insideOf(int f, std::vector<double> cuts,
                                         const std::function<Vector3d(double)>& at) const {
  std::sort(cuts.begin(), cuts.end());
  std::vector<Range> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Range w{cuts[i], cuts[i + 1]};
    if (w.length() < Precision::Confusion()) continue;
    if (body_.placeOf(f, at(w.at(0.5))) == TopAbs_IN) parts.push_back(w);
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
  const auto on = [&](double x) { return onGraze(graze, x, s); };
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
  if (graze.fan && next.fan && graze.fan->isBeside(*next.fan)) return;  // see appendMoment()
  const ContactCurves& curves = curves_[graze.surface];
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (body_.faces[f].surface != graze.surface) continue;
    for (const Range& w : partsIn(static_cast<int>(f), graze, s, &next)) {
      const Vector3d middle = curves.at(graze.curve, w.at(0.5), s);
      const double there = curves.positionAt(next.curve, middle, s);
      const bool isSame =
          (curves.at(next.curve, there, s) - middle).norm() < Precision::Confusion();
      if (!isSame || !curves.doesOwn(next.curve, there)) continue;
      const TopoDS_Edge edge = contactEdge(graze, s, w);
      const auto on = [&](double x) { return parametersOn(next, curves.at(graze.curve, x, s), s); };
      if (!edge.IsNull() && addCurveOn(to_.faces[next.face].face, edge, on, {1, 1}, w))
        to_.dividers.push_back({edge, {graze.face, next.face}});
    }
  }
}

void TurningStep::appendSeam(const Graze& part, const Graze& next) {
  const ContactCurves& curves = curves_[part.surface];
  if (next.surface != part.surface || !curves.doesContinue(part.curve, next.curve)) return;
  const Range t =
      motion_.timeOf(Range{std::max(part.s.from, next.s.from), std::min(part.s.to, next.s.to)});
  if (t.length() < Precision::Confusion()) return;
  // Where a part ends at a fan, the curve of the fan is irregular at the critical moment.
  const bool isFromNext = part.fan.has_value();
  const int curve = isFromNext ? next.curve : part.curve;
  const Range own = curves.extent(curve);
  const double w = isFromNext ? own.from : own.to;
  const auto at = [&](double x) { return curves.at(curve, w, x / motion_.length()); };
  const TopoDS_Edge edge =
      fittedEdge([&](double x) { return motion_.at(at(x), x / motion_.length()); }, t);
  if (edge.IsNull()) return;
  for (const Graze* graze : {&part, &next}) {
    const auto on = [&](double x) -> Vector2d {
      if (graze->curve == curve) return {w, x};
      return parametersOn(*graze, at(x), x / motion_.length());
    };
    if (!addCurveOn(to_.faces[graze->face].face, edge, on, {1, 1}, t)) return;
  }
  to_.dividers.push_back({edge, {part.face, next.face}});
}

}  // namespace swept::step
