// What the solids of turning bodies begin with: zeros of functions, the parts of a body, where they
// touch the envelope, and where they may be on it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/body_geometry.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/contact_curves.h"
#include "solid/assemble/envelope_conditions.h"
#include "solid/assemble/zero_curves.h"
#include "solid/sweep/contact.h"
#include "unit/solid/test_poses.h"

namespace swept::step {
namespace {

TopoDS_Shape notchedBox() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(12, 9, 5).Shape(),
                         BRepPrimAPI_MakeBox(gp_Pnt(4, 3, -1), gp_Pnt(20, 20, 9)).Shape())
      .Shape();
}

TEST(BodyGeometry, KnowsItsNormalsAndItsConcaveEdge) {
  const BodyGeometry body(notchedBox());
  EXPECT_EQ(body.faces.size(), 8u);
  ASSERT_EQ(body.edges.size(), 18u);
  for (const BodyFace& face : body.faces) {
    const BodyEdge& edge = body.edges[face.edges.front()];
    EXPECT_NEAR(edge.tangent(0).dot(body.surfaces[face.surface].axis), 0, 1e-12);
  }
  for (const BodyEdge& edge : body.edges) {
    const Eigen::Vector3d middle = edge.at(edge.range.at(0.5));
    const bool isNotch = (middle - Eigen::Vector3d(4, 3, 2.5)).norm() < 1e-9;
    EXPECT_NEAR(body.convexity(edge), isNotch ? -1 : 1, 1e-12) << middle.transpose();
    for (const int f : edge.faces) EXPECT_GE(f, 0);
  }
  const auto isOutward = [&](const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
    return std::any_of(body.faces.begin(), body.faces.end(), [&](const BodyFace& face) {
      const BodyEdge& edge = body.edges[face.edges.front()];
      return (body.surfaces[face.surface].normalAt(p) - normal).norm() < 1e-12 &&
             std::abs(normal.dot(edge.at(edge.range.from) - p)) < 1e-12;
    });
  };
  EXPECT_TRUE(isOutward({-1, 0, 0}, {0, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {12, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {4, 5, 0}));
  EXPECT_FALSE(isOutward({-1, 0, 0}, {12, 0, 0}));
}

TEST(BodyGeometry, CutsClosedFacesAndKnowsTheirSurface) {
  const BodyGeometry body(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  EXPECT_EQ(body.faces.size(), 4u);
  EXPECT_EQ(body.surfaces.size(), 3u);
  ASSERT_EQ(body.edges.size(), 6u);
  const auto lines = std::count_if(body.edges.begin(), body.edges.end(), [&](const BodyEdge& edge) {
    return std::abs(body.convexity(edge)) < 1e-12 && edge.scale == 1;
  });
  const auto arcs = std::count_if(body.edges.begin(), body.edges.end(), [&](const BodyEdge& edge) {
    return std::abs(body.convexity(edge) - 1) < 1e-12 && std::abs(edge.scale - 2) < 1e-12;
  });
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(arcs, 4);
  for (const BodySurface& surface : body.surfaces) {
    const Eigen::Vector3d p(2, 0, 1), away = surface.normalAt(p);
    const double up = surface.origin.z() > 1 ? 1 : -1;
    const Eigen::Vector3d expected =
        surface.isPlane() ? Eigen::Vector3d(0, 0, up) : p.cwiseProduct(Eigen::Vector3d(0.5, 0, 0));
    EXPECT_NEAR((away - expected).norm(), 0, 1e-12);
  }
}

// Edges that are marked as if their curves had different parameters make faces invalid.
TEST(BodyGeometry, EdgesStayValidWhereClosedFacesAreCut) {
  // Files have cylinders that begin at -pi, and with them the circles.
  const gp_Cylinder cylinder(gp_Ax3(), 2);
  BRepBuilderAPI_Sewing rod;
  const TopoDS_Face side = BRepBuilderAPI_MakeFace(cylinder, -M_PI, M_PI, 0, 5);
  rod.Add(side);
  for (TopExp_Explorer it(side, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRepAdaptor_Curve(edge).GetType() != GeomAbs_Circle) continue;
    rod.Add(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire()).Face());
  }
  rod.Perform();
  const BodyGeometry body(rod.SewedShape());
  EXPECT_EQ(body.faces.size(), 4u);
  for (const BodyFace& face : body.faces) {
    for (TopExp_Explorer it(face.shape, TopAbs_EDGE); it.More(); it.Next()) {
      EXPECT_TRUE(BRep_Tool::SameParameter(TopoDS::Edge(it.Current())));
      EXPECT_TRUE(BRep_Tool::SameRange(TopoDS::Edge(it.Current())));
    }
    EXPECT_TRUE(BRepCheck_Analyzer(face.shape).IsValid());
  }
}

// The kernel only approximates the circles in which it divides a closed face.
TEST(BodyGeometry, EdgesLieExactlyOnClosedFacesThatAreCut) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeSphere(6).Shape(), BRepPrimAPI_MakeTorus(9, 3).Shape(),
        BRepPrimAPI_MakeCone(3, 1, 4).Shape()}) {
    const BodyGeometry body(shape);
    ASSERT_GE(body.edges.size(), 2u);
    for (const BodyEdge& edge : body.edges) {
      EXPECT_LE(BRep_Tool::Tolerance(edge.shape), 1e-7);
      for (const int f : edge.faces) {
        for (const double part : {0.13, 0.5, 0.81})
          EXPECT_NEAR(body.surfaceOf(f).distanceTo(edge.at(edge.range.at(part))), 0, 1e-12);
      }
    }
  }
}

