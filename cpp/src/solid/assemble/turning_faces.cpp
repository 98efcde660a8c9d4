// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "motion/step_path.h"
#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/polyhedron.h"
#include "solid/assemble/zeros.h"
#include "solid/carrier/fit_spline.h"
#include "solid/sweep/contact.h"
#include "solid/sweep/interpolate.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// mm: how far surfaces may lie off the exact ones. Where two of them are nearly tangent, this
/// error, divided by the sine of the angle between them, is that of their section.
constexpr double kSurfaceBound = 2e-9;

// The line on which a plane face touches the envelope at time s: the points
// origin + w along + y(s) across, for all w.
struct ContactLine {
  Vector3d origin, along, across;
  OfTime y;
  Vector3d at(double w, double s) const { return origin + w * along + y(s) * across; }
  // Returns the position on an edge of the face at which the line crosses it.
  OfTime positionOn(const BodyEdge& edge) const {
    return [y = y, from = edge.start.dot(across), step = edge.along.dot(across)](double s) {
      return (y(s) - from) / step;
    };
  }
  bool isParallelTo(const BodyEdge& edge) const {
    constexpr double kParallel = 1e-9;
    return std::abs(edge.along.dot(across)) < kParallel;
  }
};

// The body between two times of a step: the copies there, what the edges sweep between them.
struct Span {
  Range s;
  const PosedBody* start;
  const PosedBody* end;
  std::vector<TopoDS_Edge> paths;  // by vertex
  std::vector<int> sheets;         // by edge: a face, or -1
};

class TurningStep {
 public:
  TurningStep(const TopoDS_Shape& shape, const Polyhedron& body, const StepPath& path, int pose,
              TurningFaces& to)
      : shape_(shape), body_(body), path_(path), pose_(pose), to_(to) {
    constexpr int kChords = 16;
    for (int v = 0; v < body.vertices.Extent(); ++v) {
      double travel = 0;
      for (int i = 0; i < kChords; ++i)
        travel += (at(body.point(v), (i + 1.0) / kChords) -
                   at(body.point(v), static_cast<double>(i) / kChords))
                      .norm();
      length_ = std::max(length_, travel);
      shortest_ = std::min(shortest_, travel);
    }
    for (std::size_t f = 0; f < body.faces.size(); ++f)
      lines_.push_back(contactLineOf(static_cast<int>(f)));
  }

