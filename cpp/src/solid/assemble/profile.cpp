// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/profile.h"

#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

namespace swept::step {
namespace {

/// mm: how far polylines may lie off their curves.
constexpr double kChord = 1e-3;
/// mm: curves closer than this meet.
constexpr double kMeet = 1e-7;

// Moves both parameters to the crossing. Nothing if there is none nearby.
std::optional<Crossing> refined(const PlaneProfile& a, const PlaneProfile& b, Crossing at,
                                const Projection& projection) {
  constexpr int kRounds = 12;
  constexpr double kExact = 1e-10;           // mm
  constexpr double kMinCrossingSine = 1e-5;  // of the angle at which the curves cross
  double distance = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    gp_Pnt p, q;
    gp_Vec alongA, alongB;
    a.curve.D1(at.a, p, alongA);
    b.curve.D1(at.b, q, alongB);
    const gp_Vec2d off = projection.of(gp_Vec(p, q));
    const gp_Vec2d u = projection.of(alongA), v = projection.of(alongB);
    const double cross = u.Crossed(v);
    if (std::abs(cross) <= kMinCrossingSine * u.Magnitude() * v.Magnitude()) return std::nullopt;
    distance = off.Magnitude();
    if (distance < kExact) return at;
    const Crossing next{std::clamp(at.a + off.Crossed(v) / cross, a.from(), a.to()),
                        std::clamp(at.b + off.Crossed(u) / cross, b.from(), b.to())};
    if (next.a == at.a && next.b == at.b) break;
    at = next;
  }
  if (projection.of(gp_Vec(a.curve.Value(at.a), b.curve.Value(at.b))).Magnitude() < kMeet)
    return at;
  return std::nullopt;
}

// Returns how far the curves are apart between two crossings, at most.
double distanceBetween(const PlaneProfile& a, const PlaneProfile& b, const Crossing& from,
                       const Crossing& to, const Projection& projection) {
  double largest = 0;
  for (const double w : {0.25, 0.5, 0.75}) {
    const gp_Pnt2d p = projection.of(a.curve.Value(from.a + w * (to.a - from.a)));
    const double t = b.footOf(p, from.b + w * (to.b - from.b), projection);
    largest = std::max(largest, projection.of(b.curve.Value(t)).Distance(p));
  }
  return largest;
}

// Two curves that are tangent at a common end have no certain crossing near it, as edges of bodies
// from files are not exact. Returns the common end instead.
Crossing atCommonEnd(const PlaneProfile& a, const PlaneProfile& b, const Crossing& at,
                     const Projection& projection) {
  constexpr double kTangent = 0.05;  // sine
  // mm: distances of the crossing from the common end. At a cusp, nothing is tangent.
  constexpr double kAtEnd = 1e-5, kNear = 1e-3, kTangentNear = 0.3;
  // mm: distances of points that are the same, and of curves that cross by errors of the file only.
  constexpr double kCommon = 1e-6, kSame = 2e-4;
  gp_Pnt p, q;
  gp_Vec alongA, alongB;
  a.curve.D1(at.a, p, alongA);
  b.curve.D1(at.b, q, alongB);
  const gp_Vec2d u = projection.of(alongA), v = projection.of(alongB);
  const bool isTangent = std::abs(u.Crossed(v)) <= kTangent * u.Magnitude() * v.Magnitude();
  const gp_Pnt2d seen = projection.of(p);
  for (const bool lastA : {false, true}) {
    const gp_Pnt2d& endA = lastA ? a.corners.back() : a.corners.front();
    const double distance = endA.Distance(seen);
    if (distance > (isTangent ? kTangentNear : kNear)) continue;
    for (const bool lastB : {false, true}) {
      const gp_Pnt2d& endB = lastB ? b.corners.back() : b.corners.front();
      const Crossing end{lastA ? a.to() : a.from(), lastB ? b.to() : b.from()};
      const TopoDS_Vertex vertex = a.endVertex(lastA);
      const bool isCommon =
          endA.Distance(endB) < kCommon || (!vertex.IsNull() && vertex.IsSame(b.endVertex(lastB)));
      if (!isCommon) continue;
      if (distance <= (isTangent ? kNear : kAtEnd)) return end;
      const double same = vertex.IsNull() ? kSame : kSame + 2 * BRep_Tool::Tolerance(vertex);
      if (isTangent && distanceBetween(a, b, end, at, projection) < same) return end;
    }
  }
  return at;
}

ProfileBox boxOf(const PlaneProfile& profile, std::size_t segment) {
  ProfileBox box;
  box.add(profile.corners[segment]);
  box.add(profile.corners[segment + 1]);
  return box;
}

// Returns the parameters at which two segments cross, or the ends next to it. Nothing if they are
// too far apart.
std::optional<Crossing> crossingOf(const PlaneProfile& a, std::size_t i, const PlaneProfile& b,
                                   std::size_t j) {
  const gp_Vec2d u(a.corners[i], a.corners[i + 1]), v(b.corners[j], b.corners[j + 1]);
  const gp_Vec2d off(a.corners[i], b.corners[j]);
  const double cross = u.Crossed(v);
  double s = 0.5, t = 0.5;
  if (std::abs(cross) > 1e-12 * u.Magnitude() * v.Magnitude()) {
    s = off.Crossed(v) / cross;
    t = off.Crossed(u) / cross;
    const double beyondU = 2 * kChord / std::max(u.Magnitude(), 1e-9);
    const double beyondV = 2 * kChord / std::max(v.Magnitude(), 1e-9);
    if (s < -beyondU || s > 1 + beyondU || t < -beyondV || t > 1 + beyondV) return std::nullopt;
  }
  const auto between = [](const PlaneProfile& profile, std::size_t k, double part) {
    const double from = profile.parameters[k], to = profile.parameters[k + 1];
    return from + std::clamp(part, 0.0, 1.0) * (to - from);
  };
  return Crossing{between(a, i, s), between(b, j, t)};
}

}  // namespace

