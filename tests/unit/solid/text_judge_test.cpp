// The library writes the same data, whether the linked kernel checks the shape of a solid or
// another program that reads its text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text_judge.h"

#include <gtest/gtest.h>

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <sstream>

#include "solid/kernel/kernel.h"
#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/test_meshes.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace test;

/// Reads with OpenCASCADE, as FreeCAD's Part does, and uses nothing else of this library.
class Outside : public StepReader {
 public:
  Answer read(const std::string& text) override {
    ++reads;
    RunContext run;
    step::KernelSession kernel;
    std::istringstream stream(text);
    const TopoDS_Shape shape = step::readStepText(stream, kernel, run);
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      faces.push_back(it.Current());
    Answer answer{step::checkShape(shape, run, 0, 0), step::findBadFaces(faces, run, 0, 0)};
    if (refuses(answer.check)) answer.badFaces.assign(1, 0);
    return answer;
  }
  int reads = 0;
  std::function<bool(const SolidCheck&)> refuses = [](const SolidCheck&) { return false; };
};

/// Returns the file without its header, which has the time.
std::string dataOf(const std::string& file) {
  const std::string text = TemporaryFolder::read(file);
  return text.substr(std::min(text.size(), text.find("DATA;")));
}

struct JudgedBody {
  const char* name;
  TriMesh mesh;
  double tolerance;
};

std::vector<JudgedBody> cases() {
  TriMesh two = makeBall({0, 0, 0}, 5, 4);
  append(two, makeBox({10, 0, 0}, {14, 3, 2}));
  return {{"box", makeBox({0, 0, 0}, {3, 2, 1}), 0},
          {"box with a tolerance", makeBox({0, 0, 0}, {3, 2, 1}), 0.01},
          {"torus", makeTorus(20, 6, 96, 48), 0.1},
          {"torus as it is", makeTorus(20, 6, 24, 12), 0},
          {"ball", makeBall({1, 2, 3}, 7, 4), 0.05},
          {"small ball", makeBall({1, 2, 3}, 0.5, 4), 0.01},
          {"large ball", makeBall({1, 2, 3}, 300, 4), 2},
          {"cylinder", makeCylinder(4, -3, 9, 96), 0.02},
          {"two bodies", two, 0.05}};
}

TEST(TextJudge, TheSolidIsTheOneOfTheKernel) {
  const TemporaryFolder folder;
  for (const JudgedBody& one : cases()) {
    SCOPED_TRACE(one.name);
    SolidOptions options;
    options.tolerance = one.tolerance;
    Outside reader;
    RunContext run, other;
    const WrittenSolid kernel = writeSolid(one.mesh, folder.file("kernel.step"), options, run);
    const WrittenSolid outside =
        writeSolid(one.mesh, folder.file("outside.step"), options, reader, other);
    EXPECT_TRUE(dataOf(folder.file("kernel.step")) == dataOf(folder.file("outside.step")));
    EXPECT_EQ(outside.edges, kernel.edges);
    EXPECT_GE(reader.reads, 1);
    EXPECT_TRUE(outside.valid);
    EXPECT_EQ(outside.facesByKind, kernel.facesByKind);
    EXPECT_EQ(outside.deviation, kernel.deviation);
    EXPECT_NEAR(outside.volume, kernel.volume, 1e-5 * kernel.volume);
  }
}

TEST(TextJudge, AFaceThatTheReaderRefusesLosesItsSurface) {
  const TemporaryFolder folder;
  SolidOptions options;
  options.tolerance = 0.1;
  Outside reader;
  // Refuses checks of few faces: those of the curved faces alone, which make no solid.
  reader.refuses = [](const SolidCheck& check) { return check.faces < 10; };
  RunContext run;
  const WrittenSolid report =
      writeSolid(makeTorus(20, 6, 96, 48), folder.file("x.step"), options, reader, run);
  EXPECT_TRUE(report.valid);
  for (const auto& [kind, count] : report.facesByKind) EXPECT_NE(kind, "torus") << count;
  EXPECT_LE(report.deviation, options.tolerance);
}

TEST(TextJudge, ASolidThatTheReaderRefusesIsNotWritten) {
  class Never : public StepReader {
    Answer read(const std::string& /*text*/) override {
      Answer answer;
      answer.check.complaint = "I like nothing";
      return answer;
    }
  } never;
  const TemporaryFolder folder;
  const std::string path = folder.write("old.step", "the old file");
  RunContext run;
  try {
    writeSolid(makeBox({0, 0, 0}, {3, 2, 1}), path, {}, never, run);
    ADD_FAILURE() << "it was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "RereadDiffers");
    EXPECT_EQ(std::string(error.what()).find("the solid was not saved"), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("I like nothing"), std::string::npos);
  }
  EXPECT_EQ(TemporaryFolder::read(path), "the old file");
  EXPECT_EQ(folder.count(), 1U);
  EXPECT_THROW(writeSolid(makeBox({0, 0, 0}, {3, 2, 1}), folder.file("x.brep"), {}, never, run),
               Error);
}

}  // namespace
}  // namespace swept
