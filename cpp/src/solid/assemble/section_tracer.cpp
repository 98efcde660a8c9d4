// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/section_tracer.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>

#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kNewtonRounds = 20;
constexpr double kNewtonBound = 1e-10;  // mm

Vector2d parameterStep(const Vector3d& step, const Jet& jet) {
  const gp_Vec2d on = parametersAlong(vecOf(step), vecOf(jet.u), vecOf(jet.v));
  return {on.X(), on.Y()};
}

// Returns whether a smooth curve may lead from one point to the other.
bool areConnected(const PointOnBoth& a, const PointOnBoth& b) {
  constexpr double kMinCosine = 0.97;
  const Vector3d secant = (b.at - a.at).normalized();
  return std::abs(secant.dot(a.tangent)) >= kMinCosine * a.sine &&
         std::abs(secant.dot(b.tangent)) >= kMinCosine * b.sine;
}

// Returns whether the curve turns back before the next point. At the end of an edge that sweeps one
// of the faces, two curves may leave a point of contact side by side; the triangles join them.
// Points of one curve may be in the wrong order, but they lie nearly in a line.
bool doesTurnBack(const std::vector<PointOnBoth>& points, const PointOnBoth& next) {
  // Of the angle. Points in the wrong order had up to 0.06, the two curves of a block 0.15.
  constexpr double kMinSine = 0.1;
  if (points.size() < 2) return false;
  const Vector3d last = points.back().at;
  const Vector3d before = (last - points[points.size() - 2].at).normalized(),
                 after = (next.at - last).normalized();
  return before.dot(after) < 0 && before.cross(after).norm() > kMinSine;
}

// Returns whether one of the faces turns back between the points.
bool isFoldBetween(const PointOnBoth& a, const PointOnBoth& b) {
  return a.jets[0].normal().dot(b.jets[0].normal()) < 0 ||
         a.jets[1].normal().dot(b.jets[1].normal()) < 0;
}

// Turns all tangents forward.
void orient(std::vector<PointOnBoth>& points) {
  double forward = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].tangent.dot(points[i - 1].tangent) < 0) points[i].tangent *= -1;
    forward += points[i].tangent.normalized().dot(points[i].at - points[i - 1].at);
  }
  if (forward >= 0) return;
  for (PointOnBoth& point : points) point.tangent *= -1;
}

void turnBack(std::vector<PointOnBoth>& points) {
  std::reverse(points.begin(), points.end());
  for (PointOnBoth& point : points) point.tangent *= -1;
}

// Removes points that are too near to the one before, or behind it. The ends stay.
void tidy(std::vector<PointOnBoth>& points) {
  orient(points);
  std::vector<PointOnBoth> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto isBehind = [&] {
      const PointOnBoth& last = kept.back();
      return (points[i].at - last.at).dot(last.tangent.normalized()) < kSamePoint;
    };
    const bool isLast = i + 1 == points.size();
    while (isLast && kept.size() > 1 && isBehind()) kept.pop_back();
    if (!isLast && !kept.empty() && isBehind()) continue;
    kept.push_back(points[i]);
  }
  points = std::move(kept);
}

// Returns the change of the parameters of a face along the curve. At a fold they change infinitely
// fast, so the result is limited by their change along the chords.
gp_Vec2d flatTangent(const std::vector<PointOnBoth>& points, std::size_t i, int side) {
  constexpr double kMaxGain = 3;
  Vector2d steepest = Vector2d::Zero();
  for (std::size_t k = std::max<std::size_t>(i, 1); k <= std::min(i + 1, points.size() - 1); ++k) {
    const Vector2d slope =
        (points[k].on[side] - points[k - 1].on[side]) / (points[k].at - points[k - 1].at).norm();
    if (slope.norm() > steepest.norm()) steepest = slope;
  }
  const Jet& jet = points[i].jets[side];
  const Vector2d tangent = parameterStep(points[i].tangent.normalized(), jet);
  const bool isUsable = tangent.norm() <= kMaxGain * steepest.norm();
  const Vector2d& used = isUsable ? tangent : steepest;
  return {used.x(), used.y()};
}

double lengthOf(const std::vector<PointOnBoth>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].at - points[i - 1].at).norm();
  return sum;
}

}  // namespace

double uncertaintyOf(double sine) {
  constexpr double kLargest = 1e-3;  // mm
  return std::clamp(4 * kCurveBound / std::max(sine, kCurveBound), kSamePoint, kLargest);
}

