// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "motion/step_path.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/contact_curves.h"
#include "solid/assemble/elementary_body.h"
#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/fixed_surfaces.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/key_crossings.h"
#include "solid/assemble/zero_curves.h"
#include "solid/sweep/interpolate.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// mm: how far surfaces may lie off the exact ones. Where two of them are nearly tangent, this
/// error, divided by the sine of the angle between them, is that of their section.
constexpr double kSurfaceBound = 2e-9;
/// A cylinder whose axis nearly moves along itself grazes in a surface with some 3,000 poles.
constexpr std::size_t kMaxTurningPoles = 10000;
constexpr double kSameTime = 1e-9;
constexpr double kOneStep = 1.0 / kZeroSteps;  // between the times at which contact is tested

// The body between two times of a step: the copies there, what the edges sweep between them.
struct Span {
  Range s;
  const PosedBody* start;
  const PosedBody* end;
  std::vector<TopoDS_Edge> paths;  // by vertex
  std::vector<int> sheets;         // by edge: a face, or -1
};

// A curve on what an edge sweeps, on which the normal of a face at the edge is orthogonal to the
// velocity: it is a path of points of contact.
struct Contact {
  int edge, face;
  int curve;  // of ContactCurves
  std::size_t span;
  ZeroArc arc;  // parameter of the edge, time
  Range s;
};

// A grazing surface. Its parameters are the position on the contact curve, and time.
struct Graze {
  int surface, curve;
  Range w, s;
  int face;
};

class TurningStep {
 public:
  TurningStep(const ElementaryBody& body, const StepPath& path, const BodyMotion& motion,
              const FixedSurfaces& fixed, TurningFaces& to)
      : body_(body), path_(path), motion_(motion), fixed_(fixed), to_(to) {
    for (const BodySurface& surface : body.surfaces) curves_.emplace_back(surface, path);
  }