TEST(BodyGeometry, KnowsTheCornersOfItsFaces) {
  const BodyGeometry body(notchedBox());
  int corners = 0, others = 0;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    for (int v = 0; v < body.vertices.Extent(); ++v) {
      const bool isAtFace =
          std::any_of(body.faces[f].edges.begin(), body.faces[f].edges.end(),
                      [&](int e) { return body.edges[e].from == v || body.edges[e].to == v; });
      if (!isAtFace) continue;
      ++(body.isCorner(v, static_cast<int>(f)) ? corners : others);
    }
  }
  EXPECT_EQ(corners, 6 * 4 + 2 * 5);
  EXPECT_EQ(others, 2) << "the notch, in the top and the bottom";
}

TEST(BodyMotion, KnowsWhatSlidesAndWhatTurnsInAPlane) {
  const BodyGeometry body(notchedBox());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({20, 5, 0}, 0.3, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion motion(body, path);
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const bool isFlat = std::abs(body.surfaceOf(static_cast<int>(f)).axis.z()) > 0.5;
    EXPECT_EQ(motion.slides(static_cast<int>(f)), isFlat);
  }
  for (const BodyEdge& edge : body.edges) {
    const bool isFlat = std::abs(edge.tangent(edge.range.from).z()) < 0.5;
    EXPECT_EQ(motion.slidesAt(edge), isFlat);
    ASSERT_EQ(motion.planeOf(edge).has_value(), isFlat);
    if (!isFlat) continue;
    EXPECT_NEAR(std::abs(motion.planeOf(edge)->z()), 1, 1e-12);
  }
  const StepPath line(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({20, 5, 3}, 0, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion straight(body, line);
  EXPECT_FALSE(straight.doesTurn());
  for (std::size_t f = 0; f < body.faces.size(); ++f)
    EXPECT_FALSE(straight.slides(static_cast<int>(f)));
}

// The ends of the arcs at the seams of a cylinder touch the envelope all the time.
TEST(BodyMotion, FindsContactAtTheEndsOfEdges) {
  const BodyGeometry body(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({0, 20, 0}, 0, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion motion(body, path);
  int found = 0;
  for (const BodyEdge& edge : body.edges) {
    for (const int f : edge.faces) {
      if (body.surfaceOf(f).isPlane()) continue;
      for (const ZeroArc& arc : motion.contactsOf(edge, f, {0, 1})) {
        const Eigen::Vector2d on = arc.at(arc.range().at(0.5));
        EXPECT_NEAR(std::abs(edge.at(on.x()).x()), 2, 1e-9);
        EXPECT_NEAR(arc.range().length(), 20, 1e-9);
        ++found;
      }
    }
  }
  EXPECT_EQ(found, 8) << "two at each of four arcs, none at the seams";
}

// Bodies with one curved surface each.
std::vector<TopoDS_Shape> roundBodies() {
  const gp_Ax2 axes(gp_Pnt(3, -2, 1), gp_Dir(1, 2, 3));
  return {BRepPrimAPI_MakeCylinder(axes, 2, 5).Shape(), BRepPrimAPI_MakeCone(axes, 3, 1, 4).Shape(),
          BRepPrimAPI_MakeTorus(axes, 6, 2, 0.3, 1.2, M_PI / 2).Shape(),
          BRepPrimAPI_MakeSphere(axes, 4, 0.2, 1.3, M_PI / 2).Shape()};
}

// Each point of a half also has a foot on the other half: on the far side of the axis or the tube.
TEST(BodyGeometry, KnowsOnWhichHalfOfAClosedFaceAPointLies) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeCylinder(2, 5).Shape(), BRepPrimAPI_MakeCone(3, 1, 4).Shape(),
        BRepPrimAPI_MakeTorus(6, 2).Shape(), BRepPrimAPI_MakeSphere(4).Shape()}) {
    const BodyGeometry body(shape);
    int count = 0;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      if (body.surfaceOf(static_cast<int>(f)).isPlane()) continue;
      const BRepAdaptor_Surface kernel(body.faces[f].shape);
      for (const double part : {0.1, 0.4, 0.9}) {
        const Eigen::Vector2d on = body.faces[f].range.min() + part * body.faces[f].range.sizes();
        const gp_Pnt p = kernel.Value(on.x(), on.y());
        for (std::size_t g = 0; g < body.faces.size(); ++g) {
          if (body.faces[g].surface != body.faces[f].surface) continue;
          EXPECT_EQ(body.placeOf(static_cast<int>(g), {p.X(), p.Y(), p.Z()}),
                    f == g ? TopAbs_IN : TopAbs_OUT);
          ++count;
        }
      }
    }
    EXPECT_GE(count, 12);
  }
}