std::optional<std::pair<double, Vector2d>> throughFace(const MeshedFaces& faces, int face,
                                                       const BRepAdaptor_Curve& curve, double t,
                                                       Vector2d on) {
  for (int round = 0; round < kNewtonRounds; ++round) {
    const Jet f = faces.jet(face, on);
    gp_Pnt p;
    gp_Vec along;
    curve.D1(t, p, along);
    const Vector3d gap = vectorOf(p.XYZ()) - f.at;
    if (gap.norm() < kNewtonBound) return std::pair(t, on);
    Eigen::Matrix3d m;
    m << vectorOf(along.XYZ()), -f.u, -f.v;
    const Vector3d step = m.partialPivLu().solve(gap);
    if (!step.allFinite()) return std::nullopt;
    t -= step[0];
    on -= step.tail<2>();
  }
  return std::nullopt;
}

double SectionTracer::Run::length() const { return lengthOf(points); }

PointOnBoth SectionTracer::pointAt(const Vector3d& p, const std::array<Vector2d, 2>& on) const {
  PointOnBoth point;
  point.at = p;
  point.on = on;
  point.jets = {jet(0, on[0]), jet(1, on[1])};
  point.tangent = point.jets[0].normal().cross(point.jets[1].normal());
  point.sine = point.tangent.norm();
  return point;
}

// Moves the parameters until they give one point; if a plane is given, one in this plane.
std::optional<PointOnBoth> SectionTracer::onBoth(std::array<Vector2d, 2> on,
                                                 const std::optional<Plane>& plane) const {
  for (int round = 0; round < kNewtonRounds; ++round) {
    const Jet f = jet(0, on[0]), g = jet(1, on[1]);
    const Vector3d gap = f.at - g.at;
    const double off = plane ? (f.at - plane->first).dot(plane->second) : 0;
    if (gap.norm() < kNewtonBound && std::abs(off) < kNewtonBound)
      return pointAt((f.at + g.at) / 2, on);
    Eigen::Vector4d step;
    if (plane) {
      Eigen::Matrix4d m;
      m << f.u, f.v, -g.u, -g.v, f.u.dot(plane->second), f.v.dot(plane->second), 0, 0;
      step = m.partialPivLu().solve(Eigen::Vector4d(gap.x(), gap.y(), gap.z(), off));
    } else {
      // The shortest step.
      Eigen::Matrix<double, 3, 4> m;
      m << f.u, f.v, -g.u, -g.v;
      const Eigen::Matrix3d square = m * m.transpose();
      step = m.transpose() * square.partialPivLu().solve(gap);
    }
    if (!step.allFinite()) return std::nullopt;
    on[0] -= step.head<2>();
    on[1] -= step.tail<2>();
  }
  return std::nullopt;
}

// Returns the point where an edge of one face passes through the other face.
std::optional<PointOnBoth> SectionTracer::atBorder(int side, const TopoDS_Edge& edge,
                                                   const Vector3d& near,
                                                   const Vector2d& onOther) const {
  const Handle(Geom2d_Curve) flat = faces_.curveOn(of_[side], edge);
  if (flat.IsNull()) return std::nullopt;
  double from, to;
  const Handle(Geom_Curve) border = BRep_Tool::Curve(edge, from, to);
  const GeomAPI_ProjectPointOnCurve foot(pointOf(near), border, from, to);
  double start = from;
  if (foot.NbPoints() > 0) {
    start = foot.LowerDistanceParameter();
  } else if (border->Value(to).Distance(pointOf(near)) <
             border->Value(from).Distance(pointOf(near))) {
    start = to;
  }
  const BRepAdaptor_Curve curve(edge);
  const auto found = throughFace(faces_, of_[1 - side], curve, start, onOther);
  constexpr double kPastEnd = 1e-7;
  if (!found || found->first < from - kPastEnd || found->first > to + kPastEnd) return std::nullopt;
  const gp_Pnt2d at = flat->Value(found->first);
  std::array<Vector2d, 2> on;
  on[side] = {at.X(), at.Y()};
  on[1 - side] = found->second;
  const PointOnBoth point = pointAt(vectorOf(curve.Value(found->first).XYZ()), on);
  const Vector3d along = vectorOf(curve.DN(found->first, 1).XYZ()).normalized();
  return snappedToEvent(point, std::abs(along.dot(point.jets[1 - side].normal())));
}

