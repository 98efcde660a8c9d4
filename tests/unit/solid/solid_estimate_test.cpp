// The trial of a solid, compared with the solid: the same number of faces, and the same number
// of bytes in the file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "solid/test_meshes.h"
#include "support/temporary_folder.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace test;

struct Case {
  const char* name;
  TriMesh (*mesh)();
  double tolerance;  // mm
  std::int64_t maxFaces;
  bool recognise;
  const char* suffix;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

// Returns a torus that is bent so that no recognisable surface fits.
TriMesh wavyTorus() {
  TriMesh mesh = makeTorus(20, 6, 60, 24);
  for (auto& p : mesh.vertices) p *= 1 + 0.02 * std::sin(0.4 * p.x()) * std::cos(0.3 * p.y());
  return mesh;
}

TriMesh torus() { return makeTorus(20, 6, 160, 64); }

TriMesh frame() {
  return voxelMesh([](int i, int j, int) { return i == 0 || i == 3 || j == 0 || j == 3; }, 4, 4, 1);
}

// Returns the envelope of a box that moves along two straight lines and turns. Its solid has
// planes, curved regions and facets.
TriMesh sweptBox() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    Pose pose;
    pose.timeSeconds = i;
    pose.translation = Eigen::Vector3d(9.0 * i, i == 2 ? 7 : 0, 2 * i);
    pose.rotation = Eigen::AngleAxisd(0.3 * i, Eigen::Vector3d(0.3, 0.5, 0.8).normalized());
    trajectory.poses.push_back(pose);
  }
  Options options;
  options.resolution = 64;
  RunContext run;
  return compute(boxMesh(7, 5, 3), trajectory, options, run).mesh;
}

class SolidEstimates : public testing::TestWithParam<Case> {};

TEST_P(SolidEstimates, ATrialKnowsFacesAndBytes) {
  const Case& one = GetParam();
  const TriMesh mesh = one.mesh();
  SolidOptions options;
  options.tolerance = one.tolerance;
  options.maxFaces = one.maxFaces;
  options.recognise = one.recognise;
  const SolidFormat format = solidFormatOf(std::string("x.") + one.suffix);
  RunContext run;
  const SolidEstimate bound = guessSolid(mesh, options, format, run);
  const SolidEstimate estimate = trySolid(mesh, options, format, run);
  const TemporaryFolder folder;
  const WrittenSolid report =
      writeSolid(mesh, folder.file(std::string("x.") + one.suffix), options, run);
  EXPECT_TRUE(estimate.tried);
  EXPECT_FALSE(bound.tried);
  EXPECT_EQ(estimate.triangles, static_cast<std::int64_t>(mesh.triangles.size()));
  EXPECT_EQ(estimate.faces, report.faces);
  EXPECT_EQ(estimate.tolerance, report.tolerance);
  EXPECT_EQ(estimate.deviation, report.deviation);
  // The header contains the name of the file, so the sizes differ a little.
  EXPECT_NEAR(1e6 * estimate.megabytes, static_cast<double>(report.fileBytes), 100);
  EXPECT_GT(estimate.seconds, 0);
  EXPECT_GE(bound.faces, report.faces);
}

INSTANTIATE_TEST_SUITE_P(All, SolidEstimates,
                         testing::Values(Case{"Torus", torus, 0.02, 20000, true, "step"},
                                         Case{"TorusBrep", torus, 0.02, 20000, true, "brep"},
                                         Case{"TorusFacets", torus, 0.2, 20000, false, "step"},
                                         Case{"WavyExact", wavyTorus, 0, 20000, true, "step"},
                                         Case{"WavyLimit", wavyTorus, 0, 700, true, "step"},
                                         Case{"WavyTolerance", wavyTorus, 0.1, 20000, true, "step"},
                                         Case{"WavyBrep", wavyTorus, 0.1, 20000, true, "brep"},
                                         Case{"Frame", frame, 0, 20000, true, "step"},
                                         Case{"SweptBox", sweptBox, 0.03, 20000, true, "step"},
                                         Case{"SweptBoxLimit", sweptBox, 0, 800, true, "step"},
                                         Case{"SweptBoxCoarse", sweptBox, 0.3, 20000, true, "brep"},
                                         Case{"SweptBoxFacets", sweptBox, 0.03, 20000, false,
                                              "step"}),
                         [](const auto& one) { return std::string(one.param.name); });

// The trial refuses what writing would refuse, with the same message.
TEST(SolidTrial, RefusesWhatWritingRefuses) {
  const TemporaryFolder folder;
  const auto refusalOf = [&](const TriMesh& mesh, const SolidOptions& options, bool write) {
    RunContext run;
    try {
      write ? void(writeSolid(mesh, folder.file("x.step"), options, run))
            : void(trySolid(mesh, options, SolidFormat::Step, run));
    } catch (const Error& error) {
      return error.code() + ": " + error.what();
    }
    return std::string();
  };
  SolidOptions exact;
  exact.exact = true;
  exact.maxFaces = 100;
  SolidOptions both = exact;
  both.tolerance = 0.1;
  SolidOptions small;
  small.maxMegabytes = 1e-4;
  TriMesh open = torus();
  open.triangles.pop_back();
  for (const auto& [mesh, options] :
       {std::pair(wavyTorus(), exact), std::pair(wavyTorus(), both), std::pair(wavyTorus(), small),
        std::pair(open, SolidOptions())}) {
    const std::string words = refusalOf(mesh, options, true);
    EXPECT_NE(words, "");
    EXPECT_EQ(refusalOf(mesh, options, false), words);
  }
}

TEST(SolidTrial, IsCancelled) {
  RunContext run;
  run.cancel();
  try {
    trySolid(wavyTorus(), {}, SolidFormat::Step, run);
    FAIL() << "not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Cancelled);
  }
}

}  // namespace
}  // namespace swept
