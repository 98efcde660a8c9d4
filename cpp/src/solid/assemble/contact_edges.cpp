// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/contact_edges.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <GC_MakeCircle.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <map>
#include <optional>

#include "solid/assemble/interpolate_curve.h"

namespace swept::step {
namespace {

/// How far contact curves extend beyond the face, as a fraction of the range of its parameters.
constexpr double kRangeMargin = 0.03;
/// Shorter contact curves (mm) are left out.
constexpr double kShortestEdge = 1e-4;

struct Parameters {
  double from = 0, to = 0;
  double at(double fraction) const { return from + fraction * (to - from); }
};

// Traces the contact curves of one face.
class ContactTracer {
 public:
  ContactTracer(const TopoDS_Face& face, const Velocity& velocity)
      : surface_(face, Standard_False), velocity_(velocity) {
    double u0, u1, v0, v1;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    u_ = breaksOf({u0, u1}, true);
    v_ = breaksOf({v0, v1}, false);
    findCircles();
  }

  std::vector<TopoDS_Edge> trace() {
    for (std::size_t i = 0; i + 1 < u_.size(); ++i) {
      for (std::size_t j = 0; j + 1 < v_.size(); ++j)
        traceSmooth({u_[i], u_[i + 1]}, {v_[j], v_[j + 1]});
    }
    return std::move(edges_);
  }

 private:
  using Points = std::vector<gp_Pnt2d>;
  /// An edge of the grid of parameters: its direction (0: u, 1: v) and its lower end.
  using GridEdge = std::array<int, 3>;

  // Returns the ends of the ranges in which the surface is smooth, over the extended face.
  std::vector<double> breaksOf(Parameters range, bool alongU) const {
    const double period = alongU ? (surface_.IsUPeriodic() ? surface_.UPeriod() : 0)
                                 : (surface_.IsVPeriodic() ? surface_.VPeriod() : 0);
    const double length = range.to - range.from, margin = kRangeMargin * length;
    if (period == 0 || length + 2 * margin < period) {
      range = {range.from - margin, range.to + margin};
      if (period == 0) {
        range.from =
            std::max(range.from, alongU ? surface_.FirstUParameter() : surface_.FirstVParameter());
        range.to =
            std::min(range.to, alongU ? surface_.LastUParameter() : surface_.LastVParameter());
      }
    }
    std::vector<double> breaks{range.from};
    if (surface_.GetType() >= GeomAbs_BezierSurface) {
      const int count =
          alongU ? surface_.NbUIntervals(GeomAbs_C2) : surface_.NbVIntervals(GeomAbs_C2);
      TColStd_Array1OfReal ends(1, count + 1);
      if (alongU) {
        surface_.UIntervals(ends, GeomAbs_C2);
      } else {
        surface_.VIntervals(ends, GeomAbs_C2);
      }
      const double least = 1e-6 * length;
      for (const double end : ends) {
        if (end > range.from + least && end < range.to - least) breaks.push_back(end);
      }
    }
    breaks.push_back(range.to);
    return breaks;
  }

  // A torus that moves across its axis touches the envelope along both circles at which its normal
  // is parallel to the axis. The other contact curves cross them.
  void findCircles() {
    constexpr double kContact = 1e-9;  // of the sine
    constexpr int kSamples = 16;
    if (surface_.GetType() != GeomAbs_Torus) return;
    const Parameters u{u_.front(), u_.back()};
    for (int i = -7; i <= 7; i += 2) {
      const double v = i * M_PI / 2;
      bool isContact = v > v_.front() && v < v_.back();
      for (int k = 0; k <= kSamples && isContact; ++k)
        isContact = std::abs(sine({u.at(k / double(kSamples)), v})) < kContact;
      if (isContact) circles_.push_back(v);
    }
  }

  gp_Pnt at(const gp_Pnt2d& p) const { return surface_.Value(p.X(), p.Y()); }

  // Returns the sine, divided by what makes it zero on the circles: it changes its sign only on the
  // other contact curves.
  double contact(gp_Pnt2d p) const {
    constexpr double kNear = 1e-4;  // rad: nearer to a circle, the quotient is nearly constant
    double divisor = 1;
    for (const double v : circles_) {
      if (std::abs(p.Y() - v) < kNear) p.SetY(v + kNear);
      divisor *= p.Y() - v;
    }
    return sine(p) / divisor;
  }