// Returns the event at a point on a border, if it may be that point, otherwise the point.
PointOnBoth SectionTracer::snappedToEvent(const PointOnBoth& point, double sine) const {
  PointOnBoth result = point;
  double nearest = uncertaintyOf(sine);
  for (const Vector3d& event : events_) {
    const double distance = (event - point.at).norm();
    if (distance >= nearest) continue;
    const auto a = footOn(0, point.on[0], event), b = footOn(1, point.on[1], event);
    if (!a || !b) continue;
    nearest = distance;
    result.at = event;
    result.on = {*a, *b};
  }
  return result;
}

// Returns the parameters of a point that lies on the face.
std::optional<Vector2d> SectionTracer::footOn(int side, Vector2d on, const Vector3d& p) const {
  // The method of Levenberg and Marquardt. Near a fold, the steps of Newton's method are too long.
  constexpr int kRounds = 60;
  constexpr double kEnough = 1e-12;       // mm
  constexpr double kFirstDamping = 1e-6;  // of the squares of the derivatives
  Jet at = jet(side, on);
  double damping = kFirstDamping;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d gap = p - at.at;
    Eigen::Matrix2d square;
    square << at.u.squaredNorm(), at.u.dot(at.v), at.u.dot(at.v), at.v.squaredNorm();
    square.diagonal() *= 1 + damping;
    const Vector2d step = square.ldlt().solve(Vector2d(at.u.dot(gap), at.v.dot(gap)));
    if (!step.allFinite()) return std::nullopt;
    const Jet next = jet(side, on + step);
    if ((next.at - p).norm() < gap.norm()) {
      at = next;
      on += step;
      damping /= 10;
    } else {
      damping = std::max(kFirstDamping, 10 * damping);
    }
    if (step.cwiseAbs2().dot(square.diagonal()) < kEnough * kEnough) break;
  }
  if (!((at.at - p).norm() < kSamePoint) || !faces_.isInRange(of_[side], on)) return std::nullopt;
  return on;
}

bool SectionTracer::isShared(const PointOnBoth& point) const {
  return std::any_of(shared_.begin(), shared_.end(), [&](const SharedCurve& shared) {
    if (point.sine > shared.maxSine) return false;
    const GeomAPI_ProjectPointOnCurve foot(pointOf(point.at), shared.curve);
    return foot.NbPoints() > 0 && foot.LowerDistance() < shared.near;
  });
}

bool SectionTracer::isInBoth(const PointOnBoth& point) const {
  return faces_.isInFace(of_[0], point.on[0]) && faces_.isInFace(of_[1], point.on[1]);
}

bool SectionTracer::isCommonVertex(const Vector3d& p) const {
  constexpr double kAtVertex = 1e-3;  // mm
  return std::any_of(commonVertices_.begin(), commonVertices_.end(),
                     [&](const Vector3d& vertex) { return (vertex - p).norm() < kAtVertex; });
}

std::vector<SectionTracer::Run> SectionTracer::runsOf(
    const std::vector<std::vector<Piercing>>& chains) const {
  constexpr double kNearest = 0.1, kFarthest = 20;  // times the deflection
  std::vector<Run> runs;
  for (const std::vector<Piercing>& chain : chains) {
    Run run;
    const auto finish = [&] {
      if (run.points.size() > 1) runs.push_back(run);
      run = {};
    };
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Piercing& piercing = chain[i];
      // Such a point may belong to the common edge.
      if (!shared_.empty() && (piercing.isNode || isCommonVertex(piercing.at))) continue;
      const bool isEnd = i == 0 || i + 1 == chain.size();
      const bool isBorder = isEnd && piercing.border >= 0;
      const auto point = isBorder ? atBorder(piercing.borderSide, faces_.edge(piercing.border),
                                             piercing.at, piercing.on[1 - piercing.borderSide])
                                  : onBoth(piercing.on);
      if (!point || point->sine < kTangentFaces || isShared(*point) ||
          (point->at - piercing.at).norm() > kFarthest * faces_.deflection()) {
        finish();
        continue;
      }
      const bool isExact = isBorder || (isEnd && piercing.isNode);
      if (!run.points.empty() &&
          (run.points.back().at - point->at).norm() < kNearest * faces_.deflection()) {
        if (!isExact) continue;
        if (run.points.size() > 1) run.points.pop_back();
      }
      if (doesTurnBack(run.points, *point)) {
        if (!isInBoth(run.points.back())) run.points.pop_back();
        finish();
      }
      if (!run.points.empty() &&
          (!areConnected(run.points.back(), *point) || isFoldBetween(run.points.back(), *point)))
        finish();
      if (run.points.empty()) run.isFirstExact = isExact;
      run.isLastExact = isExact;
      run.points.push_back(*point);
    }
    finish();
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Run& r, const Run& t) { return r.length() > t.length(); });
  return runs;
}

