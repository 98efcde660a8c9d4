// Solids as their recipient would test them: FreeCAD's geometry check with its BOP test,
// tolerances of edges, cut and common with a block. Also tests that this check finds faults.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <filesystem>
#include <fstream>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "base/system.h"
#include "judge/solid_judge.h"
#include "solid/test_meshes.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST(SolidJudge, SoundSolidsAreClean) {
  const auto box = judgeSolid(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), 9, true);
  EXPECT_TRUE(box.valid);
  EXPECT_TRUE(box.faults.empty());
  EXPECT_EQ(box.faces, 6);
  EXPECT_NEAR(box.volume, 6000, 1e-6);
  EXPECT_NEAR(box.blockError, 0, 1e-9);
  EXPECT_LE(box.edgeTolerance, 1e-7);
  const auto rod = judgeSolid(BRepPrimAPI_MakeCylinder(5, 20).Shape(), 9, true);
  EXPECT_TRUE(rod.faults.empty());
  EXPECT_NEAR(rod.blockError, 0, 1e-7);
}

TEST(SolidJudge, FindsFacesThatIntersect) {
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(9, 3, 3), gp_Pnt(15, 6, 6)).Shape());
  const auto judged = judgeSolid(both, 9, false);
  EXPECT_GE(judged.faults.count("SelfIntersect"), 1U);
  ASSERT_FALSE(judged.details.empty());
  EXPECT_NE(judged.details.front().find("SelfIntersect"), std::string::npos);
}

TEST(SolidJudge, FindsAnEdgeOffItsFaceAndAWideTolerance) {
  // A planar face with a circle as its border. The file says that the circle lies in the plane,
  // but it is 0.01 mm above it.
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0.01), gp_Dir(0, 0, 1)), 5);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle);
  BRepBuilderAPI_MakeFace face(gp_Pln(gp::XOY()), BRepBuilderAPI_MakeWire(edge).Wire());
  const auto off = judgeSolid(face.Face(), 9, false);
  EXPECT_EQ(off.faults.count("InvalidCurveOnSurface"), 1U);
  // With a tolerance larger than the gap, there is no fault, and the tolerance is reported.
  const BRep_Builder builder;
  for (TopExp_Explorer it(face.Face(), TopAbs_EDGE); it.More(); it.Next())
    builder.UpdateEdge(TopoDS::Edge(it.Current()), 0.02);
  const auto wide = judgeSolid(face.Face(), 9, false);
  EXPECT_EQ(wide.faults.count("InvalidCurveOnSurface"), 0U);
  EXPECT_NEAR(wide.edgeTolerance, 0.02, 1e-9);
}

TEST(SolidJudge, FindsATinyEdge) {
  BRepBuilderAPI_MakeWire wire;
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {5, 0, 0}, {5, 1.5e-7, 0}, {0, 5, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]));
  const auto judged =
      judgeSolid(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire()).Face(), 9, false);
  EXPECT_FALSE(judged.faults.empty());
}

TEST(SolidJudge, SaysWhatCannotBeRead) {
  EXPECT_THROW(readShape("/nowhere/at-all.step"), std::runtime_error);
}

// Returns three poses with turns, as when a part is moved by hand.
Trajectory turningPath(double size) {
  Trajectory trajectory;
  trajectory.poses.resize(3);
  const std::array<Eigen::Vector3d, 2> shifts{Eigen::Vector3d(0.62, 0.13, 0.21),
                                              Eigen::Vector3d(0.93, 0.71, 0.12)};
  const std::array<Eigen::AngleAxisd, 2> turns{
      Eigen::AngleAxisd(0.44, Eigen::Vector3d(0.3, 0.5, 0.8).normalized()),
      Eigen::AngleAxisd(0.72, Eigen::Vector3d(-0.2, 0.7, 0.4).normalized())};
  for (std::size_t i = 0; i < 2; ++i) {
    Pose& pose = trajectory.poses[i + 1];
    pose.timeSeconds = static_cast<double>(i) + 1;
    pose.translation = size * shifts[i];
    pose.rotation = Eigen::Quaterniond(turns[i]);
  }
  return trajectory;
}

TriMesh ring() {
  std::vector<Eigen::Vector2d> profile;
  line(profile, {4, 0}, {9, 0}, 4);
  line(profile, {9, 0}, {9, 6}, 4);
  line(profile, {9, 6}, {4, 6}, 4);
  line(profile, {4, 6}, {4, 0}, 4);
  return revolved(profile, true, 160);
}

TriMesh bracket() {
  return voxelMesh(
      [](int x, int y, int z) {
        const bool plate = z < 2, wall = x < 2;
        const bool slot = x >= 4 && x < 8 && y >= 3 && y < 5;
        return (plate || wall) && !slot;
      },
      12, 8, 9);
}

struct SupplierCase {
  const char* name;
  TriMesh (*body)();
  bool turns;
};

class ForSuppliers : public testing::TestWithParam<SupplierCase> {};

TEST_P(ForSuppliers, TheCheckFindsNothing) {
  const SupplierCase& one = GetParam();
  Options options;
  options.resolution = 96;
  RunContext run;
  const TriMesh body = transformed(one.body(), oddTurn(), {3, -2, 5});
  const Trajectory motion = one.turns ? turningPath(18) : along({13, 7, 21});
  const Result result = compute(body, motion, options, run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : result.mesh.vertices) box.extend(p);
  SolidOptions step;
  step.tolerance = 1e-3 * box.diagonal().norm();
  const fs::path file = fs::temp_directory_path() /
                        ("supplier-" + std::to_string(os::processId()) + "-" + one.name + ".step");
  const WrittenSolid report = writeSolid(result.mesh, file.string(), step, run);
  const auto judged = judgeSolid(readShape(file.string()), 9, true);
  fs::remove(file);
  EXPECT_EQ(report.note, "");
  EXPECT_LE(report.deviation, step.tolerance);
  EXPECT_LE(report.edgeTolerance, step.tolerance);
  // The report agrees with what a reader of the file finds.
  EXPECT_NEAR(report.edgeTolerance, std::max(judged.edgeTolerance, judged.vertexTolerance),
              0.01 * report.edgeTolerance + 1e-7);
  EXPECT_EQ(report.faces, judged.faces);
  EXPECT_TRUE(judged.valid);
  EXPECT_EQ(judged.solids, 1);
  EXPECT_TRUE(judged.faults.empty()) << (judged.details.empty() ? "" : judged.details.front());
  EXPECT_GE(judged.blockError, 0);
  EXPECT_LE(judged.blockError, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Parts, ForSuppliers,
                         testing::Values(SupplierCase{"ring-turned", ring, true},
                                         SupplierCase{"bracket-turned", bracket, true},
                                         SupplierCase{"ring-lifted", ring, false},
                                         SupplierCase{"bracket-lifted", bracket, false}),
                         [](const auto& one) {
                           std::string name = one.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace swept
