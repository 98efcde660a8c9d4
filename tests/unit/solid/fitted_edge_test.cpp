// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fitted_edge.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <cmath>

namespace swept::step {
namespace {

constexpr double kHelixRadius = 3;

// A helix on a cylinder about the z axis. Its angle grows with the parameter, and is not
// proportional to it, unless `power` is 1.
TopoDS_Edge helix(double power) {
  return fittedEdge(
      [&](double t) -> Eigen::Vector3d {
        const double angle = std::pow(t, power);
        return {kHelixRadius * std::cos(angle), kHelixRadius * std::sin(angle), angle};
      },
      {0.5, 2});
}

class AddCurveOfTwin : public testing::Test {
 protected:
  // An edge with a curve on the face.
  TopoDS_Edge twin() const {
    const TopoDS_Edge edge = helix(1);
    addCurveOn(face_, edge, [](double t) { return Eigen::Vector2d(t, t); }, {kHelixRadius, 1},
               {0.5, 2});
    return edge;
  }
  const TopoDS_Face face_ = BRepBuilderAPI_MakeFace(
      new Geom_CylindricalSurface(gp_Ax3(), kHelixRadius), 0, 3, 0, 3, Precision::Confusion());
};

TEST_F(AddCurveOfTwin, FollowsAnEdgeWithOtherParameters) {
  TopoDS_Edge edge = helix(1.2);
  // Not from the start of the curve, as after a cut.
  double first, last;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const double from = first + 0.4 * (last - first);
  edge = BRepBuilderAPI_MakeEdge(curve, from, first + 0.8 * (last - first));
  EXPECT_FALSE(addCurveOfTwin(face_, edge, helix(1), 1e-6)) << "the other edge has no curve";
  ASSERT_TRUE(addCurveOfTwin(face_, edge, twin(), 1e-6));
  double start, end;
  const Handle(Geom2d_Curve) on = BRep_Tool::CurveOnSurface(edge, face_, start, end);
  ASSERT_FALSE(on.IsNull());
  EXPECT_EQ(start, from);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face_);
  for (int i = 0; i <= 50; ++i) {
    const double t = start + (end - start) * i / 50;
    const gp_Pnt2d q = on->Value(t);
    EXPECT_LT(surface->Value(q.X(), q.Y()).Distance(curve->Value(t)), 1e-6);
  }
}

TEST_F(AddCurveOfTwin, RefusesAnEdgeElsewhere) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(0, 0, 1e-3));
  const TopoDS_Edge moved = TopoDS::Edge(helix(1.2).Moved(shift));
  EXPECT_FALSE(addCurveOfTwin(face_, moved, twin(), 1e-4));
}

}  // namespace
}  // namespace swept::step
