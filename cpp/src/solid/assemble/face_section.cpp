// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/face_section.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Geom_BSplineCurve.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Lin.hxx>

namespace swept::step {
namespace {

/// mm: shorter sections are left out.
constexpr double kShortestSection = 1e-6;
/// Fraction of the length of the edge. Between two points, a section is shorter, or Newton's method
/// has found another part of the face.
constexpr double kMaxJump = 0.3;

// Returns the parameter of the edge at a fraction of the way between two ends. The steps get
// shorter towards the ends, where the section may be parallel to the move.
double parameterAt(double from, double to, double w) {
  return from + (to - from) * w * w * (3 - 2 * w);
}

// Returns the multiple of the period that is nearest to the difference.
double periods(double difference, bool isPeriodic, double period) {
  return isPeriodic ? period * std::round(difference / period) : 0;
}

TopoDS_Edge edgeOf(BRepBuilderAPI_MakeEdge maker) {
  return maker.IsDone() ? maker.Edge() : TopoDS_Edge();
}

// Returns the line through the points, if they lie on one.
TopoDS_Edge lineThrough(const std::vector<CurvePoint>& points) {
  const gp_Pnt &a = points.front().at, &b = points.back().at;
  constexpr double kMinChord = 1e-5;
  if (a.Distance(b) < kMinChord) return {};
  const gp_Lin line(a, gp_Dir(gp_Vec(a, b)));
  for (const CurvePoint& p : points) {
    if (line.Distance(p.at) > kCurveBound) return {};
  }
  return edgeOf(BRepBuilderAPI_MakeEdge(a, b));
}

// Returns indices of points that are not too near to each other, which would spoil the parameters
// of a spline. The first and the last one stay.
std::vector<std::size_t> apartFrom(const std::vector<gp_Pnt>& points, double length) {
  const double least = std::max(1e-5 * length, 3e-7);
  std::vector<std::size_t> apart{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].Distance(points[apart.back()]) < least) {
      if (i + 1 < points.size()) continue;
      if (apart.size() > 1) apart.pop_back();
    }
    apart.push_back(i);
  }
  return apart;
}

}  // namespace

bool FaceSection::solve(State& at, double t) const {
  constexpr int kRounds = 30, kPatience = 12;
  constexpr double kExact = 1e-11, kGood = 1e-9;  // mm
  at.t = t;
  const gp_Pnt c = profile_.curve.Value(t);
  const gp_Vec d(projection_.direction());
  for (int round = 0; round < kRounds; ++round) {
    gp_Pnt p;
    gp_Vec alongU, alongV;
    surface_.D1(at.u, at.v, p, alongU, alongV);
    const gp_Vec missing = d * at.along - gp_Vec(c, p);
    const gp_Vec n = alongU.Crossed(alongV);
    const double determinant = n.Dot(d), size = missing.Magnitude();
    if (size < (round > kPatience ? kGood : kExact)) return true;
    if (n.Magnitude() <= gp::Resolution() || std::abs(determinant) < 1e-14 * n.Magnitude())
      return false;
    at.u += missing.Dot(alongV.Crossed(d)) / determinant;
    at.v += missing.Dot(d.Crossed(alongU)) / determinant;
    at.along -= missing.Dot(n) / determinant;
  }
  return false;
}

gp_Vec FaceSection::normalOfFace(const State& at) const {
  gp_Pnt p;
  gp_Vec alongU, alongV;
  surface_.D1(at.u, at.v, p, alongU, alongV);
  return alongU.Crossed(alongV);
}

gp_Vec FaceSection::normalOfSwept(const State& at) const {
  gp_Pnt p;
  gp_Vec along;
  profile_.curve.D1(at.t, p, along);
  return along.Crossed(gp_Vec(projection_.direction()));
}

gp_Vec FaceSection::tangentAt(const State& at) const {
  const gp_Vec n = normalOfFace(at), m = normalOfSwept(at);
  // At a cusp, the edge runs along the move, and so does the section.
  constexpr double kCusp = 1e-4;
  gp_Pnt p;
  gp_Vec along;
  profile_.curve.D1(at.t, p, along);
  if (m.Magnitude() < kCusp * along.Magnitude()) return gp_Vec(projection_.direction());
  const double size = n.Magnitude() * m.Magnitude();
  return size <= gp::Resolution() ? gp_Vec() : n.Crossed(m) / size;
}

bool FaceSection::solveNear(const State& known, State& to, double t) const {
  to = known;
  const double most = kMaxJump * std::max(1e-3, profile_.length);
  return solve(to, t) && pointAt(to).Distance(pointAt(known)) < most;
}

