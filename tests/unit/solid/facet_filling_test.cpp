// Solids with holes between their faces that facets of a mesh fill.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/facet_filling.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <map>

#include "judge/solid_judge.h"
#include "solid/test_meshes.h"
#include "support/shapes.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

std::vector<TopoDS_Face> facesOf(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, TopAbs_FACE, found);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= found.Extent(); ++i) faces.push_back(TopoDS::Face(found(i)));
  return faces;
}

constexpr double kRodRadius = 5;

// Returns the wall and the lower end of a cylinder.
std::vector<TopoDS_Face> cupOf(double height) {
  std::vector<TopoDS_Face> faces;
  for (const TopoDS_Face& face : facesOf(BRepPrimAPI_MakeCylinder(kRodRadius, height).Shape())) {
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() != GeomAbs_Plane || surface.Plane().Location().Z() < height / 2)
      faces.push_back(face);
  }
  return faces;
}

class FacetFilling : public testing::Test {
 protected:
  // Fills a cup to a whole rod.
  void fillCup(double height, double whole) {
    const std::vector<TopoDS_Face> cup = cupOf(height);
    ASSERT_EQ(cup.size(), 2u);
    fill(BRepPrimAPI_MakeCylinder(kRodRadius, whole).Shape(), cup,
         test::makeCylinder(kRodRadius, 0, whole, 90));
    EXPECT_EQ(count(GeomAbs_Cylinder), 1);
  }
  // Fills the holes of faces of a body at rest, whose mesh is given. `wrong`: points of faces that
  // turn out to be wrong afterwards.
  void fill(const TopoDS_Shape& body, const std::vector<TopoDS_Face>& faces, const TriMesh& mesh,
            const std::vector<Eigen::Vector3d>& wrong = {}) {
    Trajectory rest;
    rest.poses.resize(2);
    const Sides sides(body, rest);
    const HalfEdgeMesh whole = buildHalfEdges(mesh, run_);
    FacetFiller filler(faces, whole, sides, kTolerance, run_);
    filled_ = filler.fill({});
    if (!wrong.empty()) filled_ = filler.fill(wrong);
    ASSERT_FALSE(filled_.shape.IsNull());
    judged_ = test::judgeSolid(filled_.shape, 9, true);
    EXPECT_TRUE(judged_.valid);
    EXPECT_EQ(judged_.solids, 1);
    EXPECT_TRUE(judged_.faults.empty()) << (judged_.details.empty() ? "" : judged_.details.front());
    EXPECT_LE(judged_.edgeTolerance, 1e-6);
    EXPECT_LE(judged_.blockError, 1e-9);
  }
  int count(GeomAbs_SurfaceType kind) const {
    int found = 0;
    for (const TopoDS_Face& face : facesOf(filled_.shape))
      found += BRepAdaptor_Surface(face, Standard_False).GetType() == kind;
    return found;
  }

  static constexpr double kTolerance = 0.1;
  RunContext run_;
  FilledSolid filled_;
  test::JudgedSolid judged_;
};

TEST_F(FacetFilling, OneFacetReplacesASideOfABox) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  std::vector<TopoDS_Face> faces = facesOf(box);
  faces.erase(faces.begin() + 2);
  fill(box, faces, test::makeBox({0, 0, 0}, {12, 8, 5}));
  EXPECT_EQ(judged_.faces, 6);
  EXPECT_EQ(filled_.planes, 1);
  EXPECT_EQ(filled_.cones, 0);
  EXPECT_NEAR(judged_.volume, 480, 1e-9);
}

TEST_F(FacetFilling, FacesWithoutHolesStayAsTheyAre) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  fill(box, facesOf(box), test::makeBox({0, 0, 0}, {12, 8, 5}));
  EXPECT_EQ(judged_.faces, 6);
  EXPECT_EQ(filled_.planes + filled_.cones, 0);
  EXPECT_NEAR(judged_.volume, 480, 1e-9);
}

TEST_F(FacetFilling, ACylinderKeepsItsWallWithoutItsTop) {
  fillCup(8, 8);
  EXPECT_EQ(filled_.planes, 1);
  EXPECT_NEAR(judged_.volume, 25 * M_PI * 8, 1e-6);
}

TEST_F(FacetFilling, FacetsReplaceTheWallOfACylinder) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(5, 3).Shape();
  std::vector<TopoDS_Face> faces;
  for (const TopoDS_Face& face : facesOf(rod)) {
    if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Plane) faces.push_back(face);
  }
  fill(rod, faces, test::makeCylinder(5, 0, 3, 90));
  EXPECT_EQ(count(GeomAbs_Cylinder), 0);
  EXPECT_GT(filled_.planes, 10);
  EXPECT_NEAR(judged_.volume, 25 * M_PI * 3, 0.02 * 25 * M_PI * 3);
}

TEST_F(FacetFilling, FacesThatTurnOutToBeWrongAreReplaced) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  fill(box, facesOf(box), test::makeBox({0, 0, 0}, {12, 8, 5}), {{12, 4, 2}, {6, 4, 5}});
  EXPECT_GT(filled_.planes, 0);
  EXPECT_EQ(judged_.faces, 4 + filled_.planes);
  EXPECT_NEAR(judged_.volume, 480, 1e-9);
}