void ProfileBox::add(const gp_Pnt2d& p) {
  low = {std::min(low.X(), p.X()), std::min(low.Y(), p.Y())};
  high = {std::max(high.X(), p.X()), std::max(high.Y(), p.Y())};
}

void ProfileBox::add(const ProfileBox& box) {
  add(box.low);
  add(box.high);
}

bool ProfileBox::overlaps(const ProfileBox& box) const {
  constexpr double kBoxMargin = 2 * kChord;
  return low.X() <= box.high.X() + kBoxMargin && box.low.X() <= high.X() + kBoxMargin &&
         low.Y() <= box.high.Y() + kBoxMargin && box.low.Y() <= high.Y() + kBoxMargin;
}

PlaneProfile::PlaneProfile(const TopoDS_Edge& e, const Projection& projection) : edge(e), curve(e) {
  constexpr double kTurn = 0.05;  // rad, between segments
  constexpr int kMinPoints = 9;
  const GCPnts_TangentialDeflection points(curve, kTurn, kChord, kMinPoints);
  for (int i = 1; i <= points.NbPoints(); ++i) {
    parameters.push_back(points.Parameter(i));
    corners.push_back(projection.of(points.Value(i)));
    box.add(corners.back());
    if (i > 1) length += points.Value(i).Distance(points.Value(i - 1));
  }
}

bool PlaneProfile::isEnd(double t) const {
  const double least = 1e-9 * (to() - from());
  return t - from() < least || to() - t < least;
}

TopoDS_Vertex PlaneProfile::endVertex(bool isLast) const {
  TopoDS_Vertex first, last;
  TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
  return isLast ? last : first;
}

gp_Pnt PlaneProfile::pointAt(double t) const {
  if (!isEnd(t)) return curve.Value(t);
  const TopoDS_Vertex vertex = endVertex(2 * t > from() + to());
  return vertex.IsNull() ? curve.Value(t) : BRep_Tool::Pnt(vertex);
}

double PlaneProfile::footOf(const gp_Pnt2d& p, double t, const Projection& projection) const {
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    gp_Pnt q;
    gp_Vec along;
    curve.D1(t, q, along);
    const gp_Vec2d off(projection.of(q), p), slope = projection.of(along);
    if (slope.SquareMagnitude() <= gp::Resolution()) break;
    t = std::clamp(t + off.Dot(slope) / slope.SquareMagnitude(), from(), to());
  }
  return t;
}

std::vector<Crossing> crossingsOf(const PlaneProfile& a, const PlaneProfile& b,
                                  const Projection& projection) {
  std::vector<Crossing> found;
  if (!a.box.overlaps(b.box)) return found;
  for (std::size_t i = 0; i + 1 < a.corners.size(); ++i) {
    const ProfileBox box = boxOf(a, i);
    if (!box.overlaps(b.box)) continue;
    for (std::size_t j = 0; j + 1 < b.corners.size(); ++j) {
      if (!box.overlaps(boxOf(b, j))) continue;
      const auto start = crossingOf(a, i, b, j);
      if (!start) continue;
      const auto crossing = refined(a, b, *start, projection);
      if (crossing) found.push_back(atCommonEnd(a, b, *crossing, projection));
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Crossing& p, const Crossing& q) { return p.a < q.a; });
  const double leastA = 1e-9 * (a.to() - a.from()), leastB = 1e-9 * (b.to() - b.from());
  std::vector<Crossing> result;
  for (const Crossing& c : found) {
    const bool isKnown = std::any_of(result.begin(), result.end(), [&](const Crossing& k) {
      return std::abs(k.a - c.a) <= leastA && std::abs(k.b - c.b) <= leastB;
    });
    if (!isKnown) result.push_back(c);
  }
  return result;
}

}  // namespace swept::step
