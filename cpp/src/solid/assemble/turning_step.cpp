// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_step.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "solid/assemble/contacts_within.h"
#include "solid/assemble/crossing_times.h"
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
    const BodySurface& surface = body_.surfaceOf(static_cast<int>(f));
    const bool canSlide = surface.isPlane() || (surface.isCylinder() && !motion_.doesTurn());
    if (motion_.slides(static_cast<int>(f)) && !canSlide) return false;
  }
  caps_ = caps;
  findTimes();
  for (std::size_t i = 1; i + 1 < times_.size(); ++i)
    between_.emplace_back(body_.shape, path_.poseAt(times_[i]));
  posed_.push_back(&start);
  for (const PosedBody& posed : between_) posed_.push_back(&posed);
  posed_.push_back(&end);
  for (std::size_t v = 0; v < paths_.size(); ++v) {
    if (!makePaths(static_cast<int>(v))) return false;
  }
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    appendSheets(static_cast<int>(e));
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
      if (graze.reaches(time)) appendContactCurves(graze, time);
    }
    for (const Graze& next : grazes_) {
      appendChange(graze, next);
      appendSeam(graze, next);
      appendMoment(graze, next);
    }
  }
  appendRegressions();
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    for (const int time : {0, 1}) appendContactsOfCap(static_cast<int>(f), time);
  }
  return true;
}

const TurningStep::Graze* TurningStep::grazeAt(int surface, const Vector3d& p, int time) const {
  const ContactCurves& curves = curves_[surface];
  const int curve = curves.curveOf(p, time);
  const auto found = std::find_if(grazes_.begin(), grazes_.end(), [&](const Graze& graze) {
    return graze.surface == surface && graze.curve == curve && graze.reaches(time);
  });
  return found == grazes_.end() ? nullptr : &*found;
}

std::vector<Vector3d> TurningStep::contactsOnBorder(int f, double s) const {
  std::vector<Vector3d> contacts;
  for (const int e : body_.faces[f].edges) {
    const BodyEdge& edge = body_.edges[e];
    const OfTwo speed = motion_.speedOn(edge, f);
    for (const double u : zerosOf([&](double x) { return speed({x, s}); }, edge.range))
      contacts.push_back(edge.at(u));
  }
  return contacts;
}

void TurningStep::appendContactsOfCap(int f, int time) {
  const int surface = body_.faces[f].surface;
  if (body_.surfaces[surface].isPlane() || motion_.slides(f)) return;
  std::vector<gp_Pnt> atBorder;
  for (const Vector3d& p : contactsOnBorder(f, time))
    atBorder.push_back(pointOf(motion_.at(p, time)));
  const Moment moment(path_, time);
  const auto seen = [&](const gp_Pnt& p) {
    return moment.placement.applyInverse(vectorOf(p.XYZ()));
  };
  const Velocity velocity = [&](const gp_Pnt& p) {
    return vecOf(moment.placement.rotation * moment.velocityAt(seen(p)));
  };
  const int cap = (*caps_[time])[f];
  for (const TopoDS_Edge& edge : contactsWithin(to_.faces[cap].face, velocity, atBorder)) {
    const BRepAdaptor_Curve curve(edge);
    const gp_Pnt middle = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    if (grazeAt(surface, seen(middle), time) == nullptr) to_.dividers.push_back({edge, {cap}});
  }
}

void TurningStep::addPathsTo(FixedSurfaces& fixed, std::size_t step) const {
  const auto add = [&](int surface, int vertex) {
    for (const VertexPath& path : paths_[vertex]) fixed.add(surface, path.path);
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
    fixed.add(plane, posed_.front()->of(body_.edges[e]));
    fixed.add(plane, posed_.back()->of(body_.edges[e]));
    for (const int v : {body_.edges[e].from, body_.edges[e].to}) add(plane, v);
  }
}

bool TurningStep::doesSweep(const BodyEdge& edge) const {
  return body_.isConvex(edge) && motion_.isOutline(edge) && !motion_.planeOf(edge);
}