TEST_F(FacetFilling, ACavityThatTheMeshDoesNotHaveIsLeftOut) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  std::vector<TopoDS_Face> faces = facesOf(box);
  for (const TopoDS_Face& face : facesOf(BRepPrimAPI_MakeBox(gp_Pnt(4, 3, 2), 2, 2, 1).Shape()))
    faces.push_back(TopoDS::Face(face.Reversed()));
  fill(box, faces, test::makeBox({0, 0, 0}, {12, 8, 5}));
  EXPECT_EQ(judged_.faces, 6);
  EXPECT_NEAR(judged_.volume, 480, 1e-9);
}

// Returns the faces of a rod whose wall has a slit along the axis.
std::vector<TopoDS_Face> slitRod(double height, double width) {
  const double angle = width / kRodRadius;
  std::vector<TopoDS_Face> faces;
  TopoDS_Face wall;
  for (const TopoDS_Face& face :
       facesOf(BRepPrimAPI_MakeCylinder(kRodRadius, height, 2 * M_PI - angle).Shape())) {
    if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Cylinder) wall = face;
  }
  faces.push_back(wall);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(wall, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() != GeomAbs_Circle) continue;
    const gp_Circ circle = curve.Circle();
    const TopoDS_Edge rest =
        BRepBuilderAPI_MakeEdge(circle, TopExp::LastVertex(edge), TopExp::FirstVertex(edge));
    TopoDS_Face end = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge, rest).Wire());
    const bool isTop = circle.Location().Z() > height / 2;
    if ((BRepAdaptor_Surface(end).Plane().Axis().Direction().Z() > 0) !=
        (isTop == (end.Orientation() == TopAbs_FORWARD)))
      end.Reverse();
    faces.push_back(end);
  }
  return faces;
}

TEST_F(FacetFilling, OneFaceFillsANarrowSlit) {
  fill(BRepPrimAPI_MakeCylinder(kRodRadius, 8).Shape(), slitRod(8, 0.02),
       test::makeCylinder(kRodRadius, 0, 8, 90));
  EXPECT_EQ(judged_.faces, 4);
  EXPECT_EQ(filled_.cones, 1);
  EXPECT_EQ(filled_.planes, 0);
  EXPECT_NEAR(judged_.volume, 25 * M_PI * 8, 1e-6);
}

TEST_F(FacetFilling, FacetsFillAWideSlit) {
  fill(BRepPrimAPI_MakeCylinder(kRodRadius, 8).Shape(), slitRod(8, 2),
       test::makeCylinder(kRodRadius, 0, 8, 90));
  EXPECT_GT(filled_.cones + filled_.planes, 2);
  EXPECT_NEAR(judged_.volume, 25 * M_PI * 8, 0.02 * 25 * M_PI * 8);
}

TEST_F(FacetFilling, FacesWithLittleOfTheAreaAreNotWorthIt) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  std::vector<TopoDS_Face> faces = facesOf(box);
  faces.resize(1);
  Trajectory rest;
  rest.poses.resize(2);
  const Sides sides(box, rest);
  const HalfEdgeMesh mesh = buildHalfEdges(test::makeBox({0, 0, 0}, {12, 8, 5}), run_);
  EXPECT_TRUE(FacetFiller(faces, mesh, sides, kTolerance, run_).fill({}).shape.IsNull());
  EXPECT_TRUE(FacetFiller({}, mesh, sides, kTolerance, run_).fill({}).shape.IsNull());
}

TEST_F(FacetFilling, ConesContinueHalfAWall) {
  fillCup(4, 8);
  EXPECT_GT(filled_.cones, 4);
  EXPECT_NEAR(judged_.volume, 25 * M_PI * 8, 0.02 * 25 * M_PI * 8);
}

TEST_F(FacetFilling, AFaceThatIsNotOnTheSurfaceIsLeftOut) {
  // A dent takes the place of the top.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(12, 8, 5).Shape();
  std::vector<TopoDS_Face> faces;
  TopoDS_Face top;
  for (const TopoDS_Face& face : facesOf(box)) {
    const gp_Pln plane = BRepAdaptor_Surface(face).Plane();
    if (plane.Location().Z() > 4 && std::abs(plane.Axis().Direction().Z()) > 0.5) {
      top = face;
    } else {
      faces.push_back(face);
    }
  }
  ASSERT_FALSE(top.IsNull());
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(top, TopAbs_EDGE, edges);
  const TopoDS_Vertex bottom = BRepBuilderAPI_MakeVertex(gp_Pnt(6, 4, 3));
  std::map<const void*, TopoDS_Edge> slopes;
  const auto slopeAt = [&](const TopoDS_Vertex& corner) {
    TopoDS_Edge& edge = slopes[corner.TShape().get()];
    if (edge.IsNull()) edge = BRepBuilderAPI_MakeEdge(corner, bottom).Edge();
    return edge;
  };
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge, slopeAt(TopExp::FirstVertex(edge)),
                                                     slopeAt(TopExp::LastVertex(edge)));
    TopoDS_Face side = BRepBuilderAPI_MakeFace(wire);
    if (BRepAdaptor_Surface(side).Plane().Axis().Direction().Z() < 0) side.Reverse();
    faces.push_back(side);
  }
  fill(box, faces, test::boxMesh(12, 8, 5));
  EXPECT_EQ(judged_.faces, 6);
  EXPECT_NEAR(judged_.volume, 480, 1e-9);
}

}  // namespace
}  // namespace swept::step