  // Returns false if there is no regular surface for a face or an edge.
  bool append(const PosedBody& start, const PosedBody& end) {
    constexpr double kNoTravel = 1e-5;  // mm
    if (shortest_ < kNoTravel || doesSlide()) return false;
    const std::vector<double> times = pinches();
    for (std::size_t i = 1; i + 1 < times.size(); ++i)
      between_.emplace_back(shape_, path_.poseAt(times[i]));
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      Span& span = spans_.emplace_back();
      span.s = {times[i], times[i + 1]};
      span.start = i == 0 ? &start : &between_[i - 1];
      span.end = i + 2 == times.size() ? &end : &between_[i];
      if (!makePaths(span)) return false;
    }
    for (std::size_t e = 0; e < body_.edges.size(); ++e) {
      if (!appendSheet(static_cast<int>(e))) return false;
    }
    for (std::size_t f = 0; f < body_.faces.size(); ++f) {
      if (lines_[f] && !appendGraze(static_cast<int>(f), *lines_[f])) return false;
    }
    return true;
  }

 private:
  Vector3d at(const Vector3d& p, double s) const { return path_.at(s).apply(p); }
  double timeOf(double s) const { return s * length_; }
  Range timeOf(Range s) const { return {timeOf(s.from), timeOf(s.to)}; }

  // Returns n.v at a point.
  double speedOf(int f, const Vector3d& p, const Moment& moment) const {
    return body_.faces[f].normal.dot(moment.velocityAt(p));
  }

  // Returns whether a face moves only within its plane.
  bool doesSlide() const {
    constexpr int kTimes = 16;
    for (std::size_t f = 0; f < body_.faces.size(); ++f) {
      double largest = 0;
      for (const int e : body_.faces[f].edges) {
        for (int i = 0; i <= kTimes; ++i) {
          const Moment moment(path_, static_cast<double>(i) / kTimes);
          largest = std::max(largest,
                             std::abs(speedOf(static_cast<int>(f), body_.edges[e].start, moment)));
        }
      }
      if (largest <= kNoSpeed * length_) return true;
    }
    return false;
  }

  // Returns nothing if the face keeps its direction.
  std::optional<ContactLine> contactLineOf(int f) const {
    const BodyFace& face = body_.faces[f];
    // The angular velocity is constant in coordinates of the body.
    const Vector3d across = face.normal.cross(Moment(path_, 0).angular);
    if (across.norm() <= kNoSpeed) return std::nullopt;
    ContactLine line;
    line.origin = face.normal * face.normal.dot(body_.edges[face.edges.front()].start);
    line.across = across.normalized();
    line.along = line.across.cross(face.normal);
    line.y = [this, normal = face.normal, size = across.norm()](double s) {
      return -normal.dot(Moment(path_, s).linear) / size;
    };
    return line;
  }

  // Returns the start and the end of the step, and between them the times at which a point of an
  // edge moves along the edge. There the surface that the edge sweeps is pinched, and from there it
  // intersects itself; cut at this time, its parts do not.
  std::vector<double> pinches() const {
    std::vector<double> times{0, 1};
    for (const BodyEdge& edge : body_.edges) {
      if (edge.faces[1] < 0 || !body_.isConvex(edge)) continue;
      const auto &a = lines_[edge.faces[0]], &b = lines_[edge.faces[1]];
      if (!a || !b || a->isParallelTo(edge) || b->isParallelTo(edge)) continue;
      const OfTime first = a->positionOn(edge), second = b->positionOn(edge);
      for (const double s : zerosOf([&](double x) { return first(x) - second(x); }, {0, 1})) {
        if (first(s) >= 0 && first(s) <= edge.length) times.push_back(s);
      }
    }
    std::sort(times.begin(), times.end());
    constexpr double kSameTime = 1e-6;
    times.erase(std::unique(times.begin(), times.end(),
                            [](double a, double b) { return b - a < kSameTime; }),
                times.end());
    times.back() = 1;
    return times;
  }

  // Makes the edge s -> exact(s), s in the range. Null if the bound is not reached.
  TopoDS_Edge edgeOf(const std::function<Vector3d(double)>& exact, Range s) const {
    TopoDS_Edge edge;
    const auto fitted =
        fitSpline([&](double t) { return exact(t / length_); }, timeOf(s), kCurveBound);
    if (!fitted) return edge;
    const BRep_Builder builder;
    builder.MakeEdge(edge, kernelCurve(*fitted), Precision::Confusion());
    builder.Range(edge, 0, fitted->last);
    return edge;
  }

  // Adds the curve (position(s), time) in the parameters of a face to an edge of edgeOf().
  bool addOn(int face, const TopoDS_Edge& edge, const OfTime& position, Range s) const {
    const auto fitted = fitSpline([&](double t) { return Vector3d(position(t / length_), t, 0); },
                                  timeOf(s), kCurveBound);
    if (!fitted) return false;
    const auto space = Handle(Geom_BSplineCurve)::DownCast(kernelCurve(*fitted));
    TColgp_Array1OfPnt2d poles(1, space->NbPoles());
    for (int i = 1; i <= space->NbPoles(); ++i) poles(i) = {space->Pole(i).X(), space->Pole(i).Y()};
    const Handle(Geom2d_BSplineCurve) curve =
        new Geom2d_BSplineCurve(poles, space->Knots(), space->Multiplicities(), space->Degree());
    BRep_Builder().UpdateEdge(edge, curve, to_.faces[face].face, Precision::Confusion());
    return true;
  }

  bool makePaths(Span& span) const {
    const BRep_Builder builder;
    for (int v = 0; v < body_.vertices.Extent(); ++v) {
      const Vector3d p = body_.point(v);
      TopoDS_Edge edge = edgeOf([&](double s) { return at(p, s); }, span.s);
      if (edge.IsNull()) return false;
      const TopoDS_Shape& vertex = body_.vertices(v + 1);
      builder.Add(edge, span.start->of(vertex).Oriented(TopAbs_FORWARD));
      builder.Add(edge, span.end->of(vertex).Oriented(TopAbs_REVERSED));
      span.paths.push_back(edge);
    }
    return true;
  }

  // Returns whether the edge is ever between a face that moves outward and one that moves inward.
  bool isOutline(const BodyEdge& edge) const {
    constexpr int kTimes = 128, kPoints = 16;
    for (int i = 0; i <= kTimes; ++i) {
      const Moment moment(path_, static_cast<double>(i) / kTimes);
      for (int j = 0; j <= kPoints; ++j) {
        const Vector3d p = edge.at(edge.length * j / kPoints);
        if (speedOf(edge.faces[0], p, moment) * speedOf(edge.faces[1], p, moment) < 0) return true;
      }
    }
    return false;
  }

  // Appends what an edge sweeps: a face for each span, all on one surface. Its parameters are the
  // position on the edge, and time.
  bool appendSheet(int e) {
    const BodyEdge& edge = body_.edges[e];
    for (Span& span : spans_) span.sheets.push_back(-1);
    if (edge.faces[1] < 0) return false;
    if (!body_.isConvex(edge) || !isOutline(edge)) return true;
    const Knots line(1, {0, edge.length});
    const auto fitted = fitSheet([&](double u, double t) { return at(edge.at(u), t / length_); },
                                 {0, edge.length}, {0, length_}, &line, kSurfaceBound);
    if (!fitted) return false;
    const Handle(Geom_Surface) surface = kernelSheet(*fitted->sheet);
    for (Span& span : spans_) {
      span.sheets.back() = static_cast<int>(to_.faces.size());
      to_.faces.push_back({sheetOf(edge, span, surface), SweptFace::kAlone});
    }
    return true;
  }

  TopoDS_Face sheetOf(const BodyEdge& edge, const Span& span,
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
    const Range t = timeOf(span.s);
    add(span.start->of(edge), true, {0, t.from}, {1, 0});
    add(span.paths[edge.to], true, {edge.length, t.from}, {0, 1});
    add(span.end->of(edge), false, {0, t.to}, {1, 0});
    add(span.paths[edge.from], false, {0, t.from}, {0, 1});
    wire.Closed(Standard_True);
    builder.Add(face, wire);
    return face;
  }

  // Appends the surfaces in which a face grazes the envelope. Their parameters are the position on
  // the contact line, and time.
  bool appendGraze(int f, const ContactLine& line) {
    constexpr double kMargin = 0.05;
    Range ys{HUGE_VAL, -HUGE_VAL}, ws{HUGE_VAL, -HUGE_VAL};
    for (const int e : body_.faces[f].edges) {
      for (const double u : {0.0, body_.edges[e].length}) {
        const Vector3d p = body_.edges[e].at(u);
        const double y = p.dot(line.across), w = p.dot(line.along);
        ys = {std::min(ys.from, y), std::max(ys.to, y)};
        ws = {std::min(ws.from, w), std::max(ws.to, w)};
      }
    }
    ws = ws.grown(kMargin);
    for (const Range& inside : timesWithin(line.y, ys.from, ys.to, {0, 1})) {
      const Range s{std::max(0.0, inside.from - 1.0 / kZeroSteps),
                    std::min(1.0, inside.to + 1.0 / kZeroSteps)};
      const Knots straight(1, {ws.from, ws.to});
      const auto fitted =
          fitSheet([&](double w, double t) { return at(line.at(w, t / length_), t / length_); }, ws,
                   timeOf(s), &straight, kSurfaceBound);
      if (!fitted) return false;
      const int graze = static_cast<int>(to_.faces.size());
      to_.faces.push_back(
          {BRepBuilderAPI_MakeFace(kernelSheet(*fitted->sheet), ws.from, ws.to, timeOf(s.from),
                                   timeOf(s.to), Precision::Confusion()),
           SweptFace::kAlone});
      if (!appendContacts(f, line, graze, s)) return false;
      if (inside.from <= 0) appendContactLines(f, line, 0, graze);
      if (inside.to >= 1) appendContactLines(f, line, 1, graze);
      appendRegression(f, line, graze, ws, s);
    }
    return true;
  }

  // Appends the curves in which the swept edges of a face continue into its grazing surface.
  bool appendContacts(int f, const ContactLine& line, int graze, Range s) {
    contacts_.clear();
    for (const int e : body_.faces[f].edges) {
      const BodyEdge& edge = body_.edges[e];
      if (line.isParallelTo(edge)) continue;
      const OfTime u = line.positionOn(edge);
      const OfTime w = [u, from = edge.start.dot(line.along),
                        step = edge.along.dot(line.along)](double x) { return from + u(x) * step; };
      for (const Span& span : spans_) {
        const Range part{std::max(s.from, span.s.from), std::min(s.to, span.s.to)};
        if (part.from >= part.to) continue;
        for (const Range& during : timesWithin(u, 0, edge.length, part)) {
          const TopoDS_Edge contact =
              edgeOf([&](double x) { return at(edge.at(u(x)), x); }, during);
          if (contact.IsNull() || !addOn(graze, contact, w, during)) return false;
          SweptSection divider{contact, {graze}};
          if (span.sheets[e] >= 0) {
            if (!addOn(span.sheets[e], contact, u, during)) return false;
            divider.faces.push_back(span.sheets[e]);
          }
          to_.dividers.push_back(divider);
          contacts_.emplace_back(w, during);
        }
      }
    }
    return true;
  }

  // Appends the parts of the contact line at the start (0) or the end (1) of the step that lie
  // inside of the face.
  void appendContactLines(int f, const ContactLine& line, int end, int graze) {
    const double y = line.y(end);
    std::vector<double> crossings;
    for (const int e : body_.faces[f].edges) {
      const BodyEdge& edge = body_.edges[e];
      const double from = edge.start.dot(line.across), step = edge.along.dot(line.across);
      if ((from < y) == (from + step * edge.length < y)) continue;
      crossings.push_back(edge.at((y - from) / step).dot(line.along));
    }
    std::sort(crossings.begin(), crossings.end());
    const BRep_Builder builder;
    const Placement placement = path_.at(end);
    const gp_Dir direction = dirOf(placement.rotation * line.along);
    const int cap = (pose_ + end) * static_cast<int>(body_.faces.size()) + f;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double length = crossings[i + 1] - crossings[i];
      if (length < Precision::Confusion()) continue;
      const Vector3d from = placement.apply(line.at(crossings[i], end));
      TopoDS_Edge edge;
      builder.MakeEdge(edge, new Geom_Line(pointOf(from), direction), Precision::Confusion());
      builder.Range(edge, 0, length);
      builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(crossings[i], timeOf(end)), gp_Dir2d(1, 0)),
                         to_.faces[graze].face, Precision::Confusion());
      to_.dividers.push_back({edge, {graze, cap}});
    }
  }

  // Appends the edge of regression of a grazing surface: there the contact line has the velocity of
  // the body.
  void appendRegression(int f, const ContactLine& line, int graze, Range ws, Range s) {
    const Vector3d &normal = body_.faces[f].normal, angular = Moment(path_, 0).angular;
    const double turn = line.across.dot(angular.cross(line.along));
    if (std::abs(turn) <= kNoSpeed * angular.norm()) return;
    const OfTime w = [&](double x) {
      const Moment moment(path_, x);
      // In coordinates of the body, the linear velocity turns backward, unless the motion is a
      // screw.
      const double slope = path_.isScrew() ? 0
                                           : normal.dot(moment.angular.cross(moment.linear)) /
                                                 normal.cross(angular).norm();
      return -(slope + line.across.dot(moment.velocityAt(line.at(0, x)))) / turn;
    };
    const auto exact = [&](double x) { return at(line.at(w(x), x), x); };
    for (const Range& during : timesWithin(w, ws.from, ws.to, s)) {
      const TopoDS_Edge edge = edgeOf(exact, during);
      if (edge.IsNull() || !addOn(graze, edge, w, during)) continue;
      to_.dividers.push_back({edge, {graze}});
      for (const auto& [contact, range] : contacts_) {
        const Range both{std::max(during.from, range.from), std::min(during.to, range.to)};
        if (both.from >= both.to) continue;
        for (const double x :
             zerosOf([&, other = contact](double z) { return w(z) - other(z); }, both))
          to_.crossings.push_back(pointOf(exact(x)));
      }
    }
  }

  const TopoDS_Shape& shape_;
  const Polyhedron& body_;
  const StepPath& path_;
  const int pose_;  // index of the first pose
  TurningFaces& to_;
  double length_ = 0, shortest_ = HUGE_VAL;        // mm: paths of vertices
  std::vector<std::optional<ContactLine>> lines_;  // by face
  std::vector<PosedBody> between_;
  std::vector<Span> spans_;
  // On the grazing surface at hand: positions on the contact line.
  std::vector<std::pair<OfTime, Range>> contacts_;
};

}  // namespace

std::optional<TurningFaces> turningFaces(const TopoDS_Shape& body, const Trajectory& trajectory) {
  const Polyhedron polyhedron(body);
  TurningFaces result;
  std::vector<PosedBody> posed;
  for (std::size_t k = 0; k < trajectory.poses.size(); ++k) {
    posed.emplace_back(body, trajectory.poses[k]);
    for (const BodyFace& face : polyhedron.faces)
      result.faces.push_back({posed.back().of(face), static_cast<int>(k)});
  }
  for (std::size_t k = 0; k + 1 < trajectory.poses.size(); ++k) {
    const StepPath path(trajectory.poses[k], trajectory.poses[k + 1], trajectory.interpolation);
    TurningStep step(body, polyhedron, path, static_cast<int>(k), result);
    if (!step.append(posed[k], posed[k + 1])) return std::nullopt;
  }
  return result;
}

}  // namespace swept::step