// Returns the next point at about the distance h.
std::optional<PointOnBoth> SectionTracer::next(const PointOnBoth& from, double h) const {
  constexpr double kMinCosine = 0.98, kMaxStep = 1.5;
  const Vector3d along = from.tangent.normalized();
  std::array<Vector2d, 2> on = from.on;
  for (const int k : {0, 1}) on[k] += parameterStep(h * along, from.jets[k]);
  auto point = onBoth(on, Plane(from.at + h * along, along));
  if (!point) return point;
  if (point->tangent.dot(along) < 0) point->tangent *= -1;
  const bool isNear = (point->at - from.at).norm() <= kMaxStep * h;
  const bool isSmooth = point->tangent.dot(along) >= kMinCosine * point->sine;
  return isNear && isSmooth ? point : std::nullopt;
}

// Follows the curve beyond its last point, to the border of a face, or to a point where the faces
// are tangent.
void SectionTracer::extend(std::vector<PointOnBoth>& points) {
  const double longest = 100 * faces_.deflection(), shortest = 0.01 * faces_.deflection();
  double h = 10 * faces_.deflection();
  constexpr int kMaxSteps = 2000;
  for (int i = 0; i < kMaxSteps && h >= shortest; ++i) {
    const auto point = next(points.back(), h);
    if (!point || point->sine < kTangentFaces || isShared(*point)) {
      h /= 2;
      continue;
    }
    const bool isClosed = i > 3 && (point->at - points.front().at).norm() < h;
    if (isClosed) break;
    const bool isFold = isFoldBetween(points.back(), *point);
    if (isFold || !isInBoth(*point)) {
      if ((!isFold || h < 4 * shortest) && endAtBorder(*point, points)) return;
      h /= 2;
      continue;
    }
    points.push_back(*point);
    h = std::min(longest, 1.5 * h);
  }
  endAtEvent(points);
}

// Appends the point where the curve leaves one of the faces. `outside`: a point beyond it.
bool SectionTracer::endAtBorder(const PointOnBoth& outside, std::vector<PointOnBoth>& points) {
  const PointOnBoth inside = points.back();
  const double step = (outside.at - inside.at).norm();
  std::optional<PointOnBoth> best;
  double nearest = 1.2 * step;
  std::vector<std::pair<int, TopoDS_Edge>> borders = folds_;
  for (const int k : {0, 1}) {
    for (const int e : faces_.edgesOf(of_[k])) {
      if (!faces_.hasEdge(of_[1 - k], e)) borders.emplace_back(k, faces_.edge(e));
    }
  }
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const auto& [k, border] = borders[i];
    auto point = atBorder(k, border, (inside.at + outside.at) / 2,
                          (inside.on[1 - k] + outside.on[1 - k]) / 2);
    if (!point || isShared(*point)) continue;
    const Vector3d way = point->at - inside.at;
    if (way.norm() >= nearest || way.dot(inside.tangent) < -kSamePoint || isCommonVertex(point->at))
      continue;
    const bool isFold = i < folds_.size();
    if (isFold) point->tangent = inside.tangent;
    if (point->tangent.dot(inside.tangent) < 0) point->tangent *= -1;
    nearest = way.norm();
    best = point;
  }
  if (!best) return false;
  if (points.size() > 1 && nearest < 0.1 * faces_.deflection()) points.pop_back();
  points.push_back(*best);
  ends_.push_back(best->at);
  return true;
}

// Appends the next event, if it lies on both faces and the curve leads to it.
void SectionTracer::endAtEvent(std::vector<PointOnBoth>& points) const {
  constexpr double kMinCosine = 0.9;
  const PointOnBoth last = points.back();
  const Vector3d along = last.tangent.normalized();
  double nearest = 100 * faces_.deflection();
  std::optional<PointOnBoth> best;
  for (const Vector3d& event : events_) {
    const Vector3d way = event - last.at;
    const double distance = way.norm();
    if (distance >= nearest) continue;
    if (distance > kSamePoint && way.dot(along) < kMinCosine * distance) continue;
    if (isCommonVertex(event)) continue;
    const auto a = footOn(0, last.on[0], event), b = footOn(1, last.on[1], event);
    if (!a || !b) continue;
    nearest = distance;
    best = pointAt(event, {*a, *b});
    // The faces are tangent there. The tangent is that of a parabola.
    const Vector3d secant = way.normalized();
    best->tangent = (2 * secant * secant.dot(along) - along).normalized();
    best->sine = 1;
  }
  if (!best) return;
  if (nearest < 0.01 * faces_.deflection() && points.size() > 2) points.pop_back();
  points.push_back(*best);
}