// Where the face is nearly parallel to the move, small errors of the body become large ones.
double FaceSection::snapDistance(const State& at, double tolerance) const {
  const gp_Vec n = normalOfFace(at);
  const double sine = std::abs(n.Dot(gp_Vec(projection_.direction()))) / n.Magnitude();
  return 1e-3 + (1e-5 + 2 * tolerance) / std::max(sine, 1e-4);
}

const FaceSection::BorderPoint& FaceSection::nearestBorder(const End& end, const gp_Pnt& p) {
  return *std::min_element(end.border.begin(), end.border.end(),
                           [&](const BorderPoint& a, const BorderPoint& b) {
                             return a.at.SquareDistance(p) < b.at.SquareDistance(p);
                           });
}

FaceSection::State FaceSection::stateAt(const BorderPoint& point, double t,
                                        const State& known) const {
  const double u = point.on.X(), v = point.on.Y();
  const bool periodicU = surface_.IsUPeriodic(), periodicV = surface_.IsVPeriodic();
  return {t, u + periods(known.u - u, periodicU, periodicU ? surface_.UPeriod() : 0),
          v + periods(known.v - v, periodicV, periodicV ? surface_.VPeriod() : 0),
          gp_Vec(profile_.curve.Value(t), point.at).Dot(projection_.direction())};
}

bool FaceSection::moveToEnd(const State& known, State& to, const End& end) const {
  if (end.border.empty()) {
    if (end.other.first == nullptr) return false;
    const FaceSection other(*end.other.first, *this);
    if (!other.solveNear(known, to, end.other.second)) return false;
    to.t = end.t;
    return true;
  }
  const bool isFound = solveNear(known, to, end.t);
  const gp_Pnt expected = pointAt(isFound ? to : known);
  const BorderPoint& nearest = nearestBorder(end, expected);
  if (isFound && nearest.at.Distance(expected) >= snapDistance(to, nearest.tolerance)) return true;
  to = stateAt(nearest, end.t, known);
  return true;
}

bool FaceSection::snapToEnd(State& at, const End& end) const {
  if (end.border.empty()) return false;
  const gp_Pnt p = pointAt(at);
  const BorderPoint& nearest = nearestBorder(end, p);
  // mm: along a fillet with a radius of 2 mm, errors of 1e-4 mm hide that much of a section.
  constexpr double kMaxSnap = 0.02;
  if (nearest.at.Distance(p) >= std::min(kMaxSnap, snapDistance(at, nearest.tolerance)))
    return false;
  at = stateAt(nearest, end.t, at);
  return true;
}

bool FaceSection::follow(const State& known, State& to, const End& from, const End& until,
                         double wFrom, double wTo) const {
  constexpr int kTries = 200;
  constexpr double kLeastStep = 1e-7;
  if (wTo == 0 && moveToEnd(known, to, from)) return true;
  if (wTo == 1 && moveToEnd(known, to, until)) return true;
  State at = known;
  double w = wFrom, step = wTo - wFrom;
  for (int tries = 0; tries < kTries; ++tries) {
    const bool isLast = step == wTo - w;
    State next;
    if (solveNear(at, next, parameterAt(from.t, until.t, isLast ? wTo : w + step))) {
      at = next;
      w += step;
      if (isLast) {
        to = at;
        return true;
      }
      step = wTo - w;
    } else {
      step /= 2;
      if (std::abs(step) < kLeastStep) break;
    }
  }
  to = at;
  return false;
}

std::optional<std::vector<FaceSection::State>> FaceSection::statesAt(const std::vector<double>& ws,
                                                                     const End& from, const End& to,
                                                                     const State& middle) const {
  std::vector<State> states(ws.size());
  const std::size_t mid = std::lower_bound(ws.begin(), ws.end(), 0.5) - ws.begin();
  states[mid] = middle;
  if (!solve(states[mid], parameterAt(from.t, to.t, ws[mid]))) return std::nullopt;
  for (std::size_t i = mid + 1; i < ws.size(); ++i) {
    if (follow(states[i - 1], states[i], from, to, ws[i - 1], ws[i])) continue;
    if (!snapToEnd(states[i], to)) return std::nullopt;
    std::fill(states.begin() + i + 1, states.end(), states[i]);
    break;
  }
  for (std::size_t i = mid; i-- > 0;) {
    if (follow(states[i + 1], states[i], from, to, ws[i + 1], ws[i])) continue;
    if (!snapToEnd(states[i], from)) return std::nullopt;
    std::fill(states.begin(), states.begin() + i, states[i]);
    break;
  }
  return states;
}