TEST(BodyGeometry, RoundSurfacesHaveTheNormalsAndParametersOfTheKernel) {
  for (const TopoDS_Shape& shape : roundBodies()) {
    const BodyGeometry body(shape);
    int count = 0;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const BodySurface& surface = body.surfaceOf(static_cast<int>(f));
      if (surface.isPlane()) continue;
      ASSERT_NE(surface.kind, BodySurface::Kind::Other);
      const Eigen::AlignedBox2d range = body.faces[f].range;
      const BRepAdaptor_Surface kernel(body.faces[f].shape);
      for (const double part : {0.1, 0.5, 0.9}) {
        const Eigen::Vector2d on = range.min() + part * range.sizes();
        gp_Pnt p;
        gp_Vec alongU, alongV;
        kernel.D1(on.x(), on.y(), p, alongU, alongV);
        const Eigen::Vector3d at(p.X(), p.Y(), p.Z());
        gp_Vec normal = alongU.Crossed(alongV).Normalized();
        if (body.faces[f].shape.Orientation() == TopAbs_REVERSED) normal.Reverse();
        const Eigen::Vector3d away(normal.X(), normal.Y(), normal.Z());
        EXPECT_NEAR((surface.normalAt(at) - away).norm(), 0, 1e-12);
        EXPECT_NEAR((surface.parametersOf(at, range.center()) - on).norm(), 0, 1e-12);
        EXPECT_NEAR(surface.distanceTo(at), 0, 1e-12);
        EXPECT_NEAR(surface.outward * surface.distanceTo(at + 0.1 * away), 0.1, 1e-12);
        ++count;
      }
    }
    EXPECT_GE(count, 3);
  }
}

// Tests points of all curves, at times at which they exist, and returns how many there are.
int testPoints(const BodySurface& surface, const StepPath& path, const ContactCurves& curves) {
  int count = 0;
  for (int curve = 0; curve < curves.count(); ++curve) {
    const Range& times = curves.times(curve);
    for (const double s : {0.0, 0.4, 1.0, times.at(0.02), times.at(0.5), times.at(0.98)}) {
      if (s < times.from || s > times.to) continue;
      for (const double part : {0.1, 0.3, 0.8}) {
        const double w = curves.extent(curve).at(part);
        const Eigen::Vector3d p = curves.at(curve, w, s);
        if (!p.allFinite()) continue;
        EXPECT_NEAR(surface.distanceTo(p), 0, 1e-9);
        EXPECT_NEAR(surface.normalAt(p).dot(Moment(path, s).velocityAt(p)), 0, 1e-9);
        EXPECT_NEAR(curves.positionAt(curve, p, s), w, 1e-9);
        EXPECT_EQ(curves.curveOf(p, s), curve);
        ++count;
      }
    }
  }
  return count;
}

TEST(ContactCurves, AreOnTheSurfaceAndOrthogonalToTheVelocity) {
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({5, 11, 7}, 0.5, Eigen::Vector3d(1, -2, 1).normalized()),
                      Interpolation::Linear);
  for (const TopoDS_Shape& shape : roundBodies()) {
    const BodyGeometry body(shape);
    int found = 0;
    for (std::size_t i = 0; i < body.surfaces.size(); ++i) {
      const BodySurface& surface = body.surfaces[i];
      if (surface.isPlane()) continue;
      const ContactCurves curves(body, static_cast<int>(i), path);
      if (surface.kind == BodySurface::Kind::Cone) {
        EXPECT_GE(curves.count(), 2);
      } else if (surface.isCylinder()) {
        EXPECT_EQ(curves.count(), 2);
      } else {
        // Of a sphere, the other curve lies behind the axis; of this torus, never on the face.
        EXPECT_EQ(curves.count(), 1);
      }
      found += testPoints(surface, path, curves);
    }
    EXPECT_GE(found, 9);
  }
}

