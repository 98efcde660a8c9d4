// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/specks.h"

#include <gtest/gtest.h>

#include "check/mesh_check.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

void append(Surface& surface, const TriMesh& mesh, std::uint32_t crossing) {
  const auto base = static_cast<std::int32_t>(surface.mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    surface.mesh.vertices.push_back(v);
    surface.contactTime.push_back(crossing);
    surface.cellFlags.push_back(1);
  }
  for (auto t : mesh.triangles) {
    for (auto& v : t) v += base;
    surface.mesh.triangles.push_back(t);
    surface.crossingOf.push_back(crossing);
  }
  surface.dualVertices = surface.mesh.vertices.size();
}

Specks drop(Surface& surface, SelfIntersections& pairs, double mostVolume = kSpeckVolume) {
  RunContext run;
  return dropSpecks(surface, 1, mostVolume, pairs, run);
}

TEST(Specks, OnlyWhatIsFarSmallerThanACellGoes) {
  Surface surface;
  append(surface, makeBox({5, 0, 0}, {5.2, 0.2, 0.2}), 0);    // volume 0.008: a speck
  append(surface, makeBox({0, 0, 0}, {3, 3, 3}), 1);          // stays
  append(surface, makeBox({8, 0, 0}, {8.3, 0.3, 0.3}), 2);    // volume 0.027: stays
  append(surface, makeBox({0, 9, 0}, {2.5, 9.01, 0.01}), 3);  // thin but long: stays
  const auto faces = static_cast<std::int32_t>(makeBox({0, 0, 0}, {1, 1, 1}).triangles.size());
  SelfIntersections pairs{2, {{0, faces + 1}, {faces + 2, 2 * faces + 3}}};
  const Specks found = drop(surface, pairs);
  EXPECT_EQ(found.count, 1);
  EXPECT_NEAR(found.largestVolume, 0.008, 1e-9);
  ASSERT_EQ(surface.mesh.triangles.size(), 3u * faces);
  EXPECT_EQ(surface.crossingOf.front(), 1u);
  EXPECT_EQ(surface.contactTime.size(), surface.mesh.vertices.size());
  EXPECT_EQ(surface.dualVertices, surface.mesh.vertices.size());
  EXPECT_EQ(surface.contactTime.front(), 1.0);
  RunContext run;
  EXPECT_TRUE(checkMesh(surface.mesh, false, run).closed);
  ASSERT_EQ(pairs.count, 1);
  EXPECT_EQ(pairs.pairs.front(), std::pair(2, faces + 3));
}

TEST(Specks, TheLastShellStays) {
  Surface surface;
  append(surface, makeBox({0, 0, 0}, {0.1, 0.1, 0.1}), 0);
  append(surface, makeBox({1, 0, 0}, {1.1, 0.1, 0.1}), 1);
  SelfIntersections pairs;
  EXPECT_EQ(drop(surface, pairs).count, 0);
  EXPECT_EQ(surface.mesh.triangles.size(), surface.crossingOf.size());
}

TEST(Specks, WhereSmallPartsStayAShellWithoutVolumeGoes) {
  Surface surface;
  append(surface, makeBox({0, 0, 0}, {3, 3, 3}), 0);
  append(surface, makeBox({5, 0, 0}, {5.01, 0.01, 0.01}), 1);
  append(surface, makeBox({8, 0, 0}, {8.1, 0.1, 0}), 2);  // without volume
  SelfIntersections pairs;
  EXPECT_EQ(drop(surface, pairs, kFlatVolume).count, 1);
  ASSERT_EQ(surface.mesh.vertices.size(), 16u);
  RunContext run;
  EXPECT_TRUE(checkMesh(surface.mesh, false, run).oriented);
}

TriMesh turnedOver(TriMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

std::int64_t turn(Surface& surface) {
  RunContext run;
  MeshTopology topology;
  checkMesh(surface.mesh, topology, run);
  return turnInsideOut(surface, topology, 1, run);
}

TEST(Specks, SmallShellsInsideOutAreTurnedAndNoOthers) {
  Surface surface;
  append(surface, makeBox({0, 0, 0}, {9, 9, 9}), 0);
  append(surface, turnedOver(makeBox({4, 4, 4}, {5, 5, 5})), 0);  // a correct cavity
  append(surface, makeBox({20, 0, 0}, {20.1, 0.1, 1e-5}), 1);
  append(surface, turnedOver(makeBox({20, 5, 0}, {20.1, 5.1, 1e-5})), 2);
  append(surface, makeBox({2, 2, 2}, {2.1, 2.1, 2.1}), 2);  // a cavity inside out
  RunContext run;
  ASSERT_FALSE(checkMesh(surface.mesh, false, run).oriented);
  EXPECT_EQ(turn(surface), 2);
  EXPECT_TRUE(checkMesh(surface.mesh, false, run).oriented);
  EXPECT_EQ(turn(surface), 0);
  append(surface, turnedOver(makeBox({30, 0, 0}, {39, 9, 9})), 3);  // too large: a fault
  EXPECT_EQ(turn(surface), 0);
}

}  // namespace
}  // namespace swept::test
