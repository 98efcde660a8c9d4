// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/narrow_holes.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/lines_on_faces.h"
#include "solid/sweep/interpolate.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// An open edge in the direction in which a filling uses it.
struct Side {
  TopoDS_Edge edge;  // forward
  bool isForward = true;

  TopoDS_Vertex first() const {
    return isForward ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
  }
  TopoDS_Vertex last() const {
    return isForward ? TopExp::LastVertex(edge) : TopExp::FirstVertex(edge);
  }
};
using Loop = std::vector<Side>;

// Returns the loops in which each vertex has one edge that leaves it.
std::vector<Loop> simpleLoops(const std::vector<OpenEdge>& open) {
  TopTools_IndexedMapOfShape vertices;
  std::map<int, std::vector<Side>> leaving;
  std::map<int, int> arriving;
  for (const OpenEdge& use : open) {
    const Side side{use.edge, !use.isForward};
    leaving[vertices.Add(side.first())].push_back(side);
    ++arriving[vertices.Add(side.last())];
  }
  std::vector<Loop> loops;
  while (!leaving.empty()) {
    const int from = leaving.begin()->first;
    Loop loop;
    bool isSimple = true;
    for (int at = from;;) {
      const auto found = leaving.find(at);
      if (found == leaving.end()) {
        isSimple = false;
        break;
      }
      isSimple = isSimple && found->second.size() == 1 && arriving[at] == 1;
      loop.push_back(found->second.front());
      leaving.erase(found);
      at = vertices.FindIndex(loop.back().last());
      if (at == from) break;
    }
    if (isSimple) loops.push_back(std::move(loop));
  }
  return loops;
}

// The curve of a side, with parameters from 0 to 1 in its direction.
class SideCurve {
 public:
  explicit SideCurve(const Side& side) : curve_(side.edge), isForward_(side.isForward) {}
  Vector3d at(double t) const {
    const Range range{curve_.FirstParameter(), curve_.LastParameter()};
    return vectorOf(curve_.Value(range.at(isForward_ ? t : 1 - t)).XYZ());
  }
  double length() const {
    constexpr int kSteps = 16;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
      sum += (at((i + 1.0) / kSteps) - at(static_cast<double>(i) / kSteps)).norm();
    return sum;
  }

 private:
  BRepAdaptor_Curve curve_;
  bool isForward_;
};

TopoDS_Wire wireOf(const Loop& loop) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const Side& side : loop)
    builder.Add(wire, side.edge.Oriented(side.isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
  return wire;
}

std::vector<Vector3d> pointsAlong(const Loop& loop) {
  constexpr int kSteps = 8;
  std::vector<Vector3d> points;
  for (const Side& side : loop) {
    const SideCurve curve(side);
    for (int i = 0; i < kSteps; ++i) points.push_back(curve.at(static_cast<double>(i) / kSteps));
  }
  return points;
}

// Returns the area vector of a polygon, mm^2.
Vector3d areaVector(const std::vector<Vector3d>& points) {
  Vector3d twice = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    twice += (points[i] - points[0]).cross(points[i + 1] - points[0]);
  return twice / 2;
}

// Returns a null face if the sides do not lie in one plane.
TopoDS_Face planeOver(const Loop& loop) {
  constexpr double kFlat = 1e-6;  // mm
  const std::vector<Vector3d> points = pointsAlong(loop);
  const Vector3d normal = areaVector(points).normalized();
  if (!std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
        return std::abs((p - points[0]).dot(normal)) < kFlat;
      }))
    return {};
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(pointOf(points[0]), dirOf(normal)), Precision::Confusion());
  TopoDS_Wire wire = wireOf(loop);
  wire.Closed(Standard_True);
  builder.Add(face, wire);
  return face;
}

// The boundary of the unit square, from (0, 0) through (1, 0), (1, 1) and (0, 1). A border without
// a side is a point of the filling.
class Boundary {
 public:
  explicit Boundary(Loop loop) {
    // Borders without a side are opposite to the shortest side, or between two sides.
    const auto shortest = std::min_element(
        loop.begin(), loop.end(),
        [](const Side& a, const Side& b) { return SideCurve(a).length() < SideCurve(b).length(); });
    std::rotate(loop.begin(), shortest, loop.end());
    const std::array<int, 3> used[] = {{0, 2, -1}, {0, 1, 3}};
    for (std::size_t i = 0; i < loop.size(); ++i)
      sides_[loop.size() == 4 ? static_cast<int>(i) : used[loop.size() - 2][i]] = loop[i];
    for (int k = 0; k < 4; ++k) {
      if (sides_[k]) curves_[k].emplace(*sides_[k]);
    }
    for (int k = 0; k < 4; ++k) corners_[k] = firstOf(k);
  }

  const std::optional<Side>& side(int k) const { return sides_[k]; }
  /// Returns the vertex of a border without a side.
  TopoDS_Vertex pointOf(int k) const { return sides_[(k + 3) % 4]->last(); }
  Vector3d at(double u, double v) const {
    const Vector3d ruled = (1 - v) * border(0, u) + v * border(2, 1 - u) +
                           (1 - u) * border(3, 1 - v) + u * border(1, v);
    return ruled - (1 - v) * ((1 - u) * corners_[0] + u * corners_[1]) -
           v * ((1 - u) * corners_[3] + u * corners_[2]);
  }

