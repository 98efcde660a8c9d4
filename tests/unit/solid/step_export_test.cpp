// writeSolid(): the file reads back as the right solid, and a failed run leaves no file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/checkpoint_hook.h"
#include "base/system.h"
#include "solid/test_meshes.h"
#include "support/process.h"
#include "support/sampled.h"
#include "support/shapes.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;

class StepExport : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("swept-step-" + std::to_string(os::processId()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override {
    std::error_code ignored;
    fs::permissions(folder_, fs::perms::owner_all, ignored);
    fs::remove_all(folder_, ignored);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t filesIn(const fs::path& folder) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }
  WrittenSolid write(const TriMesh& mesh, const std::string& name,
                     const SolidOptions& options = {}) {
    RunContext run;
    return writeSolid(mesh, path(name), options, run);
  }
  /// Returns the code of the failure; empty if there was none.
  std::string failure(const TriMesh& mesh, const std::string& target,
                      const SolidOptions& options = {}) {
    RunContext run;
    try {
      writeSolid(mesh, target, options, run);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::ExportFailed);
      message_ = error.what();
      return error.code();
    }
    return {};
  }
  std::string text(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  void put(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
  }

  fs::path folder_;
  std::string message_;
};

TEST_F(StepExport, BoxOfManyTrianglesBecomesSixFaces) {
  const TriMesh mesh = transformed(boxMesh(7, 5, 3, 1.3), oddTurn(), {100, -20, 3});
  for (const char* name : {"box.step", "box.stp", "box.brep", "box.brp"}) {
    const WrittenSolid report = write(mesh, name);
    EXPECT_EQ(report.faces, 6) << name;
    EXPECT_EQ(report.edges, 12) << name;
    EXPECT_EQ(report.solids, 1) << name;
    EXPECT_TRUE(report.valid) << name;
    EXPECT_NEAR(report.volume, 7 * 5 * 3 * 1.3 * 1.3 * 1.3, 1e-6) << name;
    EXPECT_NEAR(report.meshVolume, report.volume, 1e-6) << name;
    EXPECT_EQ(report.fileBytes, fs::file_size(path(name))) << name;
  }
  EXPECT_EQ(filesIn(folder_), 4U);
}

TEST_F(StepExport, WithoutMergingEveryTriangleIsAFace) {
  const TriMesh mesh = boxMesh(2, 2, 2);
  SolidOptions options;
  options.mergeCoplanar = false;
  const WrittenSolid report = write(mesh, "box.step", options);
  EXPECT_EQ(report.faces, 48);
  EXPECT_EQ(report.edges, 72);
}

TEST_F(StepExport, HolesStayHolesInTheirFace) {
  // A frame: 4 x 4 x 1 with the middle 2 x 2 missing.
  const TriMesh frame =
      voxelMesh([](int i, int j, int) { return i == 0 || i == 3 || j == 0 || j == 3; }, 4, 4, 1);
  const WrittenSolid report = write(transformed(frame, oddTurn(), {0, 0, 0}), "frame.step");
  EXPECT_EQ(report.faces, 10);
  EXPECT_EQ(report.edges, 24);
  EXPECT_NEAR(report.volume, 12, 1e-9);
}

TEST_F(StepExport, FaceWhoseOutlineTouchesItselfInAVertex) {
  // Two missing voxels of the bottom layer share a vertical edge. Four faces meet in this edge, so
  // the mesh is refused. If one of the two lies a layer higher, they share only a vertex, which the
  // outline of a face passes twice.
  const TriMesh bad = voxelMesh(
      [](int i, int j, int k) { return k > 0 || !((i == 1 && j == 1) || (i == 2 && j == 2)); }, 4,
      4, 2);
  EXPECT_EQ(failure(bad, path("bad.step")), "NonManifold");
  const TriMesh good = voxelMesh(
      [](int i, int j, int k) {
        return !(i == 1 && j == 1 && k == 0) && !(i == 2 && j == 2 && k == 1);
      },
      4, 4, 2);
  const WrittenSolid report = write(good, "good.step");
  EXPECT_TRUE(report.valid);
  EXPECT_NEAR(report.volume, 30, 1e-9);
}

TEST_F(StepExport, CavitiesAreInnerShellsOfTheirSolid) {
  auto hollow = [](int i, int j, int k) { return !(i == 2 && j == 2 && k == 2); };
  TriMesh mesh = voxelMesh(hollow, 5, 5, 5);
  TriMesh other = voxelMesh(hollow, 4, 4, 4);
  for (auto& p : other.vertices) p.x() += 10;
  append(mesh, other);
  for (const char* name : {"two.step", "two.brep"}) {
    const WrittenSolid report = write(mesh, name);
    EXPECT_EQ(report.solids, 2) << name;
    EXPECT_EQ(report.faces, 24) << name;
    EXPECT_NEAR(report.volume, 124 + 63, 1e-9) << name;
  }
}

TEST_F(StepExport, BodyInsideACavityIsASolidOfItsOwn) {
  TriMesh mesh = voxelMesh(
      [](int i, int j, int k) {
        const int far = std::max({std::abs(i - 3), std::abs(j - 3), std::abs(k - 3)});
        return far == 3 || far == 0;
      },
      7, 7, 7);
  const WrittenSolid report = write(mesh, "nested.step");
  EXPECT_EQ(report.solids, 2);
  EXPECT_NEAR(report.volume, 343 - 125 + 1, 1e-9);
}

TEST_F(StepExport, CurvedMeshKeepsItsFacets) {
  const TriMesh mesh = makeTorus(20, 6, 24, 12);
  const WrittenSolid report = write(mesh, "torus.step");
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.solids, 1);
  EXPECT_LE(report.faces, 24 * 12 * 2);
  EXPECT_NEAR(report.volume, meshVolume(mesh), 1e-6 * report.volume);
}

