// Triangles of bodies, finer than the kernel makes them, against the distance from the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fine_triangles.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "support/shapes.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr double kSize = 10;  // mm

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

// Returns how many sides of triangles do not have exactly one triangle on either side.
int openSidesOf(const TriMesh& mesh) {
  std::map<std::array<double, 3>, int> places;
  const auto placeOf = [&](std::int32_t v) {
    const Vector3d& p = mesh.vertices[v];
    return places.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(places.size())).first->second;
  };
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = placeOf(t[k]), b = placeOf(t[(k + 1) % 3]);
      if (a != b) sides[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return static_cast<int>(
      std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second != 0; }));
}

// Returns the largest distance of the middles of some triangles and sides from the shape.
double offOf(const TriMesh& mesh, const TopoDS_Shape& shape) {
  constexpr std::size_t kTriangles = 300;
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kTriangles);
  double off = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
    const auto& t = mesh.triangles[i];
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    for (const Vector3d& p : {Vector3d((a + b) / 2), Vector3d((a + b + c) / 3)}) {
      const BRepExtrema_DistShapeShape distance(
          BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Shape(), shape);
      off = std::max(off, distance.Value());
    }
  }
  return off;
}

// `same`: the shape, with small tolerances.
void expectFine(const TopoDS_Shape& shape, const TopoDS_Shape& same, double accuracy) {
  constexpr double kRounding = 2e-6;  // of the kernel's integrals and distances
  const FineTriangles fine = fineTriangles(shape, kSize);
  EXPECT_LE(fine.accuracy, accuracy);
  EXPECT_LE(offOf(fine.mesh, same), fine.accuracy + kRounding);
  EXPECT_EQ(openSidesOf(fine.mesh), 0);
  const double volume = volumeOf(same);
  EXPECT_NEAR(test::signedVolume(fine.mesh), volume,
              fine.accuracy * areaOf(same) + kRounding * volume);
}

TEST(FineTriangles, OfPlanesNeedNoMore) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(6, 5, 4).Shape();
  const FineTriangles fine = fineTriangles(box, kSize);
  EXPECT_EQ(fine.mesh.triangles.size(), 12u);
  EXPECT_LE(fine.accuracy, 1e-7 * kSize);
}

TEST(FineTriangles, LieWithinTheirAccuracy) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(2, 1, 6).Shape();
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const TopoDS_Shape crossed =
      BRepAlgoAPI_Cut(rod, BRepPrimAPI_MakeCylinder(gp_Ax2({-3, 0.3, 2}, {1, 0, 0}), 1, 6).Shape())
          .Shape();
  for (const TopoDS_Shape& shape : {rod, cone, crossed}) expectFine(shape, shape, 1e-5);
  expectFine(ring, ring, 1.25e-4);
}

// The kernel makes no triangles that are finer than the tolerances of edges.
TEST(FineTriangles, DoNotDependOnTolerances) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const TopoDS_Shape inexact = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  ShapeFix_ShapeTolerance().SetTolerance(inexact, 0.05);
  expectFine(inexact, rod, 1e-5);
}

}  // namespace
}  // namespace swept::step