 private:
  Vector3d border(int k, double t) const { return curves_[k] ? curves_[k]->at(t) : corners_[k]; }
  Vector3d firstOf(int k) const {
    return curves_[k] ? curves_[k]->at(0) : curves_[(k + 3) % 4]->at(1);
  }

  std::array<std::optional<Side>, 4> sides_;
  std::array<std::optional<SideCurve>, 4> curves_;
  std::array<Vector3d, 4> corners_;
};

TopoDS_Face coonsOver(const Loop& loop) {
  constexpr double kBound = 1e-8;  // mm
  constexpr std::size_t kMaxFillingPoles = 4000;
  const Boundary boundary(loop);
  const auto fitted = fitSheet([&](double u, double v) { return boundary.at(u, v); }, {0, 1},
                               {0, 1}, nullptr, kBound, kMaxFillingPoles);
  if (!fitted) return {};
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, kernelSheet(*fitted->sheet), Precision::Confusion());
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(0, 0), gp_Pnt2d(1, 0), gp_Pnt2d(1, 1),
                                        gp_Pnt2d(0, 1)};
  for (int k = 0; k < 4; ++k) {
    const gp_Pnt2d &from = corners[k], &to = corners[(k + 1) % 4];
    const auto& side = boundary.side(k);
    if (!side) {
      builder.Add(wire, degeneratedEdge(boundary.pointOf(k), from, to, face));
      continue;
    }
    double first, last;
    BRep_Tool::Range(side->edge, first, last);
    const Handle(Geom2d_Curve) line =
        side->isForward ? lineOn(from, to, first, last) : lineOn(to, from, first, last);
    builder.UpdateEdge(side->edge, line, face, Precision::Confusion());
    builder.Add(wire, side->edge.Oriented(side->isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  wire.Closed(Standard_True);
  builder.Add(face, wire);
  return face;
}

bool isValid(const TopoDS_Face& face, const Loop& loop) {
  if (face.IsNull()) return false;
  for (const Side& side : loop) coverCurve(side.edge, face);
  return BRepCheck_Analyzer(face).IsValid();
}

// Returns the parts, of at most four sides, into which straight edges between the vertices of a
// loop cut it. The shortest such edge comes first.
std::vector<Loop> cutLoop(const Loop& loop) {
  const std::size_t count = loop.size();
  if (count <= 4) return {loop};
  const auto pointAt = [&](std::size_t i) { return BRep_Tool::Pnt(loop[i].first()); };
  std::size_t from = 0, to = 2;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count - (i == 0); ++j) {
      if (pointAt(i).Distance(pointAt(j)) < pointAt(from).Distance(pointAt(to))) {
        from = i;
        to = j;
      }
    }
  }
  BRepBuilderAPI_MakeEdge chord(loop[from].first(), loop[to].first());
  if (!chord.IsDone()) return {};
  std::array<Loop, 2> halves{Loop(loop.begin() + from, loop.begin() + to),
                             Loop(loop.begin() + to, loop.end())};
  halves[1].insert(halves[1].end(), loop.begin(), loop.begin() + from);
  halves[0].push_back({chord.Edge(), false});
  halves[1].push_back({chord.Edge(), true});
  std::vector<Loop> parts;
  for (const Loop& half : halves) {
    const std::vector<Loop> of = cutLoop(half);
    if (of.empty()) return {};
    parts.insert(parts.end(), of.begin(), of.end());
  }
  return parts;
}

// Returns twice the area divided by the length of the border.
double widthOf(const Loop& loop, const std::vector<Loop>& parts) {
  double length = 0, area = 0;
  for (const Side& side : loop) length += SideCurve(side).length();
  for (const Loop& part : parts) area += areaVector(pointsAlong(part)).norm();
  return 2 * area / length;
}

// Returns the fillings over the parts of a loop; none if the loop is too wide or if there is no
// valid face over one of the parts.
std::vector<TopoDS_Face> fillingsOf(const Loop& loop, double maxWidth) {
  constexpr std::size_t kMaxSides = 12;
  const TopoDS_Face plane = planeOver(loop);
  if (isValid(plane, loop)) return {plane};
  if (loop.size() < 2 || loop.size() > kMaxSides) return {};
  const std::vector<Loop> parts = cutLoop(loop);
  if (widthOf(loop, parts) > maxWidth) return {};
  std::vector<TopoDS_Face> fillings;
  for (const Loop& part : parts) {
    const TopoDS_Face flat = planeOver(part);
    fillings.push_back(flat.IsNull() ? coonsOver(part) : flat);
    if (!isValid(fillings.back(), part)) return {};
  }
  return fillings;
}

}  // namespace

std::vector<TopoDS_Face> NarrowHoles::fill(const std::vector<OpenEdge>& open, double maxWidth) {
  std::vector<TopoDS_Face> fillings;
  for (const Loop& loop : simpleLoops(open)) {
    bool isNew = false;
    for (const Side& side : loop) {
      isNew = tried_.insert(side.edge.TShape().get()).second || isNew;
      if (!BRep_Tool::SameRange(side.edge) || !BRep_Tool::SameParameter(side.edge))
        BRepLib::SameParameter(side.edge, Precision::Confusion());
    }
    if (!isNew) continue;
    for (const TopoDS_Face& filling : fillingsOf(loop, maxWidth)) {
      fillings.push_back(filling);
      for (TopExp_Explorer it(filling, TopAbs_EDGE); it.More(); it.Next())
        tried_.insert(it.Current().TShape().get());
    }
  }
  return fillings;
}

}  // namespace swept::step
