// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/mesh_sections.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Message_ProgressScope.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/meshed_faces.h"
#include "solid/assemble/section_tracer.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Times the smallest detail: how far triangles lie from the faces.
constexpr double kTriangleDeflection = 10;

// A curve that lies on faces, and is to be cut.
struct FaceCurve {
  TopoDS_Edge edge;
  std::vector<int> faces;
  bool isDivider = false, isFold = false;

  bool liesOn(int f) const { return std::find(faces.begin(), faces.end(), f) != faces.end(); }
  gp_Pnt middle() const {
    double from, to;
    const Handle(Geom_Curve) along = BRep_Tool::Curve(edge, from, to);
    return along->Value((from + to) / 2);
  }
  double length() const { return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)); }
};

Handle(Geom_Curve) curveOf(const TopoDS_Edge& edge) {
  double from, to;
  return BRep_Tool::Curve(edge, from, to);
}

bool isNear(const gp_Pnt& p, const TopoDS_Edge& edge, double distance) {
  double from, to;
  const Handle(Geom_Curve) along = BRep_Tool::Curve(edge, from, to);
  const GeomAPI_ProjectPointOnCurve foot(p, along, from, to);
  return (foot.NbPoints() > 0 && foot.LowerDistance() < distance) ||
         p.Distance(along->Value(from)) < distance || p.Distance(along->Value(to)) < distance;
}

class Finder {
 public:
  Finder(const std::vector<SweptFace>& faces, const Sides& sides)
      : faces_(faces, kTriangleDeflection * sides.detail()), sides_(sides) {}