void TurningStep::findTimes() {
  constexpr double kOneTime = 1e-6;
  paths_.resize(body_.vertices.Extent());
  sheets_.resize(body_.edges.size());
  // Parts of one curve are cut at the same times: those of edges between the same surfaces.
  using Surfaces = std::pair<int, int>;
  const auto surfacesAt = [&](const BodyEdge& edge) -> Surfaces {
    return std::minmax({body_.faces[edge.faces[0]].surface, body_.faces[edge.faces[1]].surface});
  };
  std::map<Surfaces, std::vector<double>> cuts;
  std::vector<char> sweeps(body_.edges.size());
  times_ = {0, 1};
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    const BodyEdge& edge = body_.edges[e];
    sweeps[e] = doesSweep(edge);
    if (!sweeps[e]) continue;
    std::vector<double> found = motion_.pinchesOf(edge);
    const auto crossings = crossingTimes(
        [&](double u, double s) { return motion_.at(edge.at(u), s); }, edge.range, found);
    found.insert(found.end(), crossings.begin(), crossings.end());
    std::vector<double>& all = cuts[surfacesAt(edge)];
    all.insert(all.end(), found.begin(), found.end());
    times_.insert(times_.end(), found.begin(), found.end());
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end(),
                           [](double a, double b) { return b - a < kOneTime; }),
               times_.end());
  times_.back() = 1;
  const int last = static_cast<int>(times_.size()) - 1;
  std::vector<std::set<int>> ofVertex(paths_.size(), {0, last});
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    const BodyEdge& edge = body_.edges[e];
    if (!sweeps[e]) continue;
    std::set<int> own{0, last};
    for (const double s : cuts[surfacesAt(edge)]) {
      const auto after = std::lower_bound(times_.begin(), times_.end(), s - kOneTime);
      own.insert(std::min(last, static_cast<int>(after - times_.begin())));
    }
    for (const int v : {edge.from, edge.to}) ofVertex[v].insert(own.begin(), own.end());
    for (auto it = own.begin(); std::next(it) != own.end(); ++it)
      sheets_[e].push_back({*it, *std::next(it), -1});
  }
  for (std::size_t v = 0; v < paths_.size(); ++v) {
    for (auto it = ofVertex[v].begin(); std::next(it) != ofVertex[v].end(); ++it)
      paths_[v].push_back({*it, *std::next(it), {}});
  }
}

bool TurningStep::makePaths(int vertex) {
  const BRep_Builder builder;
  const Vector3d p = body_.point(vertex);
  const TopoDS_Shape& shape = body_.vertices(vertex + 1);
  for (VertexPath& path : paths_[vertex]) {
    path.path = fittedEdge([&](double t) { return motion_.at(p, t / motion_.length()); },
                           motion_.timeOf(between(path.from, path.to)));
    if (path.path.IsNull()) return false;
    builder.Add(path.path, posed_[path.from]->of(shape).Oriented(TopAbs_FORWARD));
    builder.Add(path.path, posed_[path.to]->of(shape).Oriented(TopAbs_REVERSED));
  }
  return true;
}

void TurningStep::appendSheets(int e) {
  if (sheets_[e].empty()) return;
  const BodyEdge& edge = body_.edges[e];
  const Knots line(1, {edge.range.from, edge.range.to});
  const auto fitted = fitSheet(
      [&](double u, double t) { return motion_.at(edge.at(u), t / motion_.length()); }, edge.range,
      {0, motion_.length()}, edge.isStraight ? &line : nullptr, kSurfaceBound, kMaxTurningPoles);
  if (!fitted) return;
  for (SheetPart& part : sheets_[e]) {
    // The whole surface may intersect itself. The kernel would find points on the wrong part.
    const Handle(Geom_Surface) surface =
        kernelSheet(fitted->sheet->part(edge.range, motion_.timeOf(between(part.from, part.to))));
    part.face = static_cast<int>(to_.faces.size());
    SweptFace& added = to_.faces.emplace_back();
    added.face = sheetOf(edge, part, surface);
    added.conditions.push_back(conditions_.ofSheet(e));
  }
}