TEST_F(StepExport, VerticesOffThePlaneAreMergedOnlyWithinTheTolerance) {
  TriMesh mesh = boxMesh(6, 6, 6, 2.0);
  std::uint32_t seed = 1;
  for (auto& p : mesh.vertices) {
    for (int k = 0; k < 3; ++k) {
      seed = seed * 1664525U + 1013904223U;
      p[k] += 1e-3 * (static_cast<double>(seed >> 8U) / (1U << 24U) - 0.5);
    }
  }
  SolidOptions loose;
  loose.planarTolerance = 2e-3;
  const WrittenSolid merged = write(mesh, "merged.step", loose);
  EXPECT_EQ(merged.faces, 6);
  EXPECT_EQ(merged.edges, 12);
  EXPECT_TRUE(merged.valid);
  EXPECT_NEAR(merged.volume, 1728, 864 * 2e-3);
  const WrittenSolid faceted = write(mesh, "faceted.step");
  EXPECT_GT(faceted.faces, 400);
  EXPECT_TRUE(faceted.valid);
}

TEST_F(StepExport, SchemaUnitNamesAndAuthorStandInTheFile) {
  SolidOptions options;
  options.productName = "H\xC3\xBClle 'A\\B' \xE6\x8E\x83";
  options.author = "M. M\xC3\xBCller";
  options.organization = "Works";
  write(boxMesh(1, 1, 1), "a.step", options);
  const std::string a = text("a.step");
  EXPECT_NE(a.find("AUTOMOTIVE_DESIGN"), std::string::npos);
  EXPECT_NE(a.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
  EXPECT_NE(a.find("M. M\\X2\\00FC\\X0\\ller"), std::string::npos);
  EXPECT_NE(a.find("PRODUCT('H\\X2\\00FC\\X0\\lle ''A\\\\B'' \\X2\\6383\\X0\\',"),
            std::string::npos)
      << a.substr(0, 1500);
  EXPECT_NE(a.find("COLOUR_RGB('',0.93,0.78,0.2)"), std::string::npos);
  options.schema = parseStepSchema("ap242");
  write(boxMesh(1, 1, 1), "b.step", options);
  EXPECT_NE(text("b.step").find("AP242"), std::string::npos);
  EXPECT_EQ(text("b.step").find("AUTOMOTIVE_DESIGN"), std::string::npos);
  EXPECT_THROW(parseStepSchema("ap999"), Error);
}

TEST_F(StepExport, BrokenMeshesAreRefusedByName) {
  TriMesh open = boxMesh(2, 2, 2);
  open.triangles.pop_back();
  EXPECT_EQ(failure(open, path("x.step")), "OpenMesh");
  EXPECT_NE(message_.find("3 edges"), std::string::npos);
  EXPECT_NE(message_.find("the first near x = "), std::string::npos) << message_;
  TriMesh turned = boxMesh(2, 2, 2);
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  EXPECT_EQ(failure(turned, path("x.step")), "MixedOrientation");
  TriMesh inward = boxMesh(2, 2, 2);
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(failure(inward, path("x.step")), "InvertedShell");
  TriMesh index = boxMesh(1, 1, 1);
  index.triangles[0][0] = 99;
  EXPECT_EQ(failure(index, path("x.step")), "BadIndex");
  TriMesh nan = boxMesh(1, 1, 1);
  nan.vertices[2].y() = std::nan("");
  EXPECT_EQ(failure(nan, path("x.step")), "NonFiniteVertex");
  TriMesh far = boxMesh(1, 1, 1);
  far.vertices[2].y() = 2e9;
  EXPECT_EQ(failure(far, path("x.step")), "OutOfRange");
  EXPECT_EQ(failure(TriMesh{}, path("x.step")), "EmptyMesh");
  EXPECT_EQ(filesIn(folder_), 0U);
}

// Row 36: the disk (here: the allowed file size) ends in the middle of writing.
TEST_F(StepExport, BadInput36WriteFailsHalfWay) {
  if (!FileSizeLimit::available()) GTEST_SKIP() << "this system does not limit files";
  const TriMesh mesh = makeTorus(20, 6, 24, 12);
  for (const char* name : {"old.step", "old.brep"}) {
    SCOPED_TRACE(name);
    put(name, "the old file");
    std::string code;
    {
      const FileSizeLimit small(40000);
      code = failure(mesh, path(name));
    }
    EXPECT_EQ(code, "WriteFailed") << name << ": " << message_;
    EXPECT_EQ(text(name), "the old file");
  }
  EXPECT_EQ(filesIn(folder_), 2U);
}

TEST_F(StepExport, BadInput36FullDeviceIsNotATarget) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const auto before = filesIn("/dev");
  EXPECT_EQ(failure(boxMesh(1, 1, 1), "/dev/full"), "BadSuffix");
  fs::create_symlink("/dev/full", path("full.step"));
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path("full.step")), "BadTarget");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(filesIn("/dev"), before);
}