  // Returns false if there is no regular surface for a face or an edge.
  // `caps`: by pose and face, indices of candidates.
  bool append(const PosedBody& start, const PosedBody& end,
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
      if (!appendSheet(static_cast<int>(e))) return false;
      findContacts(static_cast<int>(e));
    }
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      for (int curve = 0; curve < curves_[i].count(); ++curve) {
        if (!appendGrazes(static_cast<int>(i), curve)) return false;
      }
    }
    for (const Contact& contact : contacts_) {
      // A plane in which an edge moves is cut by the grazing surface itself.
      const BodyEdge& edge = body_.edges[contact.edge];
      if (motion_.slidesAt(edge) || motion_.planeOf(edge)) continue;
      if (!appendContact(contact)) return false;
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

  // Adds the curves that divide fixed surfaces to these. `step`: index of this step.
  void addPathsTo(FixedSurfaces& fixed, std::size_t step) const {
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

 private:
  bool makePaths(Span& span) const {
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

  // Appends what an edge sweeps: a face for each span. Its parameters are that of the edge, and
  // time.
  bool appendSheet(int e) {
    const BodyEdge& edge = body_.edges[e];
    for (Span& span : spans_) span.sheets.push_back(-1);
    if (edge.faces[1] < 0) return false;
    if (!body_.isConvex(edge) || !motion_.isOutline(edge) || motion_.planeOf(edge)) return true;
    const Knots line(1, {edge.range.from, edge.range.to});
    const auto fitted =
        fitSheet([&](double u, double t) { return motion_.at(edge.at(u), t / motion_.length()); },
                 edge.range, {0, motion_.length()}, edge.isStraight ? &line : nullptr,
                 kSurfaceBound, kMaxTurningPoles);
    if (!fitted) return false;
    for (Span& span : spans_) {
      // The whole surface may intersect itself. The kernel would find points on the wrong part.
      const Handle(Geom_Surface) surface =
          kernelSheet(fitted->sheet->part(edge.range, motion_.timeOf(span.s)));
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
    const Range t = motion_.timeOf(span.s);
    add(span.start->of(edge), true, {edge.range.from, t.from}, {1, 0});
    add(span.paths[edge.to], true, {edge.range.to, t.from}, {0, 1});
    add(span.end->of(edge), false, {edge.range.from, t.to}, {1, 0});
    add(span.paths[edge.from], false, {edge.range.from, t.from}, {0, 1});
    wire.Closed(Standard_True);
    builder.Add(face, wire);
    return face;
  }

  // Finds the paths of points of contact that lie on an edge.
  void findContacts(int e) {
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

  // Returns whether the whole contact curve meets the border of its face at these times. So it
  // does if the body moves in a plane: the contact curve is orthogonal to this plane, and meets an
  // edge that is also orthogonal to it at one time. A grazing surface that went on beyond this
  // time would be nearly the same as what the edge sweeps.
  bool isWholeLine(const Contact& contact) const {
    return contact.s.length() < kSameTime || motion_.slidesAt(body_.edges[contact.edge]);
  }

  // Appends the surfaces that a contact curve of a surface of the body sweeps, for the times at
  // which it touches a face.
  bool appendGrazes(int surface, int curve) {
    constexpr double kWider = 0.05;
    const ContactCurves& curves = curves_[surface];
    const Range w = curves.extent(body_, surface).grown(kWider);
    std::vector<Range> times;
    for (const Contact& contact : contacts_) {
      if (body_.faces[contact.face].surface != surface || contact.curve != curve) continue;
      const double wider = isWholeLine(contact) ? 0 : kOneStep;
      times.push_back({std::max(0.0, contact.s.from - wider), std::min(1.0, contact.s.to + wider)});
    }
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
    for (const Range& s : joined) {
      if (s.length() < kSameTime) continue;
      const Knots straight(1, {w.from, w.to});
      const auto exact = [&](double x, double t) -> Vector3d {
        return motion_.at(curves.at(curve, x, t / motion_.length()), t / motion_.length());
      };
      if (isFixed(exact, w, motion_.timeOf(s))) {
        dropContacts(surface, curve, s);
        continue;
      }
      const auto fitted =
          fitSheet(exact, w, motion_.timeOf(s), curves.areStraight() ? &straight : nullptr,
                   kSurfaceBound, kMaxTurningPoles);
      if (!fitted) return false;
      grazes_.push_back({surface, curve, w, s, static_cast<int>(to_.faces.size())});
      to_.faces.push_back({BRepBuilderAPI_MakeFace(kernelSheet(*fitted->sheet), w.from, w.to,
                                                   motion_.timeOf(s.from), motion_.timeOf(s.to),
                                                   Precision::Confusion()),
                           SweptFace::kAlone});
    }
    return true;
  }

  // Returns whether a grazing surface lies in a fixed surface. So it does where a face that slides
  // continues smoothly into a cylinder.
  bool isFixed(const ExactSurface& exact, Range w, Range t) const {
    constexpr int kPoints = 4;
    std::vector<Vector3d> points;
    for (int i = 0; i <= kPoints; ++i) {
      for (int j = 0; j <= kPoints; ++j)
        points.push_back(
            exact(w.at(static_cast<double>(i) / kPoints), t.at(static_cast<double>(j) / kPoints)));
    }
    return fixed_.doesContain(points);
  }

  void dropContacts(int surface, int curve, Range s) {
    const auto isDropped = [&](const Contact& contact) {
      return body_.faces[contact.face].surface == surface && contact.curve == curve &&
             contact.s.from >= s.from && contact.s.to <= s.to;
    };
    contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), isDropped), contacts_.end());
  }

  const Graze* grazeOf(const Contact& contact) const {
    for (const Graze& graze : grazes_) {
      if (graze.surface == body_.faces[contact.face].surface && graze.curve == contact.curve &&
          graze.s.from <= contact.s.from && graze.s.to >= contact.s.to)
        return &graze;
    }
    return nullptr;
  }

  // Appends the curve in which what an edge sweeps continues into a grazing surface.
  bool appendContact(const Contact& contact) {
    const BodyEdge& edge = body_.edges[contact.edge];
    const Graze* graze = grazeOf(contact);
    if (graze == nullptr) return false;
    const ContactCurves& curves = curves_[graze->surface];
    const ZeroArc& arc = contact.arc;
    const TopoDS_Edge shape = fittedEdge(
        [&](double t) {
          const Vector2d on = arc.at(t);
          return motion_.at(edge.at(on.x()), on.y());
        },
        arc.range());
    const auto onGraze = [&](double t) {
      const Vector2d on = arc.at(t);
      return Vector2d(curves.positionAt(edge.at(on.x())), motion_.timeOf(on.y()));
    };
    const auto onSheet = [&](double t) {
      const Vector2d on = arc.at(t);
      return Vector2d(on.x(), motion_.timeOf(on.y()));
    };
    if (shape.IsNull() ||
        !addCurveOn(to_.faces[graze->face].face, shape, onGraze, {1, 1}, arc.range()))
      return false;
    SweptSection divider{shape, {graze->face}};
    const int sheet = spans_[contact.span].sheets[contact.edge];
    if (sheet >= 0) {
      if (!addCurveOn(to_.faces[sheet].face, shape, onSheet, {edge.scale, 1}, arc.range()))
        return false;
      divider.faces.push_back(sheet);
    }
    to_.dividers.push_back(divider);
    return true;
  }

  // Appends the parts of a contact curve at the start (0) or the end (1) of the step that lie
  // inside of faces.
  void appendContactCurves(const Graze& graze, int time) {
    for (std::size_t f = 0; f < body_.faces.size(); ++f) {
      if (body_.faces[f].surface == graze.surface)
        appendContactCurves(graze, time, static_cast<int>(f));
    }
  }

  void appendContactCurves(const Graze& graze, int time, int f) {
    const ContactCurves& curves = curves_[graze.surface];
    std::vector<double> crossings;
    for (const int e : body_.faces[f].edges) {
      const BodyEdge& edge = body_.edges[e];
      const OfTwo speed = motion_.speedOn(edge, f);
      for (const double u : zerosOf([&](double x) { return speed({x, time}); }, edge.range)) {
        const Vector3d p = edge.at(u);
        if (curves.curveOf(p, time) == graze.curve) crossings.push_back(curves.positionAt(p));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      const Range w{crossings[i], crossings[i + 1]};
      if (w.length() < Precision::Confusion()) continue;
      const Vector3d middle = curves.at(graze.curve, w.at(0.5), time);
      const BRepClass_FaceClassifier place(body_.faces[f].shape, pointOf(middle),
                                           Precision::Confusion());
      if (place.State() == TopAbs_IN) appendContactCurve(graze, time, f, w);
    }
  }

  void appendContactCurve(const Graze& graze, int time, int f, Range w) {
    const ContactCurves& curves = curves_[graze.surface];
    const BodySurface& surface = body_.surfaces[graze.surface];
    const auto exact = [&](double x) { return motion_.at(curves.at(graze.curve, x, time), time); };
    const int cap = (*caps_[time])[f];
    TopoDS_Edge edge;
    if (curves.areStraight()) {
      const BRep_Builder builder;
      const gp_Dir direction = dirOf(path_.at(time).rotation * curves.along());
      builder.MakeEdge(edge, new Geom_Line(pointOf(exact(w.from)), direction),
                       Precision::Confusion());
      builder.Range(edge, 0, w.length());
      builder.UpdateEdge(edge,
                         new Geom2d_Line(gp_Pnt2d(w.from, motion_.timeOf(time)), gp_Dir2d(1, 0)),
                         to_.faces[graze.face].face, Precision::Confusion());
    } else {
      edge = fittedEdge(exact, w);
      if (edge.IsNull() ||
          !addCurveOn(
              to_.faces[graze.face].face, edge,
              [&](double x) { return Vector2d(x, motion_.timeOf(time)); }, {1, 1}, w))
        return;
    }
    if (!surface.isPlane) {
      double u0, u1, v0, v1;
      BRepTools::UVBounds(body_.faces[f].shape, u0, u1, v0, v1);
      const auto onCap = [&](double x) {
        return cap < static_cast<int>(fixed_.count())
                   ? fixed_.parametersOf(cap, exact(x))
                   : surface.parametersOf(curves.at(graze.curve, x, time), (u0 + u1) / 2);
      };
      if (!addCurveOn(to_.faces[cap].face, edge, onCap, {surface.radius, 1}, w)) return;
    }
    to_.dividers.push_back({edge, {graze.face, cap}});
  }

  // Appends the edges of regression of a grazing surface: there it is tangent to itself, as the
  // contact curve has the velocity of the body.
  void appendRegression(const Graze& graze) {
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
      const Vector3d normal =
          path_.at(on.y()).rotation *
          body_.surfaces[graze.surface].normalAt(curves.at(graze.curve, on.x(), on.y()));
      return slope(on, {stepW, 0}).cross(slope(on, {0, stepS})).dot(normal) /
             (stepW * stepS * motion_.length());
    };
    bool hasFold = false;
    for (const ZeroArc& arc : zeroArcs(area, graze.w, graze.s, {1, motion_.length()})) {
      const TopoDS_Edge edge = fittedEdge([&](double t) { return exact(arc.at(t)); }, arc.range());
      const auto on = [&](double t) {
        const Vector2d p = arc.at(t);
        return Vector2d(p.x(), motion_.timeOf(p.y()));
      };
      if (edge.IsNull() || !addCurveOn(to_.faces[graze.face].face, edge, on, {1, 1}, arc.range()))
        continue;
      to_.folds.push_back({edge, {graze.face}});
      hasFold = true;
    }
    if (hasFold) appendCrossings(graze, area);
  }

  // Appends the points at which paths of contact cross edges of regression.
  void appendCrossings(const Graze& graze, const OfTwo& area) {
    for (const Contact& contact : contacts_) {
      if (grazeOf(contact) != &graze) continue;
      const BodyEdge& edge = body_.edges[contact.edge];
      const auto onGraze = [&](double t) {
        const Vector2d on = contact.arc.at(t);
        return Vector2d(curves_[graze.surface].positionAt(edge.at(on.x())), on.y());
      };
      for (const double t :
           zerosOf([&](double x) { return area(onGraze(x)); }, contact.arc.range())) {
        const Vector2d on = contact.arc.at(t);
        to_.crossings.push_back(pointOf(motion_.at(edge.at(on.x()), on.y())));
      }
    }
  }

  const ElementaryBody& body_;
  const StepPath& path_;
  const BodyMotion& motion_;
  const FixedSurfaces& fixed_;
  TurningFaces& to_;
  std::array<const std::vector<int>*, 2> caps_{};  // at the start and the end
  std::vector<ContactCurves> curves_;              // by surface of the body
  std::vector<PosedBody> between_;
  std::vector<Span> spans_;
  std::vector<Contact> contacts_;
  std::vector<Graze> grazes_;
};

// Returns the largest distance of a point of the sweep from the origin, or more.
double reachOf(const ElementaryBody& body, const std::vector<StepPath>& paths) {
  constexpr int kTimes = 16, kPoints = 8;
  constexpr double kBetween = 1.1;  // samples may miss the farthest point
  double reach = 0;
  for (const BodyEdge& edge : body.edges) {
    for (const StepPath& path : paths) {
      for (int i = 0; i <= kTimes; ++i) {
        for (int j = 0; j <= kPoints; ++j) {
          const Vector3d p = edge.at(edge.range.at(static_cast<double>(j) / kPoints));
          reach = std::max(reach, path.at(static_cast<double>(i) / kTimes).apply(p).norm());
        }
      }
    }
  }
  return kBetween * reach;
}

}  // namespace

