// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_step.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool TurningStep::append(const PosedBody& start, const PosedBody& end,
                         const std::array<const std::vector<int>*, 2>& caps) {
  constexpr double kNoTravel = 1e-5;  // mm
  if (motion_.shortest() < kNoTravel) return false;
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    const bool canSlide = body_.surfaceOf(static_cast<int>(f)).isPlane || !motion_.doesTurn();
    if (motion_.slides(static_cast<int>(f)) && !canSlide) return false;
  }
  caps_ = caps;
  const std::vector<double> times = motion_.pinches();
  for (std::size_t i = 1; i + 1 < times.size(); ++i)
    between_.emplace_back(body_.shape, path_.poseAt(times[i]));
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    Span& span = spans_.emplace_back();
    span.s = {times[i], times[i + 1]};
    span.start = i == 0 ? &start : &between_[i - 1];
    span.end = i + 2 == times.size() ? &end : &between_[i];
    if (!makePaths(span)) return false;
  }
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    appendSheet(static_cast<int>(e));
    findContacts(static_cast<int>(e));
  }
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    for (int curve = 0; curve < curves_[i].count(); ++curve) {
      appendGrazes(static_cast<int>(i), curve);
    }
  }
  for (const Contact& contact : contacts_) {
    // A plane in which an edge moves is cut by the grazing surface itself.
    const BodyEdge& edge = body_.edges[contact.edge];
    if (motion_.slidesAt(edge) || motion_.planeOf(edge)) continue;
    appendContact(contact);
  }
  for (const Graze& graze : grazes_) {
    for (const int time : {0, 1}) {
      if ((time == 0 && graze.s.from <= 0) || (time == 1 && graze.s.to >= 1))
        appendContactCurves(graze, time);
    }
    appendRegression(graze);
  }
  return true;
}

void TurningStep::addPathsTo(FixedSurfaces& fixed, std::size_t step) const {
  const auto add = [&](int surface, int vertex) {
    for (const Span& span : spans_) fixed.add(surface, span.paths[vertex]);
  };
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (!motion_.slides(static_cast<int>(f))) continue;
    for (const int e : body_.faces[f].edges) {
      for (const int v : {body_.edges[e].from, body_.edges[e].to}) {
        if (body_.isCorner(v, static_cast<int>(f))) add((*caps_[0])[f], v);
      }
    }
  }
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    const int plane = fixed.planeOf(step, e);
    if (plane < 0) continue;
    fixed.add(plane, spans_.front().start->of(body_.edges[e]));
    fixed.add(plane, spans_.back().end->of(body_.edges[e]));
    for (const int v : {body_.edges[e].from, body_.edges[e].to}) add(plane, v);
  }
}

bool TurningStep::makePaths(Span& span) const {
  const BRep_Builder builder;
  for (int v = 0; v < body_.vertices.Extent(); ++v) {
    const Vector3d p = body_.point(v);
    TopoDS_Edge edge = fittedEdge([&](double t) { return motion_.at(p, t / motion_.length()); },
                                  motion_.timeOf(span.s));
    if (edge.IsNull()) return false;
    const TopoDS_Shape& vertex = body_.vertices(v + 1);
    builder.Add(edge, span.start->of(vertex).Oriented(TopAbs_FORWARD));
    builder.Add(edge, span.end->of(vertex).Oriented(TopAbs_REVERSED));
    span.paths.push_back(edge);
  }
  return true;
}

void TurningStep::appendSheet(int e) {
  const BodyEdge& edge = body_.edges[e];
  for (Span& span : spans_) span.sheets.push_back(-1);
  if (!body_.isConvex(edge) || !motion_.isOutline(edge) || motion_.planeOf(edge)) return;
  const Knots line(1, {edge.range.from, edge.range.to});
  const auto fitted = fitSheet(
      [&](double u, double t) { return motion_.at(edge.at(u), t / motion_.length()); }, edge.range,
      {0, motion_.length()}, edge.isStraight ? &line : nullptr, kSurfaceBound, kMaxTurningPoles);
  if (!fitted) return;
  for (Span& span : spans_) {
    // The whole surface may intersect itself. The kernel would find points on the wrong part.
    const Handle(Geom_Surface) surface =
        kernelSheet(fitted->sheet->part(edge.range, motion_.timeOf(span.s)));
    span.sheets.back() = static_cast<int>(to_.faces.size());
    to_.faces.push_back({sheetOf(edge, span, surface), SweptFace::kAlone});
  }
}

TopoDS_Face TurningStep::sheetOf(const BodyEdge& edge, const Span& span,
                                 const Handle(Geom_Surface) & surface) const {
  const BRep_Builder builder;
  TopoDS_Face face;
  TopoDS_Wire wire;
  builder.MakeFace(face, surface, Precision::Confusion());
  builder.MakeWire(wire);
  // Adds a border; `start`: parameters at its start.
  const auto add = [&](const TopoDS_Edge& border, bool isForward, gp_Pnt2d start,
                       const gp_Dir2d& along) {
    double first, last;
    BRep_Tool::Range(border, first, last);
    start.Translate(gp_Vec2d(along) * -first);
    builder.UpdateEdge(border, new Geom2d_Line(start, along), face, Precision::Confusion());
    builder.Add(wire, border.Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
  };
  const Range t = motion_.timeOf(span.s);
  add(span.start->of(edge), true, {edge.range.from, t.from}, {1, 0});
  add(span.paths[edge.to], true, {edge.range.to, t.from}, {0, 1});
  add(span.end->of(edge), false, {edge.range.from, t.to}, {1, 0});
  add(span.paths[edge.from], false, {edge.range.from, t.from}, {0, 1});
  wire.Closed(Standard_True);
  builder.Add(face, wire);
  return face;
}

void TurningStep::findContacts(int e) {
  const BodyEdge& edge = body_.edges[e];
  if (body_.isWithinSurface(edge)) return;
  for (const int f : edge.faces) {
    const ContactCurves& curves = curves_[body_.faces[f].surface];
    if (curves.count() == 0) continue;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      for (const ZeroArc& arc : motion_.contactsOf(edge, f, spans_[i].s)) {
        const Range range = arc.range();
        Range s{HUGE_VAL, -HUGE_VAL};
        constexpr int kPoints = 16;
        for (int j = 0; j <= kPoints; ++j) {
          const double x =
              std::clamp(arc.at(range.at(static_cast<double>(j) / kPoints)).y(), 0.0, 1.0);
          s = {std::min(s.from, x), std::max(s.to, x)};
        }
        const Vector2d middle = arc.at(range.at(0.5));
        contacts_.push_back({e, f, curves.curveOf(edge.at(middle.x()), middle.y()), i, arc, s});
      }
    }
  }
}

}  // namespace swept::step