TEST_F(StepExport, BadInput38FoldersThatCannotTakeTheFile) {
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path("missing/x.step")), "MissingFolder");
  EXPECT_NE(message_.find("missing"), std::string::npos);
  fs::create_directories(path("folder.step"));
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path("folder.step")), "BadTarget");
  put("file.txt", "x");
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path("file.txt/x.step")), "MissingFolder");
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path("x.iges")), "BadSuffix");
  if (isSuperuser()) {
    // Permissions have no effect for the superuser, so a folder of the system in which no files
    // can be created is used.
    if (fs::exists("/proc/self")) {
      EXPECT_EQ(failure(boxMesh(1, 1, 1), "/proc/self/x.step"), "ReadOnly");
    }
  } else {
    fs::create_directories(path("closed"));
    fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(failure(boxMesh(1, 1, 1), path("closed/x.step")), "ReadOnly");
    put("fixed.step", "old");
    fs::permissions(path("fixed.step"), fs::perms::owner_read);
    EXPECT_EQ(failure(boxMesh(1, 1, 1), path("fixed.step")), "ReadOnly");
    EXPECT_EQ(text("fixed.step"), "old");
  }
}

TEST_F(StepExport, BadInput39TooManyFaces) {
  SolidOptions options;
  options.tolerance = 0.001;
  options.recognise = false;
  options.maxFaces = 100;
  put("x.step", "old");
  EXPECT_EQ(failure(makeTorus(20, 6, 24, 12), path("x.step"), options), "TooManyFaces");
  for (const char* word : {"limit is 100 faces", "MB", " s to make", "PLY", "STL"}) {
    EXPECT_NE(message_.find(word), std::string::npos) << word << " in " << message_;
  }
  options.maxFaces = 100000;
  options.maxMegabytes = 0.05;
  EXPECT_EQ(failure(makeTorus(20, 6, 24, 12), path("x.step"), options), "TooManyFaces");
  EXPECT_NE(message_.find("0.05 MB"), std::string::npos) << message_;
  EXPECT_EQ(text("x.step"), "old");
  EXPECT_EQ(filesIn(folder_), 1U);
}

// A solid with very many planar faces is written with its corners only. Read back, it is still
// one solid whose faces share their edges.
TEST_F(StepExport, ManyFacetsAreWrittenByTheirCorners) {
  TriMesh mesh = makeTorus(20, 6, 150, 70);
  for (auto& p : mesh.vertices) p *= 1 + 0.02 * std::sin(0.4 * p.x()) * std::cos(0.3 * p.y());
  SolidOptions options;
  options.mergeCoplanar = false;
  options.maxFaces = 30000;
  const WrittenSolid report = write(mesh, "many.step", options);
  EXPECT_EQ(report.faces, 21000);
  EXPECT_EQ(report.edges, 31500);
  EXPECT_EQ(report.solids, 1);
  EXPECT_NEAR(report.volume, meshVolume(mesh), 1e-6 * report.volume);
  EXPECT_NE(text("many.step").find("FACETED_BREP("), std::string::npos);
  EXPECT_LT(report.fileBytes, 21000U * 400);
  RunContext run;
  const SolidEstimate estimate = guessSolid(mesh, options, SolidFormat::Step, run);
  EXPECT_NEAR(estimate.megabytes, 1e-6 * static_cast<double>(report.fileBytes),
              0.15 * estimate.megabytes);
}