// At the start, the cone moves along its axis so quickly that no circle touches the envelope. Later
// the wide part does, then all of it. A curve that turns round crosses the circles near its middle
// twice.
TEST(ContactCurves, OfAConeTurnRoundAtAGap) {
  const BodyGeometry body(BRepPrimAPI_MakeCone(3, 1, 4).Shape());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitY()),
                      poseAt({0, 0, 8}, 1.2, Eigen::Vector3d::UnitY()), Interpolation::Linear);
  for (std::size_t i = 0; i < body.surfaces.size(); ++i) {
    if (body.surfaces[i].kind != BodySurface::Kind::Cone) continue;
    const ContactCurves curves(body, static_cast<int>(i), path);
    int turning = 0;
    for (int curve = 0; curve < curves.count(); ++curve) {
      const double s = curves.times(curve).at(0.5), w = 0.2 * curves.extent(curve).length();
      const double onBothSides =
          (curves.at(curve, w, s) - curves.at(curve, -w, s)).dot(curves.along());
      if (curves.extent(curve).from == -curves.extent(curve).to && std::abs(onBothSides) < 1e-9)
        ++turning;
    }
    EXPECT_GE(turning, 1);
    EXPECT_GE(testPoints(body.surfaces[i], path, curves), 9 * turning);
    EXPECT_GE(curves.changes().size(), 3u);
  }
}

// All around a ring, and around a ball, contact curves come in two halves. Each begins where the
// other one ends, at all times.
TEST(ContactCurves, OfARingAndABallComeInHalves) {
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({9, 3, 7}, 0.3, Eigen::Vector3d(1, -2, 1).normalized()),
                      Interpolation::Linear);
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeTorus(6, 2).Shape(), BRepPrimAPI_MakeSphere(4).Shape()}) {
    const BodyGeometry body(shape);
    ASSERT_EQ(body.surfaces.size(), 1u);
    const ContactCurves curves(body, 0, path);
    EXPECT_GE(testPoints(body.surfaces[0], path, curves), 18);
    for (int curve = 0; curve < curves.count(); ++curve) {
      int next = 0;
      while (next < curves.count() && !curves.doesContinue(curve, next)) ++next;
      ASSERT_LT(next, curves.count());
      EXPECT_NE(next, curve);
      EXPECT_TRUE(curves.doesContinue(next, curve));
      const Range s = curves.times(curve);
      for (const double part : {0.0, 0.3, 1.0}) {
        const Eigen::Vector3d end = curves.at(curve, curves.extent(curve).to, s.at(part)),
                              start = curves.at(next, curves.extent(next).from, s.at(part));
        EXPECT_NEAR((end - start).norm(), 0, 1e-9);
      }
    }
  }
}

// The curves of this part of a ring run around the tube within a small angle. Nevertheless, equal
// steps along a curve turn the normal little.
TEST(ContactCurves, OfATorusArePositionedEvenlyWhereTheyBend) {
  const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const BodyGeometry body(BRepPrimAPI_MakeTorus(axes, 6, 2, 0.0, 1.5, 2.5).Shape());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({8, 5, 0}, 0.1, Eigen::Vector3d::UnitX()), Interpolation::Linear);
  int found = 0;
  for (std::size_t i = 0; i < body.surfaces.size(); ++i) {
    if (body.surfaces[i].kind != BodySurface::Kind::Torus) continue;
    const ContactCurves curves(body, static_cast<int>(i), path);
    for (int curve = 0; curve < curves.count(); ++curve) {
      constexpr int kSteps = 200;
      const double s = curves.times(curve).at(0.5);
      double largest = 0, sum = 0;
      Eigen::Vector3d before = Eigen::Vector3d::Zero();
      for (int k = 0; k <= kSteps; ++k) {
        const double w = curves.extent(curve).at(static_cast<double>(k) / kSteps);
        const Eigen::Vector3d normal = body.surfaces[i].normalAt(curves.at(curve, w, s));
        if (k > 0) largest = std::max(largest, (normal - before).norm());
        if (k > 0) sum += (normal - before).norm();
        before = normal;
      }
      EXPECT_LT(largest, 0.2);
      found += sum > 2;
    }
    EXPECT_GE(testPoints(body.surfaces[i], path, curves), 3);
  }
  EXPECT_GE(found, 1);
}