  // Returns the sine of the angle between velocity and face.
  double sine(const gp_Pnt2d& p) const {
    gp_Pnt point;
    gp_Vec alongU, alongV;
    surface_.D1(p.X(), p.Y(), point, alongU, alongV);
    const gp_Vec normal = alongU.Crossed(alongV), velocity = velocity_(point);
    const double length = normal.Magnitude() * velocity.Magnitude();
    return length > gp::Resolution() ? normal.Dot(velocity) / length : 0;
  }

  // Returns the contact on the segment from a to b, at whose ends n.v has different signs.
  gp_Pnt2d root(const gp_Pnt2d& a, const gp_Pnt2d& b) const {
    const auto between = [&](double t) { return gp_Pnt2d(a.XY() + t * (b.XY() - a.XY())); };
    double low = 0, high = 1, atLow = contact(a), atHigh = contact(b);
    for (int i = 0; i < 80 && high - low > 1e-15; ++i) {
      // False position; every third step halves the range.
      double t = i % 3 == 2 ? (low + high) / 2 : low + (high - low) * atLow / (atLow - atHigh);
      if (!(t > low && t < high)) t = (low + high) / 2;
      const double value = contact(between(t));
      if (value == 0) return between(t);
      if ((value > 0) == (atLow > 0)) {
        low = t, atLow = value;
      } else {
        high = t, atHigh = value;
      }
    }
    return between((low + high) / 2);
  }