// An exact solid is refused, not simplified.
TEST_F(StepExport, ExactIsNotSimplified) {
  SolidOptions options;
  options.exact = true;
  options.maxFaces = 100;
  EXPECT_EQ(failure(makeTorus(20, 6, 24, 12), path("x.step"), options), "TooManyFaces");
  options.tolerance = 0.1;
  EXPECT_EQ(failure(makeTorus(20, 6, 24, 12), path("x.step"), options), "BadOption");
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    options = {};
    options.maxMegabytes = wrong;
    EXPECT_EQ(failure(boxMesh(1, 1, 1), path("x.step"), options), "BadOption") << wrong;
  }
  EXPECT_EQ(filesIn(folder_), 0U);
}

// A limit without a tolerance: the smallest tolerance of a series that meets the limit is used
// and reported.
TEST_F(StepExport, LimitsChooseTheTolerance) {
  TriMesh mesh = makeTorus(20, 6, 60, 24);
  for (auto& p : mesh.vertices) p *= 1 + 0.02 * std::sin(0.4 * p.x()) * std::cos(0.3 * p.y());
  const WrittenSolid exact = write(mesh, "exact.step");
  EXPECT_EQ(exact.tolerance, 0);
  EXPECT_GT(exact.faces, 1500);
  SolidOptions options;
  options.maxFaces = 700;
  const WrittenSolid faces = write(mesh, "faces.step", options);
  EXPECT_LE(faces.faces, 700);
  EXPECT_GT(faces.tolerance, 0);
  EXPECT_NEAR(faces.volume, exact.volume, 2600 * 2 * faces.tolerance);
  options.maxFaces = 20000;
  options.maxMegabytes = 0.5;
  const WrittenSolid bytes = write(mesh, "bytes.step", options);
  EXPECT_GT(bytes.tolerance, 0);
  EXPECT_LE(bytes.fileBytes, 500000U);
}

TEST_F(StepExport, EstimateIsOfTheRightSize) {
  const TriMesh mesh = makeTorus(20, 6, 60, 24);
  RunContext run;
  const SolidEstimate estimate = guessSolid(mesh, {}, SolidFormat::Step, run);
  EXPECT_EQ(estimate.triangles, 2880);
  const WrittenSolid report = write(mesh, "torus.step");
  EXPECT_EQ(estimate.faces, report.faces);
  EXPECT_NEAR(estimate.megabytes, 1e-6 * static_cast<double>(report.fileBytes),
              0.5 * estimate.megabytes);
}

// The kernel's mesher makes no triangles for one conical face of this part.
TEST_F(StepExport, NoFaceIsMissingWhenRead) {
  const std::string part = SWEPT_SHARED_DATA "/cad/printer_extruder_idler.step";
  if (!fs::exists(part)) GTEST_SKIP() << "shared test data not found: " << part;
  RunContext run;
  const double volume = checkSolidFile(part, run).volume;
  for (const double deflection : {0.02, 0.004}) {
    const std::vector<ImportedSolid> solids = readSolids(part, deflection, 0.2, run);
    ASSERT_EQ(solids.size(), 1U);
    EXPECT_NEAR(signedVolume(solids[0].mesh), volume, 1e-3 * volume);
    std::vector<std::int32_t> faces = solids[0].mesh.faceOf;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    EXPECT_EQ(faces.size(), 93U);
    EXPECT_EQ(faces.back(), 92);
  }
}

// A damaged file is refused, with the place of the damage, before the kernel reads it.
TEST_F(StepExport, DamagedFilesAreRefusedWhenRead) {
  write(boxMesh(2, 2, 2), "whole.step");
  RunContext run;
  EXPECT_EQ(readSolids(path("whole.step"), 0.1, 0.5, run).size(), 1U);
  const std::string whole = text("whole.step");
  const auto complaint = [&](const std::string& damaged) -> std::string {
    std::ofstream(path("damaged.step"), std::ios::binary) << damaged;
    try {
      readSolids(path("damaged.step"), 0.1, 0.5, run);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "BadFile");
      return error.what();
    }
    return "read";
  };
  const auto has = [](const std::string& message, const char* word) {
    return message.find(word) != std::string::npos;
  };
  EXPECT_PRED2(has, complaint(whole.substr(0, whole.size() / 2)), "ends before");
  EXPECT_PRED2(has, complaint(whole.substr(100)), "does not begin");
  EXPECT_PRED2(has, complaint(""), "does not begin");
  std::string bracket = whole;
  bracket.erase(bracket.find(')', bracket.find("CARTESIAN_POINT")), 1);
  EXPECT_PRED2(has, complaint(bracket), "bracket is not closed");
  std::string quote = whole;
  quote.erase(quote.rfind('\''), 1);
  EXPECT_PRED2(has, complaint(quote), "closing quote of a text is missing");
  std::string number = whole;
  number.insert(number.rfind("\n#") + 2, "99999999999");
  EXPECT_PRED2(has, complaint(number), "too large");
}