// A box that moves along x and a little up: its right side and its top move outward.
TEST(EnvelopeConditions, FacesAndEdgesMoveOutwardOrInward) {
  Trajectory motion;
  motion.poses = {poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                  poseAt({20, 0, 3}, 0.1, Eigen::Vector3d::UnitY())};
  const auto moving =
      std::make_shared<const MovingBody>(BRepPrimAPI_MakeBox(12, 9, 5).Shape(), motion);
  const EnvelopeConditions conditions(moving, 0);
  const auto& body = moving->body;
  const auto signOf = [&](int f) {  // 0: the face slides
    const double across = body.normalAt(body.edges[body.faces[f].edges.front()], f, 0)
                              .dot(Eigen::Vector3d(1, 0, 0.1));
    return std::abs(across) < 0.05 ? 0 : across > 0 ? 1 : -1;
  };
  const PosedBody start(body.shape, motion.poses[0]);
  int faces = 0, edges = 0;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (signOf(static_cast<int>(f)) == 0) continue;
    const TopoDS_Face posed = start.of(body.faces[f]);
    const Eigen::Vector2d middle = body.faces[f].range.center();
    EXPECT_LT(conditions.ofCap(posed, 0)(middle) * signOf(static_cast<int>(f)), 0);
    ++faces;
  }
  for (std::size_t e = 0; e < body.edges.size(); ++e) {
    const BodyEdge& edge = body.edges[e];
    const int sign = signOf(edge.faces[0]) * signOf(edge.faces[1]);
    if (sign == 0) continue;
    EXPECT_LT(conditions.ofSheet(e)({edge.range.at(0.5), 0}) * sign, 0);
    ++edges;
  }
  EXPECT_EQ(faces, 4);
  EXPECT_EQ(edges, 4);
}

// The wall of a rod that moves across its axis touches the envelope at its sides. A point of
// contact beyond the end of the rod is none.
TEST(EnvelopeConditions, ContactLiesWithinAFace) {
  Trajectory motion;
  motion.poses = {poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                  poseAt({8, 20, 0}, 0.2, Eigen::Vector3d::UnitX())};
  const auto moving =
      std::make_shared<const MovingBody>(BRepPrimAPI_MakeCylinder(2, 5).Shape(), motion);
  const EnvelopeConditions conditions(moving, 0);
  for (std::size_t i = 0; i < moving->body.surfaces.size(); ++i) {
    if (!moving->body.surfaces[i].isCylinder()) continue;
    const std::vector<Condition> both = conditions.ofGraze(
        static_cast<int>(i), ContactCurves(moving->body, static_cast<int>(i), moving->paths[0]), 0);
    ASSERT_EQ(both.size(), 2u);
    const double time = moving->motions[0].length() / 2;
    EXPECT_GT(both[0]({2.5, time}), 0);
    EXPECT_LT(both[0]({5.5, time}), 0);
    EXPECT_GT(both[1]({2.5, time}), 0);
  }
}

TEST(Zeros, AreFoundInOrder) {
  const std::vector<double> zeros = zerosOf([](double t) { return std::cos(10 * t); }, {0, 1});
  ASSERT_EQ(zeros.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(zeros[i], (0.5 + i) * M_PI / 10, 1e-12);
  EXPECT_TRUE(zerosOf([](double t) { return 1 + t; }, {0, 1}).empty());
}

TEST(Zeros, AreCurvesInTheParameters) {
  // A circle, a line that crosses the rectangle, and a saddle.
  const Range x{-2, 2}, y{-1, 3};
  const auto length = [&](const OfTwo& f) {
    double sum = 0;
    for (const ZeroArc& arc : zeroArcs(f, x, y, {1, 1})) {
      const Range range = arc.range();
      constexpr int kPieces = 1000;
      for (int i = 0; i < kPieces; ++i) {
        const Eigen::Vector2d p = arc.at(range.at(i / double(kPieces)));
        EXPECT_NEAR(f(p), 0, 1e-12);
        sum += (arc.at(range.at((i + 1) / double(kPieces))) - p).norm();
      }
    }
    return sum;
  };
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.squaredNorm() - 0.49; }),
              2 * M_PI * 0.7, 1e-4);
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.x() - p.y() / 2; }), 2 * std::sqrt(5),
              1e-9);
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.x() * (p.y() - 1.01) - 1e-4; }), 8,
              0.1);
  EXPECT_EQ(length([](const Eigen::Vector2d& p) { return p.x() + 5; }), 0);
}

}  // namespace
}  // namespace swept::step