std::optional<TurningFaces> turningFaces(const TopoDS_Shape& shape, const Trajectory& trajectory) {
  const ElementaryBody body(shape);
  const std::vector<Pose>& poses = trajectory.poses;
  std::vector<StepPath> paths;
  std::vector<BodyMotion> motions;
  paths.reserve(poses.size());
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    paths.emplace_back(poses[k], poses[k + 1], trajectory.interpolation);
    motions.emplace_back(body, paths.back());
  }
  FixedSurfaces fixed(body, poses, motions, reachOf(body, paths));
  if (fixed.doOverlap()) return std::nullopt;
  TurningFaces result;
  for (std::size_t i = 0; i < fixed.count(); ++i) result.faces.push_back(fixed.candidate(i));
  std::vector<PosedBody> posed;
  std::vector<std::vector<int>> caps;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    posed.emplace_back(body.shape, poses[k]);
    std::vector<int>& of = caps.emplace_back();
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const int surface = fixed.surfaceOf(k, f);
      of.push_back(surface >= 0 ? surface : static_cast<int>(result.faces.size()));
      if (surface < 0)
        result.faces.push_back({posed[k].of(body.faces[f]), static_cast<int>(k), {}});
      for (const int e : body.faces[f].edges) {
        if (surface >= 0) fixed.add(surface, posed[k].of(body.edges[e]));
      }
    }
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    TurningStep step(body, paths[k], motions[k], fixed, result);
    if (!step.append(posed[k], posed[k + 1], {&caps[k], &caps[k + 1]})) return std::nullopt;
    step.addPathsTo(fixed, k);
    if (k > 0) appendKeyCrossings(body, paths[k - 1], paths[k], result.crossings);
  }
  for (std::size_t i = 0; i < fixed.count(); ++i) result.faces[i] = fixed.candidate(i);
  return result;
}

}  // namespace swept::step