  void traceSmooth(Parameters u, Parameters v) {
    const std::size_t pieces = (u_.size() - 1) * (v_.size() - 1);
    const int n = pieces <= 4 ? 32 : pieces <= 64 ? 16 : 8;
    // If a torus moves along an axis, the curves that cross the circles would run through nodes of
    // an even grid. Rounding errors would decide about the signs there.
    const double shift = circles_.empty() ? 0 : 0.137;
    const auto fraction = [&](int i) { return i == 0 || i == n ? i / double(n) : (i + shift) / n; };
    const auto node = [&](int i, int j) { return gp_Pnt2d(u.at(fraction(i)), v.at(fraction(j))); };
    std::vector<double> values((n + 1) * (n + 1));
    double largest = 0;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const double value = values[i * (n + 1) + j] = contact(node(i, j));
        largest = std::max(largest, std::abs(value));
      }
    }
    if (largest < kSliding) return;
    for (const double circle : circles_) {
      const Handle(Geom_ToroidalSurface) torus = new Geom_ToroidalSurface(surface_.Torus());
      add(BRepBuilderAPI_MakeEdge(torus->VIso(circle), u.from, u.to));
    }
    const auto isOutward = [&](int i, int j) { return values[i * (n + 1) + j] >= 0; };
    std::map<GridEdge, gp_Pnt2d> points;
    std::map<GridEdge, std::vector<GridEdge>> next;
    const auto crossing = [&](int along, int i, int j) {
      const GridEdge edge{along, i, j};
      if (!points.count(edge))
        points[edge] = root(node(i, j), node(i + (along == 0), j + (along == 1)));
      return edge;
    };
    const auto link = [&](const GridEdge& a, const GridEdge& b) {
      next[a].push_back(b);
      next[b].push_back(a);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const bool corner = isOutward(i, j);
        std::vector<GridEdge> found;  // around the cell
        if (corner != isOutward(i + 1, j)) found.push_back(crossing(0, i, j));
        if (isOutward(i + 1, j) != isOutward(i + 1, j + 1)) found.push_back(crossing(1, i + 1, j));
        if (isOutward(i, j + 1) != isOutward(i + 1, j + 1)) found.push_back(crossing(0, i, j + 1));
        if (corner != isOutward(i, j + 1)) found.push_back(crossing(1, i, j));
        if (found.size() == 2) link(found[0], found[1]);
        if (found.size() != 4) continue;
        const gp_Pnt2d centre((node(i, j).XY() + node(i + 1, j + 1).XY()) / 2);
        const bool joined = (contact(centre) >= 0) == corner;
        link(found[0], found[joined ? 1 : 3]);
        link(found[2], found[joined ? 3 : 1]);
      }
    }
    chain(points, next);
  }

  // Joins the points to curves: first those with ends, then closed ones.
  void chain(const std::map<GridEdge, gp_Pnt2d>& points,
             const std::map<GridEdge, std::vector<GridEdge>>& next) {
    std::map<GridEdge, bool> used;
    const auto walk = [&](const GridEdge& start) {
      Points curve;
      GridEdge at = start;
      for (bool moved = true; moved;) {
        used[at] = true;
        curve.push_back(points.at(at));
        moved = false;
        for (const GridEdge& to : next.at(at)) {
          if (used[to]) continue;
          at = to;
          moved = true;
          break;
        }
      }
      const auto& last = next.at(at);
      const bool closed =
          curve.size() > 2 && std::find(last.begin(), last.end(), start) != last.end();
      if (closed) curve.push_back(points.at(start));
      addCurve(curve, closed);
    };
    for (const auto& [edge, to] : next) {
      if (to.size() == 1 && !used[edge]) walk(edge);
    }
    for (const auto& [edge, to] : next) {
      if (!used[edge]) walk(edge);
    }
  }

  void addCurve(const Points& given, bool closed) {
    double length = 0;
    for (std::size_t i = 1; i < given.size(); ++i)
      length += at(given[i]).Distance(at(given[i - 1]));
    if (length < kShortestEdge) return;
    // Points that nearly coincide would spoil the parameters of the spline.
    Points points;
    for (const gp_Pnt2d& p : given) {
      if (points.empty() || at(p).Distance(at(points.back())) > 1e-3 * length) points.push_back(p);
    }
    if (points.size() < 2) return;
    points.back() = given.back();
    if (!addLine(points, closed) && !addCircle(points, closed)) addSpline(points);
  }

  // Adds the edge, cut at its cusps: where the contact curve runs along the velocity, its image
  // along the velocity turns back. What both parts sweep lies on different sides.
  void add(const TopoDS_Edge& edge) {
    double from, to;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    const auto across = [&](double t) {
      gp_Pnt p;
      gp_Vec along;
      curve->D1(t, p, along);
      const gp_Vec v = velocity_(p);
      return along - v * (along.Dot(v) / std::max(v.SquareMagnitude(), gp::Resolution()));
    };
    constexpr int kSteps = 200;
    constexpr double kNoImage = 1e-6;  // mm for each unit of the parameter
    double start = from, before = from;
    gp_Vec image = across(from);
    for (int i = 1; i <= kSteps; ++i) {
      const double t = from + (to - from) * i / kSteps;
      const gp_Vec next = across(t);
      if (next.Magnitude() < kNoImage) continue;
      if (image.Dot(next) < 0) {
        double low = before, high = t;
        while (high - low > 1e-14 * (to - from)) {
          const double middle = (low + high) / 2;
          if (middle <= low || middle >= high) break;
          (image.Dot(across(middle)) > 0 ? low : high) = middle;
        }
        addPart(curve, start, low);
        start = low;
      }
      before = t;
      image = next;
    }
    if (start == from) {
      edges_.push_back(edge);
    } else {
      addPart(curve, start, to);
    }
  }

  void addPart(const Handle(Geom_Curve) & curve, double from, double to) {
    BRepBuilderAPI_MakeEdge maker(curve, from, to);
    if (maker.IsDone()) edges_.push_back(maker.Edge());
  }

  bool addLine(const Points& points, bool closed) {
    const gp_Pnt a = at(points.front()), b = at(points.back());
    if (closed || a.Distance(b) < kShortestEdge) return false;
    const gp_Lin line(a, gp_Dir(gp_Vec(a, b)));
    for (const gp_Pnt2d& p : points) {
      if (line.Distance(at(p)) > kCurveBound) return false;
    }
    add(BRepBuilderAPI_MakeEdge(a, b));
    return true;
  }

  bool addCircle(const Points& points, bool closed) {
    if (points.size() < 5) return false;
    const std::size_t half = points.size() / 2;
    const gp_Pnt a = at(points.front()), b = at(points[half]);
    const gp_Pnt c = at(closed ? points[half / 2] : points.back());
    const GC_MakeCircle maker(a, closed ? c : b, closed ? b : c);
    if (!maker.IsDone()) return false;
    gp_Circ circle = maker.Value()->Circ();
    for (const gp_Pnt2d& p : points) {
      if (circle.Distance(at(p)) > kCurveBound) return false;
    }
    if (closed) {
      add(BRepBuilderAPI_MakeEdge(circle));
      return true;
    }
    // The edge must run from a through b to c.
    const auto after = [&](const gp_Pnt& p) {
      const double angle = ElCLib::Parameter(circle, p) - ElCLib::Parameter(circle, a);
      return angle < 0 ? angle + 2 * M_PI : angle;
    };
    if (after(b) > after(c)) {
      const gp_Ax2& axes = circle.Position();
      circle.SetPosition(gp_Ax2(axes.Location(), axes.Direction().Reversed(), axes.XDirection()));
    }
    add(BRepBuilderAPI_MakeEdge(circle, a, c));
    return true;
  }

  // Returns the unit tangent of the contact curve, along the given direction.
  gp_Vec tangent(const gp_Pnt2d& p, const gp_Vec2d& direction) const {
    gp_Pnt point;
    gp_Vec alongU, alongV;
    surface_.D1(p.X(), p.Y(), point, alongU, alongV);
    // The contact curve is a level line of contact(): perpendicular to its slope.
    const double hu = 1e-5 / std::max(alongU.Magnitude(), 1e-9);
    const double hv = 1e-5 / std::max(alongV.Magnitude(), 1e-9);
    const double slopeU = (contact({p.X() + hu, p.Y()}) - contact({p.X() - hu, p.Y()})) / hu;
    const double slopeV = (contact({p.X(), p.Y() + hv}) - contact({p.X(), p.Y() - hv})) / hv;
    gp_Vec result = alongU * -slopeV + alongV * slopeU;
    const gp_Vec along = alongU * direction.X() + alongV * direction.Y();
    if (result.Magnitude() < gp::Resolution()) result = along;
    if (result.Dot(along) < 0) result.Reverse();
    return result.Normalized();
  }

  // Returns the contact near the middle between two successive points, if it is found.
  std::optional<gp_Pnt2d> middle(const gp_Pnt2d& a, const gp_Pnt2d& b) const {
    const gp_Pnt2d m((a.XY() + b.XY()) / 2);
    gp_Pnt point;
    gp_Vec alongU, alongV;
    surface_.D1(m.X(), m.Y(), point, alongU, alongV);
    const double perU = std::max(alongU.Magnitude(), 1e-9);
    const double perV = std::max(alongV.Magnitude(), 1e-9);
    // Perpendicular in space, if the parameter lines are.
    const gp_Vec2d across(-(b.Y() - a.Y()) * perV / perU, (b.X() - a.X()) * perU / perV);
    for (const double reach : {0.5, 2.0}) {
      const gp_Pnt2d low = m.Translated(across * -reach), high = m.Translated(across * reach);
      if ((contact(low) > 0) != (contact(high) > 0)) return root(low, high);
    }
    return std::nullopt;
  }

  Handle(Geom_BSplineCurve)
      splineThrough(const Points& points, std::vector<double>& lengths) const {
    std::vector<CurvePoint> given;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const gp_Vec2d direction(points[i == 0 ? 0 : i - 1],
                               points[std::min(i + 1, points.size() - 1)]);
      given.push_back({at(points[i]), tangent(points[i], direction)});
    }
    return interpolated(given, lengths);
  }

  // Interpolates the points by cubics, and adds points until the error is small enough.
  void addSpline(Points points) {
    constexpr int kRounds = 6;
    for (int round = 0;; ++round) {
      std::vector<double> parameters;
      const Handle(Geom_BSplineCurve) curve = splineThrough(points, parameters);
      if (curve.IsNull()) return;
      Points finer;
      for (std::size_t i = 0; i < points.size(); ++i) {
        finer.push_back(points[i]);
        if (i + 1 == points.size()) break;
        const auto exact = middle(points[i], points[i + 1]);
        if (!exact) continue;
        const gp_Pnt p = at(*exact);
        double t = (parameters[i] + parameters[i + 1]) / 2;
        gp_Pnt foot;
        gp_Vec slope;
        for (int k = 0; k < 4; ++k) {
          curve->D1(t, foot, slope);
          t += gp_Vec(foot, p).Dot(slope) / slope.SquareMagnitude();
        }
        if (curve->Value(t).Distance(p) > kCurveBound) finer.push_back(*exact);
      }
      if (finer.size() == points.size() || round == kRounds) {
        add(BRepBuilderAPI_MakeEdge(curve));
        return;
      }
      points = std::move(finer);
    }
  }

  const BRepAdaptor_Surface surface_;
  const Velocity& velocity_;
  std::vector<double> u_, v_;
  std::vector<double> circles_;  // of a torus: the parameters v of circles that touch the envelope
  std::vector<TopoDS_Edge> edges_;
};

}  // namespace

std::vector<TopoDS_Edge> contactEdges(const TopoDS_Face& face, const Velocity& velocity) {
  return ContactTracer(face, velocity).trace();
}

}  // namespace swept::step