std::vector<CurvePoint> FaceSection::pointsAt(const std::vector<State>& states) const {
  // Where both faces are tangent, the direction of the section follows from its other points.
  constexpr double kMinSine = 1e-6, kMinSineAtEnd = 1e-3;
  std::vector<CurvePoint> points;
  for (const State& state : states) points.push_back({pointAt(state), tangentAt(state)});
  const std::size_t last = points.size() - 1;
  std::vector<char> isKnown;
  for (std::size_t i = 0; i <= last; ++i) {
    const gp_Vec along(points[i == 0 ? 0 : i - 1].at, points[std::min(i + 1, last)].at);
    gp_Vec& tangent = points[i].tangent;
    isKnown.push_back(tangent.Magnitude() >= (i == 0 || i == last ? kMinSineAtEnd : kMinSine));
    if (!isKnown[i]) tangent = along;
    if (tangent.Magnitude() <= gp::Resolution()) return {};
    if (tangent.Dot(along) < 0) tangent.Reverse();
    tangent.Normalize();
  }
  // A chord of a parabola has the mean direction of both ends.
  for (const auto& [end, next] : {std::pair<std::size_t, std::size_t>(0, 1), {last, last - 1}}) {
    if (last < 2 || isKnown[end] || !isKnown[next]) continue;
    const gp_Vec chord = points[end].tangent;
    points[end].tangent = chord * (2 * chord.Dot(points[next].tangent)) - points[next].tangent;
  }
  return points;
}

std::optional<TopoDS_Edge> FaceSection::between(const End& from, const End& to,
                                                const State& middle) const {
  constexpr int kPieces = 16, kRounds = 6;
  std::vector<double> ws;
  for (int i = 0; i <= kPieces; ++i) ws.push_back(i / double(kPieces));
  for (int round = 0;; ++round) {
    const auto all = statesAt(ws, from, to, middle);
    if (!all) return std::nullopt;
    std::vector<gp_Pnt> places;
    for (const State& state : *all) places.push_back(pointAt(state));
    double length = 0;
    for (std::size_t i = 1; i < places.size(); ++i) length += places[i].Distance(places[i - 1]);
    if (length < kShortestSection) return std::nullopt;
    std::vector<State> states;
    std::vector<double> apart;
    for (const std::size_t i : apartFrom(places, length)) {
      states.push_back((*all)[i]);
      apart.push_back(ws[i]);
    }
    const std::vector<CurvePoint> points = pointsAt(states);
    if (points.empty()) return std::nullopt;
    const TopoDS_Edge line = lineThrough(points);
    if (!line.IsNull()) return line;
    std::vector<double> lengths;
    const Handle(Geom_BSplineCurve) curve = interpolated(points, lengths);
    if (curve.IsNull()) return std::nullopt;
    std::vector<double> finer;
    for (std::size_t k = 0; k < apart.size(); ++k) {
      finer.push_back(apart[k]);
      if (k + 1 == apart.size()) break;
      const gp_Pnt p = curve->Value((lengths[k] + lengths[k + 1]) / 2);
      if (!isOn(p, states[k], states[k + 1])) finer.push_back((apart[k] + apart[k + 1]) / 2);
    }
    if (finer.size() == apart.size() || round == kRounds) {
      const TopoDS_Edge edge = edgeOf(BRepBuilderAPI_MakeEdge(curve));
      if (edge.IsNull()) return std::nullopt;
      return edge;
    }
    ws = std::move(finer);
  }
}

bool FaceSection::isOn(const gp_Pnt& p, const State& a, const State& b) const {
  constexpr int kRounds = 8;
  const gp_Pnt2d seen = projection_.of(p);
  const double t = profile_.footOf(seen, (a.t + b.t) / 2, projection_);
  if (projection_.of(profile_.curve.Value(t)).Distance(seen) > kCurveBound) return false;
  double u = (a.u + b.u) / 2, v = (a.v + b.v) / 2;
  for (int round = 0; round < kRounds; ++round) {
    gp_Pnt q;
    gp_Vec alongU, alongV;
    surface_.D1(u, v, q, alongU, alongV);
    if (alongU.Crossed(alongV).SquareMagnitude() <= gp::Resolution()) return false;
    const gp_Vec2d step = parametersAlong(gp_Vec(q, p), alongU, alongV);
    u += step.X();
    v += step.Y();
  }
  return surface_.Value(u, v).Distance(p) <= kCurveBound;
}

}  // namespace swept::step