TopoDS_Face TurningStep::sheetOf(const BodyEdge& edge, const SheetPart& part,
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
  const auto addPaths = [&](int vertex, bool isForward, double u) {
    for (const VertexPath& path : paths_[vertex]) {
      if (path.from >= part.from && path.to <= part.to)
        add(path.path, isForward, {u, motion_.timeOf(times_[path.from])}, {0, 1});
    }
  };
  const Range t = motion_.timeOf(between(part.from, part.to));
  add(posed_[part.from]->of(edge), true, {edge.range.from, t.from}, {1, 0});
  addPaths(edge.to, true, edge.range.to);
  add(posed_[part.to]->of(edge), false, {edge.range.from, t.to}, {1, 0});
  addPaths(edge.from, false, edge.range.from);
  wire.Closed(Standard_True);
  builder.Add(face, wire);
  return face;
}

void TurningStep::findContacts(int e) {
  const BodyEdge& edge = body_.edges[e];
  if (body_.isWithinSurface(edge)) return;
  std::vector<SheetPart> parts = sheets_[e];
  if (parts.empty()) parts.push_back({0, static_cast<int>(times_.size()) - 1, -1});
  for (const int f : edge.faces) {
    const ContactCurves& curves = curves_[body_.faces[f].surface];
    if (curves.count() == 0 && body_.surfaceOf(f).isPlane()) continue;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Range part = between(parts[i].from, parts[i].to);
      const std::vector<double>& changes = curves.changes();
      for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
        const Range within{std::max(part.from, changes[k]), std::min(part.to, changes[k + 1])};
        if (within.length() > kSameTime) findContacts(e, f, i, within);
      }
    }
  }
}

void TurningStep::findContacts(int e, int f, std::size_t part, Range within) {
  const BodyEdge& edge = body_.edges[e];
  const ContactCurves& curves = curves_[body_.faces[f].surface];
  for (const ZeroArc& arc : motion_.contactsOf(edge, f, within)) {
    const std::vector<double> cuts = cutsOf(arc, edge, curves, within);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Range along{cuts[i], cuts[i + 1]};
      const Vector2d middle = arc.at(along.at(0.5));
      const int curve = curves.curveOf(edge.at(middle.x()), middle.y());
      Range s{HUGE_VAL, -HUGE_VAL}, w = s;
      constexpr int kPoints = 16;
      for (int j = 0; j <= kPoints; ++j) {
        const Vector2d on = arc.at(along.at(static_cast<double>(j) / kPoints));
        s = s.with(std::clamp(on.y(), within.from, within.to));
        if (curve != ContactCurves::kNoCurve)
          w = w.with(curves.positionAt(curve, edge.at(on.x()), on.y()));
      }
      contacts_.push_back({e, f, curve, part, arc, along, s, w});
    }
  }
}

std::vector<double> TurningStep::cutsOf(const ZeroArc& arc, const BodyEdge& edge,
                                        const ContactCurves& curves, Range within) const {
  constexpr double kNear = 0.1;  // of x: elsewhere, the offset jumps by a whole turn
  const Range whole = arc.range();
  std::vector<double> cuts{whole.from, whole.to};
  for (int curve = 0; curve < curves.count(); ++curve) {
    const Range& times = curves.times(curve);
    if (!curves.isPart(curve) || times.to <= within.from || times.from >= within.to) continue;
    for (const bool isEnd : {false, true}) {
      const auto offset = [&](double t) {
        const Vector2d on = arc.at(t);
        return curves.offsetFromEnd(curve, isEnd, edge.at(on.x()), on.y());
      };
      for (const double t : zerosOf(offset, whole)) {
        if (std::abs(offset(t)) > kNear) continue;
        const double s = arc.at(t).y();
        if (s >= times.from && s <= times.to) cuts.push_back(t);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(),
                         [](double a, double b) { return b - a < Precision::Confusion(); }),
             cuts.end());
  cuts.back() = whole.to;
  return cuts;
}

}  // namespace swept::step
