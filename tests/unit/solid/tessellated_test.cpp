// Tessellated solids (AP242): what the file contains, what is read back, what is refused.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text/tessellated.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/system.h"
#include "solid/test_meshes.h"
#include "solid/text/step_scan.h"
#include "support/shapes.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;

class Tessellated : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() /
            ("swept-tessellated-" + std::to_string(os::processId()) + ".stp");
  }
  void TearDown() override { fs::remove(file_); }
  WrittenSolid write(const TriMesh& mesh, const SolidOptions& options) {
    RunContext run;
    return writeSolid(mesh, file_.string(), options, run);
  }
  static SolidOptions options() {
    SolidOptions result;
    result.schema = parseStepSchema("ap242-tessellated");
    return result;
  }
  std::string text() const {
    std::ifstream in(file_, std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  static int count(const std::string& all, const std::string& word) {
    int found = 0;
    for (std::size_t at = all.find(word); at != std::string::npos; at = all.find(word, at + 1))
      ++found;
    return found;
  }
  std::string codeOf(const TriMesh& mesh, const SolidOptions& options) {
    try {
      write(mesh, options);
    } catch (const Error& error) {
      return error.code();
    }
    return {};
  }
  fs::path file_;
};

TEST_F(Tessellated, HoldsTheTrianglesOfTheMesh) {
  const TriMesh mesh = transformed(makeTorus(20, 6, 60, 24), oddTurn(), {1e4, -3, 0.5});
  const WrittenSolid report = write(mesh, options());
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.solids, 1);
  EXPECT_EQ(report.faces, static_cast<std::int64_t>(mesh.triangles.size()));
  EXPECT_EQ(report.deviation, 0);
  EXPECT_NEAR(report.volume, meshVolume(mesh), 1e-6 * report.volume);
  const std::string all = text();
  std::istringstream scanned(all), again(all);
  EXPECT_EQ(step::stepComplaint(scanned), "");
  EXPECT_EQ(count(all, "=TESSELLATED_SOLID("), 1);
  EXPECT_EQ(count(all, "=TESSELLATED_SHAPE_REPRESENTATION("), 1);
  EXPECT_EQ(count(all, "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING"), 1);
  RunContext run;
  const TriMesh read = step::readTessellated(again, run);
  ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < read.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE((read.vertices[read.triangles[t][k]] - mesh.vertices[mesh.triangles[t][k]]).norm(),
                2e-9);
    }
  }
}

TEST_F(Tessellated, HollowSpacesBelongToTheirSolid) {
  // Two boxes of 3 x 3 x 3 cells; the first one is hollow.
  const TriMesh mesh = voxelMesh(
      [](int x, int y, int z) { return x != 3 && !(x == 1 && y == 1 && z == 1); }, 7, 3, 3);
  const WrittenSolid report = write(mesh, options());
  EXPECT_EQ(report.solids, 2);
  EXPECT_NEAR(report.volume, 27 + 26, 1e-9);
  const std::string all = text();
  EXPECT_EQ(count(all, "=TESSELLATED_SOLID("), 2);
  EXPECT_EQ(count(all, "=TRIANGULATED_FACE("), 3);
}

TEST_F(Tessellated, RefusesWhatItCannotDo) {
  SolidOptions with = options();
  with.tolerance = 0.1;
  EXPECT_EQ(codeOf(boxMesh(2, 2, 2), with), "BadOption");
  with = options();
  with.maxMegabytes = 0.01;
  EXPECT_EQ(codeOf(makeTorus(20, 6, 60, 24), with), "TooManyFaces");
  TriMesh open = boxMesh(2, 2, 2);
  open.triangles.pop_back();
  EXPECT_NE(codeOf(open, options()), "");
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Tessellated, EstimateKnowsTheSizeOfTheFile) {
  const TriMesh mesh = makeTorus(20, 6, 120, 60);
  RunContext run;
  const SolidEstimate estimate = trySolid(mesh, options(), SolidFormat::Step, run);
  EXPECT_EQ(estimate.faces, static_cast<std::int64_t>(mesh.triangles.size()));
  EXPECT_NEAR(estimate.megabytes, 1e-6 * static_cast<double>(write(mesh, options()).fileBytes),
              0.25 * estimate.megabytes);
}

TEST_F(Tessellated, DamagedTextIsNotReadBack) {
  write(boxMesh(2, 2, 2), options());
  const std::string all = text();
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string changed = all;
    changed.replace(changed.find(from), from.size(), to);
    std::istringstream in(changed);
    RunContext run;
    try {
      step::readTessellated(in, run);
    } catch (const Error& error) {
      return error.code();
    }
    return std::string();
  };
  EXPECT_EQ(broken("=COORDINATES_LIST('',26,", "=COORDINATES_LIST('',25,"), "RereadFailed");
  EXPECT_EQ(broken(",(),$,(),((", ",(),$,(),((9"), "RereadFailed");
  EXPECT_EQ(broken("=TRIANGULATED_FACE('',#1,", "=TRIANGULATED_FACE('',#9,"), "RereadFailed");
}

}  // namespace
}  // namespace swept