TopoDS_Edge SectionTracer::edgeAlong(Run run) {
  orient(run.points);
  if (!run.isLastExact) extend(run.points);
  turnBack(run.points);
  if (!run.isFirstExact) extend(run.points);
  return edgeOf(std::move(run.points));
}

TopoDS_Edge SectionTracer::edgeThrough(const Vector3d& p, const std::array<Vector2d, 2>& on) {
  const PointOnBoth start = pointAt(p, on);
  if (start.sine < kTangentFaces || isShared(start)) return {};
  std::vector<PointOnBoth> points{start};
  for (int side = 0; side < 2; ++side) {
    const auto first = next(points.back(), faces_.deflection());
    if (first && isInBoth(*first)) extend(points);
    turnBack(points);
  }
  if (points.size() < 3 &&
      isShared(pointAt((points.front().at + points.back().at) / 2, points.front().on)))
    return {};
  return edgeOf(std::move(points));
}

// Returns a point of the curve between two others.
std::optional<PointOnBoth> SectionTracer::between(const PointOnBoth& a,
                                                  const PointOnBoth& b) const {
  constexpr double kMaxOff = 0.3;  // times the chord
  const Vector3d chord = b.at - a.at, middle = (a.at + b.at) / 2;
  const auto point =
      onBoth({(a.on[0] + b.on[0]) / 2, (a.on[1] + b.on[1]) / 2}, Plane(middle, chord.normalized()));
  const bool isBetween = point && point->sine >= kTangentFaces &&
                         (point->at - middle).norm() < kMaxOff * chord.norm() &&
                         !isFoldBetween(a, *point) && !isFoldBetween(*point, b);
  return isBetween ? point : std::nullopt;
}

// Makes the edge through points of the curve. Adds points until it is exact between them.
TopoDS_Edge SectionTracer::edgeOf(std::vector<PointOnBoth> points) const {
  constexpr double kMinLength = 1e-5;  // mm
  constexpr int kRounds = 8;
  constexpr std::size_t kMaxPoints = 600;
  tidy(points);
  if (lengthOf(points) < kMinLength) return {};
  for (int round = 1;; ++round) {
    std::vector<CurvePoint> places;
    std::array<std::vector<CurvePoint2d>, 2> flat;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PointOnBoth& point = points[i];
      places.push_back({pointOf(point.at), vecOf(point.tangent.normalized())});
      for (const int k : {0, 1}) {
        flat[k].push_back({{point.on[k].x(), point.on[k].y()}, flatTangent(points, i, k)});
      }
    }
    std::vector<double> lengths;
    const Handle(Geom_BSplineCurve) curve = interpolated(places, lengths);
    const std::array<Handle(Geom2d_BSplineCurve), 2> on{interpolated(flat[0], lengths),
                                                        interpolated(flat[1], lengths)};
    if (curve.IsNull() || on[0].IsNull() || on[1].IsNull()) return {};
    std::vector<PointOnBoth> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      finer.push_back(points[i]);
      if (i + 1 == points.size() || lengths[i + 1] - lengths[i] < kMinLength) continue;
      const double t = (lengths[i] + lengths[i + 1]) / 2;
      const Vector3d at = vectorOf(curve->Value(t).XYZ());
      std::array<Vector2d, 2> middle;
      bool isExact = true;
      for (const int k : {0, 1}) {
        const gp_Pnt2d p = on[k]->Value(t);
        middle[k] = {p.X(), p.Y()};
        isExact = isExact && (jet(k, middle[k]).at - at).norm() <= kCurveBound;
      }
      if (isExact) continue;
      if (const auto point = between(points[i], points[i + 1])) finer.push_back(*point);
    }
    if (finer.size() > points.size() && finer.size() <= kMaxPoints && round < kRounds) {
      orient(finer);
      points = std::move(finer);
      continue;
    }
    TopoDS_Edge edge;
    const BRep_Builder builder;
    builder.MakeEdge(edge, curve, Precision::Confusion());
    builder.Range(edge, curve->FirstParameter(), curve->LastParameter());
    for (const int k : {0, 1})
      builder.UpdateEdge(edge, on[k], faces_.face(of_[k]), Precision::Confusion());
    return edge;
  }
}

}  // namespace swept::step