  std::vector<SweptSection> find(const std::vector<SweptSection>& dividers,
                                 const std::vector<SweptSection>& folds,
                                 const std::vector<gp_Pnt>& crossings,
                                 const Message_ProgressRange& progress) {
    for (const SweptSection& divider : dividers)
      dividers_.push_back({divider.edge, divider.faces, true});
    for (const SweptSection& fold : folds) dividers_.push_back({fold.edge, fold.faces, true, true});
    addVertices(crossings);
    certain_ = events_.size();
    Message_ProgressScope scope(progress, "", 4);
    followChains(scope.Next());
    addPiercings(borders(), true, scope.Next());
    addCrossings();
    addPiercings(dividers_, true, scope.Next());
    certain_ = events_.size();
    std::vector<FaceCurve> sections;
    for (const auto& [pair, found] : sections_)
      sections.insert(sections.end(), found.begin(), found.end());
    addPiercings(sections, false, scope.Next());
    if (scope.UserBreak()) return {};
    std::vector<SweptSection> result;
    for (const FaceCurve& curve : dividers_) appendParts(curve, result);
    for (const FaceCurve& curve : sections) appendParts(curve, result);
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      for (const TopoDS_Edge& edge : faces_.innerEdges(f)) appendParts({edge, {f}, true}, result);
    }
    return result;
  }

 private:
  void addVertices(const std::vector<gp_Pnt>& crossings) {
    TopTools_IndexedMapOfShape vertices;
    for (int e = 1; e <= faces_.edges().Extent(); ++e)
      TopExp::MapShapes(faces_.edges()(e), TopAbs_VERTEX, vertices);
    for (int v = 1; v <= vertices.Extent(); ++v)
      events_.push_back(vectorOf(BRep_Tool::Pnt(TopoDS::Vertex(vertices(v))).XYZ()));
    for (const gp_Pnt& p : crossings) events_.push_back(vectorOf(p.XYZ()));
    for (const FaceCurve& divider : dividers_) {
      double from, to;
      const Handle(Geom_Curve) along = BRep_Tool::Curve(divider.edge, from, to);
      for (const double t : {from, to}) events_.push_back(vectorOf(along->Value(t).XYZ()));
    }
  }

  std::vector<FaceCurve> borders() const {
    std::vector<FaceCurve> result;
    for (int e = 1; e <= faces_.edges().Extent(); ++e) {
      FaceCurve& border = result.emplace_back();
      border.edge = faces_.edge(e);
      for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
        if (faces_.hasEdge(f, e)) border.faces.push_back(f);
      }
    }
    return result;
  }

  SectionTracer tracerOf(int a, int b) const {
    // mm: where faces cross at a common edge, Newton's method finds points of the edge exactly;
    // where they are tangent along a divider, it does not.
    constexpr double kCrossing = 1e-5, kTangent = 1e-3;
    constexpr double kAnySine = HUGE_VAL, kTangentSine = 2e-3;
    std::vector<SharedCurve> shared;
    std::vector<std::pair<int, TopoDS_Edge>> folds;
    // Fixed surfaces may cross between their common edges, too.
    const bool areFixed = !faces_.innerEdges(a).empty() && !faces_.innerEdges(b).empty();
    for (const int e : faces_.edgesOf(a)) {
      if (!areFixed && faces_.hasEdge(b, e))
        shared.push_back({curveOf(faces_.edge(e)), kCrossing, kAnySine});
    }
    for (const FaceCurve& divider : dividers_) {
      if (divider.liesOn(a) && divider.liesOn(b))
        shared.push_back({curveOf(divider.edge), kTangent, kTangentSine});
      if (divider.isFold) {
        if (divider.liesOn(a)) folds.emplace_back(0, divider.edge);
        if (divider.liesOn(b)) folds.emplace_back(1, divider.edge);
      }
    }
    return {faces_, a, b, std::move(shared), std::move(folds), events_};
  }

  // Makes sections from the chains of the triangulations.
  void followChains(const Message_ProgressRange& progress) {
    std::map<std::pair<int, int>, std::vector<std::vector<Piercing>>> chains;
    for (FaceChain& chain : faces_.chains()) {
      const bool isPossible =
          std::any_of(chain.points.begin(), chain.points.end(), [&](const Piercing& p) {
            return faces_.isPossible(chain.a, p.on[0]) && faces_.isPossible(chain.b, p.on[1]);
          });
      if (isPossible) chains[{chain.a, chain.b}].push_back(std::move(chain.points));
    }
    std::vector<Vector3d> ends;
    Message_ProgressScope scope(progress, "", static_cast<double>(chains.size()));
    for (const auto& [pair, found] : chains) {
      if (scope.UserBreak()) return;
      scope.Next();
      SectionTracer tracer = tracerOf(pair.first, pair.second);
      std::vector<FaceCurve>& sections = sections_[pair];
      for (SectionTracer::Run& run : tracer.runsOf(found)) {
        for (const bool isFirst : {true, false}) {
          if (isFirst ? run.isFirstExact : run.isLastExact)
            ends.push_back(isFirst ? run.points.front().at : run.points.back().at);
        }
        const gp_Pnt middle = pointOf(run.points[run.points.size() / 2].at);
        const bool isKnown = std::any_of(
            sections.begin(), sections.end(),
            [&](const FaceCurve& known) { return isNear(middle, known.edge, kOneCurve); });
        if (isKnown) continue;
        const TopoDS_Edge edge = tracer.edgeAlong(std::move(run));
        if (!edge.IsNull()) addTo(sections, {edge, {pair.first, pair.second}});
      }
      ends.insert(ends.end(), tracer.ends().begin(), tracer.ends().end());
    }
    events_.insert(events_.end(), ends.begin(), ends.end());
  }

  // Makes the section through a point where a border or divider of face a passes through face b.
  void startAt(int a, int b, const Vector3d& p, const std::array<Vector2d, 2>& on) {
    if (faces_.areOfOneGroup(a, b)) return;
    if (!faces_.isPossible(a, on[0]) || !faces_.isPossible(b, on[1])) return;
    std::vector<FaceCurve>& sections = sections_[std::minmax(a, b)];
    const bool isKnown = std::any_of(sections.begin(), sections.end(), [&](const FaceCurve& known) {
      return isNear(pointOf(p), known.edge, kOneCurve);
    });
    if (isKnown) return;
    const TopoDS_Edge edge = tracerOf(a, b).edgeThrough(p, on);
    if (!edge.IsNull()) addTo(sections, {edge, {a, b}});
  }

  // Adds a section, unless it is a part of a longer one. Shorter ones along it are parts of it.
  static void addTo(std::vector<FaceCurve>& sections, const FaceCurve& added) {
    const double length = added.length();
    const gp_Pnt middle = added.middle();
    const bool isPart = std::any_of(sections.begin(), sections.end(), [&](const FaceCurve& known) {
      return isNear(middle, known.edge, kOneCurve) && known.length() >= length;
    });
    if (isPart) return;
    sections.erase(std::remove_if(sections.begin(), sections.end(),
                                  [&](const FaceCurve& known) {
                                    return isNear(known.middle(), added.edge, kOneCurve);
                                  }),
                   sections.end());
    sections.push_back(added);
  }

  // Adds an event where a curve passes through a face. It is less certain, the smaller the sine of
  // the angle is. Does nothing if it may be a known one.
  void addEvent(const Vector3d& p, double sine) {
    const double uncertainty = uncertaintyOf(sine);
    for (std::size_t i = 0; i < events_.size(); ++i) {
      if ((events_[i] - p).norm() < (i < certain_ ? uncertainty : kSamePoint)) return;
    }
    events_.push_back(p);
  }

  void addPiercings(const std::vector<FaceCurve>& curves, bool isStart,
                    const Message_ProgressRange& progress) {
    Message_ProgressScope scope(progress, "", static_cast<double>(curves.size()));
    for (const FaceCurve& curve : curves) {
      if (scope.UserBreak()) return;
      addPiercings(curve, isStart);
      scope.Next();
    }
  }

  // Returns the parameters of a point of a curve on one of its faces; nothing if they are unknown.
  std::optional<Vector2d> parametersOn(int f, const FaceCurve& curve, double t) const {
    const Handle(Geom2d_Curve) flat = faces_.curveOn(f, curve.edge);
    if (flat.IsNull()) return std::nullopt;
    const gp_Pnt2d on = flat->Value(t);
    return Vector2d(on.X(), on.Y());
  }

  // Returns whether a point of a curve belongs to a face of the curve.
  bool isOwned(const FaceCurve& curve, double t) const {
    return std::any_of(curve.faces.begin(), curve.faces.end(), [&](int f) {
      const auto on = parametersOn(f, curve, t);
      return !on || faces_.doesOwn(f, *on);
    });
  }

  // Finds where a curve passes through faces on which it does not lie. `isStart`: whether sections
  // begin there.
  void addPiercings(const FaceCurve& curve, bool isStart) {
    constexpr int kPieces = 100;
    constexpr double kSlack = 0.05;    // of a piece
    constexpr double kMinSine = 1e-7;  // otherwise the curve lies in the face
    const BRepAdaptor_Curve along(curve.edge);
    const double from = along.FirstParameter(), to = along.LastParameter(),
                 piece = (to - from) / kPieces;
    for (int i = 0; i < kPieces; ++i) {
      const double start = from + i * piece, end = start + piece;
      const auto near =
          faces_.near(vectorOf(along.Value(start).XYZ()), vectorOf(along.Value(end).XYZ()));
      for (const auto& [face, on] : near) {
        if (curve.liesOn(face)) continue;
        const auto found = throughFace(faces_, face, along, (start + end) / 2, on);
        if (!found || found->first < start - kSlack * piece ||
            found->first > end + kSlack * piece || found->first <= from || found->first >= to ||
            !faces_.isInFace(face, found->second) || !faces_.doesOwn(face, found->second) ||
            !isOwned(curve, found->first))
          continue;
        gp_Pnt p;
        gp_Vec tangent;
        along.D1(found->first, p, tangent);
        const Vector3d at = vectorOf(p.XYZ());
        const double sine = std::abs(
            faces_.jet(face, found->second).normal().dot(vectorOf(tangent.XYZ()).normalized()));
        if (sine < kMinSine) continue;
        addEvent(at, sine);
        if (!isStart || curve.isFold) continue;
        for (const int f : curve.faces) {
          if (const auto own = parametersOn(f, curve, found->first))
            startAt(f, face, at, {*own, found->second});
        }
      }
    }
  }

  // Finds where borders of other faces cross each other on a face.
  void addCrossings() {
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      std::vector<Handle(Geom2d_Curve)> curves;
      std::vector<Bnd_Box2d> boxes;
      for (const TopoDS_Edge& edge : faces_.innerEdges(f)) {
        double from, to;
        BRep_Tool::Range(edge, from, to);
        curves.push_back(new Geom2d_TrimmedCurve(faces_.curveOn(f, edge), from, to));
        BndLib_Add2dCurve::Add(curves.back(), from, to, Precision::Confusion(),
                               boxes.emplace_back());
        for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
          if (!boxes[i].IsOut(boxes.back())) addCrossings(f, curves[i], curves.back());
        }
      }
    }
  }

  void addCrossings(int face, const Handle(Geom2d_Curve) & a, const Handle(Geom2d_Curve) & b) {
    constexpr double kExact = 1e-9;  // mm
    const Geom2dAPI_InterCurveCurve crossing(a, b, kExact);
    for (int i = 1; i <= crossing.NbPoints(); ++i) {
      const IntRes2d_IntersectionPoint& point = crossing.Intersector().Point(i);
      const gp_Vec2d u = a->DN(point.ParamOnFirst(), 1), v = b->DN(point.ParamOnSecond(), 1);
      const Vector2d on(point.Value().X(), point.Value().Y());
      addEvent(faces_.jet(face, on).at, std::abs(u.Crossed(v)) / (u.Magnitude() * v.Magnitude()));
    }
  }

  // Returns the parameters at which a curve is cut, with those of its ends.
  std::vector<double> cutsOf(const FaceCurve& curve) const {
    constexpr int kPieces = 64;
    constexpr double kTwins = 5 * kSamePoint;
    double from, to;
    const Handle(Geom_Curve) along = BRep_Tool::Curve(curve.edge, from, to);
    std::vector<Vector3d> polyline;
    Eigen::AlignedBox3d box;
    for (int i = 0; i <= kPieces; ++i) {
      polyline.push_back(vectorOf(along->Value(from + (to - from) * i / kPieces).XYZ()));
      box.extend(polyline.back());
    }
    const double margin = faces_.deflection() + 0.02 * box.diagonal().norm();
    const auto mayBeOn = [&](const Vector3d& p) {
      if (box.squaredExteriorDistance(p) > margin * margin) return false;
      for (int i = 0; i < kPieces; ++i) {
        const Vector3d step = polyline[i + 1] - polyline[i];
        const double w = std::clamp((p - polyline[i]).dot(step) / step.squaredNorm(), 0.0, 1.0);
        if ((polyline[i] + w * step - p).norm() < margin) return true;
      }
      return false;
    };
    std::vector<double> found{from};
    for (const Vector3d& event : events_) {
      if (!mayBeOn(event)) continue;
      const GeomAPI_ProjectPointOnCurve foot(pointOf(event), along, from, to);
      if (foot.NbPoints() > 0 && foot.LowerDistance() < kSamePoint)
        found.push_back(foot.LowerDistanceParameter());
    }
    std::sort(found.begin(), found.end());
    // Events at one place are one; the ends of the curve stay.
    const auto areTwins = [&](double s, double t) {
      return along->Value(s).Distance(along->Value(t)) < kTwins &&
             along->Value(s).Distance(along->Value((s + t) / 2)) < kTwins;
    };
    std::vector<double> cuts{from};
    for (const double t : found) {
      if (!areTwins(cuts.back(), t)) cuts.push_back(t);
    }
    if (cuts.size() > 1 && areTwins(cuts.back(), to)) cuts.pop_back();
    cuts.push_back(to);
    return cuts;
  }

  // Cuts a curve at all events, and appends the parts that are edges of the swept volume.
  void appendParts(const FaceCurve& curve, std::vector<SweptSection>& to) const {
    const std::vector<double> cuts = cutsOf(curve);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (!isVisible(curve, cuts[i], cuts[i + 1])) continue;
      TopoDS_Edge part = TopoDS::Edge(curve.edge.EmptyCopied());
      BRep_Builder().Range(part, cuts[i], cuts[i + 1]);
      to.push_back({part, curve.faces});
    }
  }

  bool contains(const Vector3d& p) const { return sides_.interior().contains(p); }

  // Returns whether the faces are tangent along a divider.
  bool haveDivider(int a, int b) const {
    return std::any_of(dividers_.begin(), dividers_.end(), [&](const FaceCurve& divider) {
      return divider.liesOn(a) && divider.liesOn(b);
    });
  }

  // Returns whether the middle of a part is on an edge of the swept volume; for a divider, whether
  // it is on its surface.
  bool isVisible(const FaceCurve& curve, double from, double to) const {
    constexpr double kFraction = 0.05;  // of the length of the part
    constexpr double kNearest = 2e-6;   // mm
    const BRepAdaptor_Curve along(curve.edge);
    const double t = (from + to) / 2;
    gp_Pnt at;
    gp_Vec forward;
    along.D1(t, at, forward);
    const double length = along.Value(from).Distance(at) + at.Distance(along.Value(to));
    if (kFraction * length < sides_.accuracy()) return true;  // samples cannot tell
    const double d = std::max(kNearest, std::min(sides_.distance(), kFraction * length));
    const Vector3d p = vectorOf(at.XYZ()), tangent = vectorOf(forward.XYZ()).normalized();
    std::vector<Vector3d> normals;
    for (const int f : curve.faces) {
      const auto on = parametersOn(f, curve, t);
      if (!on) return true;
      normals.push_back(faces_.jet(f, *on).normal());
    }
    if (curve.isDivider) {
      const Vector3d normal = normals.front(), side = normal.cross(tangent).normalized();
      // Some samples are near the face, as the swept volume may have a very sharp wedge there.
      int inside = 0, count = 0;
      for (const double slope : {0.1, 1.0, -1.0, -0.1}) {
        for (const double beside : {-1, 1}) {
          inside += contains(p + d * (slope * normal + beside * side));
          ++count;
        }
      }
      return inside > 0 && inside < count;
    }
    // Samples cannot tell whether two faces that are nearly tangent form an edge.
    constexpr double kTooFlat = 0.02;
    const bool isFlat = normals[0].cross(normals[1]).norm() < kTooFlat &&
                        !haveDivider(curve.faces[0], curve.faces[1]);
    const auto isVisibleAt = [&](double distance) {
      if (isFlat)
        return !contains(p + distance * normals[0]) || !contains(p - distance * normals[0]);
      return doBothEnd(p, distance, normals[0].cross(tangent).normalized(),
                       normals[1].cross(tangent).normalized());
    };
    // Other faces may be nearer than the samples.
    constexpr double kNearer = 0.1;
    return isVisibleAt(d) || (kNearer * d > sides_.accuracy() && isVisibleAt(kNearer * d));
  }

  // Returns whether both faces bound the swept volume beside the point. Of a face that does not,
  // the samples on both sides agree. `a`, `b`: directions in the faces.
  bool doBothEnd(const Vector3d& p, double distance, const Vector3d& a, const Vector3d& b) const {
    const auto sector = [&](const Vector3d& u, const Vector3d& v) {
      return sides_.isInSector(pointOf(p), vecOf(u), vecOf(v), distance);
    };
    // The four sectors between the faces, in their order around the edge.
    const bool first = sector(a, b), second = sector(b, -a), third = sector(-a, -b),
               fourth = sector(-b, a);
    const bool isA = first != fourth || second != third, isB = first != second || third != fourth;
    return isA && isB;
  }

  // mm: curves of the same two faces that are nearer than this are one.
  static constexpr double kOneCurve = 1e-4;

  const MeshedFaces faces_;
  const Sides& sides_;
  std::vector<FaceCurve> dividers_;
  std::map<std::pair<int, int>, std::vector<FaceCurve>> sections_;  // by two faces
  std::vector<Vector3d> events_;
  std::size_t certain_ = 0;  // events with a smaller index are more certain than new ones
};

}  // namespace

std::vector<SweptSection> meshSections(const std::vector<SweptFace>& faces,
                                       const std::vector<SweptSection>& dividers,
                                       const std::vector<SweptSection>& folds,
                                       const std::vector<gp_Pnt>& crossings, const Sides& sides,
                                       const Message_ProgressRange& progress) {
  return Finder(faces, sides).find(dividers, folds, crossings, progress);
}

}  // namespace swept::step
