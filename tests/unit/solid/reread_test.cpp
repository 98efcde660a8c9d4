// A file that is read back is compared with what was to be written: each planted fault is found
// and named.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/reread.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "solid/kernel/kernel.h"
#include "solid/kernel/shape_check.h"
#include "solid/test_meshes.h"

namespace swept {
namespace {

using namespace test;

class Reread : public testing::Test {
 protected:
  Reread() : mesh_(step::buildHalfEdges(boxMesh(2, 3, 4, 5.0), run_)) {
    options_.tolerance = 0.1;
    options_.recognise = true;
  }
  std::string complaint(const TopoDS_Shape& shape) {
    return rereadComplaint(step::checkShape(shape, run_, 0, 1), mesh_, options_);
  }

  RunContext run_;
  step::KernelSession kernel_;
  step::HalfEdgeMesh mesh_;
  SolidOptions options_;
  BRep_Builder builder_;
  const TopoDS_Shape box_ = BRepPrimAPI_MakeBox(10, 15, 20).Shape();  // the solid of the mesh
};

TEST_F(Reread, WhatWasMeantHasNoComplaint) { EXPECT_EQ(complaint(box_), ""); }

TEST_F(Reread, AnEdgeWithALargerToleranceThanTheSolid) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box_, TopAbs_EDGE, edges);
  builder_.UpdateEdge(TopoDS::Edge(edges(7)), 0.0999);
  EXPECT_EQ(complaint(box_), "");
  builder_.UpdateEdge(TopoDS::Edge(edges(7)), 0.125);
  EXPECT_EQ(complaint(box_),
            "an edge or vertex with a tolerance of 0.125 mm, more than the tolerance of the solid, "
            "0.1 mm");
  // The tolerance applies to recognised surfaces only; facets keep their vertices.
  options_.recognise = false;
  EXPECT_EQ(complaint(box_), "");
}

TEST_F(Reread, AVertexWithALargerToleranceThanTheSolid) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(box_, TopAbs_VERTEX, vertices);
  builder_.UpdateVertex(TopoDS::Vertex(vertices(8)), 0.3);
  EXPECT_NE(complaint(box_).find("tolerance of 0.3 mm"), std::string::npos) << complaint(box_);
}

TEST_F(Reread, AnotherVolume) {
  const std::string message = complaint(BRepPrimAPI_MakeBox(10, 15, 30).Shape());
  EXPECT_NE(message.find("volume 4500 mm^3 instead of 3000 mm^3"), std::string::npos) << message;
}

TEST_F(Reread, AnotherNumberOfSolids) {
  TopoDS_Compound two;
  builder_.MakeCompound(two);
  builder_.Add(two, box_);
  builder_.Add(two, BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), 1, 1, 1).Shape());
  EXPECT_EQ(complaint(two), "2 solids with 2 shells instead of 1 with 1");
}

TEST_F(Reread, FacesThatAreNoSolid) {
  TopoDS_Compound open;
  builder_.MakeCompound(open);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(box_, TopAbs_FACE, faces);
  for (int i = 1; i < faces.Extent(); ++i) builder_.Add(open, faces(i));
  EXPECT_EQ(complaint(open), "no solid");
}

}  // namespace
}  // namespace swept