TEST_F(StepExport, BadInput40SpacesLettersAndLongNames) {
  const std::string name = "H\xC3\xBCllk\xC3\xB6rper \xE6\x89\xAB\xE6\x8E\xA0 (1)";
  fs::create_directories(path(name));
  const std::string longest(250, 'x');
  for (const std::string& file :
       {name + "/" + name + ".step", name + "/" + name + ".brep", name + "/" + longest + ".step"}) {
    EXPECT_EQ(write(boxMesh(1, 1, 1), file).faces, 6) << file;
  }
  EXPECT_EQ(filesIn(path(name)), 3U);
  EXPECT_EQ(failure(boxMesh(1, 1, 1), path(std::string(300, 'x') + ".step")), "WriteFailed");
  EXPECT_EQ(filesIn(folder_), 1U);
}

TEST_F(StepExport, OldFileIsReplacedThroughALinkAndKeepsItsMode) {
  put("real.step", "old");
  fs::permissions(path("real.step"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.step", path("link.step"));
  write(boxMesh(1, 1, 1), "link.step");
  EXPECT_TRUE(fs::is_symlink(path("link.step")));
  EXPECT_NE(text("real.step"), "old");
  EXPECT_EQ(fs::status(path("real.step")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(StepExport, CancelledAtEveryCheckpointLeavesTheOldFile) {
  const TriMesh mesh = makeTorus(20, 6, 5, 4);
  for (const char* name : {"x.step", "x.brep"}) {
    put(name, "old");
    RunContext whole;
    writeSolid(mesh, path("whole-" + std::string(name)), {}, whole);
    EXPECT_DOUBLE_EQ(whole.progress(), 1.0);
    const std::uint64_t last = CheckpointHook::passed(whole);
    ASSERT_GT(last, 10U);
    std::uint64_t cancelled = 0;
    // The kernel calls thousands of checkpoints; some hundred of them are tried, from first to
    // last.
    const std::uint64_t stride = 1 + last / (test::kUnderSanitizer ? 12 : 150);
    for (std::uint64_t k = 1; k <= last; k += stride) {
      RunContext run;
      CheckpointHook::cancelAt(run, k);
      try {
        writeSolid(mesh, path(name), {}, run);
        // The kernel does not report its progress at the same points in every run.
        EXPECT_GT(k + last / 5, last);
        put(name, "old");
      } catch (const Error& error) {
        ++cancelled;
        ASSERT_EQ(error.status(), Status::Cancelled) << k << ": " << error.what();
      }
      ASSERT_EQ(text(name), "old") << k;
    }
    EXPECT_GT(cancelled, last / stride / 2);
  }
  EXPECT_EQ(filesIn(folder_), 4U);
}

TEST_F(StepExport, TwoThreadsAtOnce) {
  const TriMesh a = boxMesh(3, 3, 3), b = makeTorus(20, 6, 12, 8);
  std::array<std::int64_t, 4> faces{};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    threads.emplace_back([&, i] {
      RunContext run;
      SolidOptions options;
      options.schema = i < 2 ? StepSchema::Ap214 : StepSchema::Ap242;
      faces[i] =
          writeSolid(i % 2 == 0 ? a : b, path(std::to_string(i) + ".step"), options, run).faces;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(faces[0], 6);
  EXPECT_EQ(faces[2], 6);
  EXPECT_EQ(faces[1], faces[3]);
  EXPECT_EQ(text("0.step").find("AP242"), std::string::npos);
  EXPECT_NE(text("2.step").find("AP242"), std::string::npos);
}

TEST_F(StepExport, TheKernelSaysNothingOnTheConsole) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  write(boxMesh(2, 2, 2), "x.step");
  const std::string out = testing::internal::GetCapturedStdout();
  const std::string err = testing::internal::GetCapturedStderr();
  EXPECT_EQ(out, "");
  EXPECT_EQ(err, "");
}

}  // namespace
}  // namespace swept
