// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/error_text.h"
#include "support/temporary_folder.h"
#include "swept/io.h"

namespace swept {
namespace {

using test::errorText;
using test::TemporaryFolder;

// Returns triangles that a half-edge mesh would refuse, drop or round: three at one edge, two with
// the same three vertices, and numbers with many digits.
TriMesh awkwardSoup() {
  TriMesh mesh;
  mesh.vertices = {
      {100000.1234567891, 0.1, 1e-12}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3.0}, {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 2}, {2, 1, 0}};
  return mesh;
}

TEST(MeshFile, KeepsNonManifoldFacesAsTheyAre) {
  const TemporaryFolder folder;
  const TriMesh mesh = awkwardSoup();
  for (const char* suffix : {"ply", "obj", "off"}) {
    const std::string path = folder.file(std::string("soup.") + suffix);
    writeMesh(mesh, path);
    const TriMesh back = readMesh(path);
    ASSERT_EQ(back.vertices.size(), mesh.vertices.size()) << suffix;
    EXPECT_EQ(back.triangles, mesh.triangles) << suffix;
    EXPECT_EQ(back.vertices, mesh.vertices) << suffix;
  }
}

TEST(MeshFile, TextIsReadInDoublePrecision) {
  const TemporaryFolder folder;
  const std::string points = "100000.1234567891 0.1 1e-12\n1 0 0\n0 1 0\n";
  const Eigen::Vector3d expected(100000.1234567891, 0.1, 1e-12);
  const std::string off = folder.write("a.off", "OFF\n# c\n3 1 0\n" + points + "3 0 1 2\n");
  EXPECT_EQ(readMesh(off).vertices[0], expected);
  const std::string obj = folder.write(
      "a.obj", "v 100000.1234567891 0.1 1e-12\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf -4 -3/1/1 3//2\n");
  EXPECT_EQ(readMesh(obj).vertices[0], expected);
  EXPECT_EQ(readMesh(obj).triangles[0], (std::array<std::int32_t, 3>{0, 1, 2}));
}

TEST(MeshFile, StlKeepsEveryFacetInSinglePrecision) {
  const TemporaryFolder folder;
  const TriMesh mesh = awkwardSoup();
  writeMesh(mesh, folder.file("soup.STL"));
  EXPECT_EQ(std::filesystem::file_size(folder.file("soup.STL")), 84 + 50 * mesh.triangles.size());
  const TriMesh back = readMesh(folder.file("soup.STL"));
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = mesh.vertices[mesh.triangles[t][k]];
      const Eigen::Vector3d b = back.vertices[back.triangles[t][k]];
      EXPECT_EQ(a.cast<float>(), b.cast<float>());
    }
  }
}

TEST(MeshFile, NamesOutsideAsciiAndWithSpaces) {
  const TemporaryFolder folder;
  const std::string path = folder.file("Hüllkörper \xe8\xbb\x8a 1.ply");
  writeMesh(awkwardSoup(), path);
  EXPECT_EQ(readMesh(path).triangles.size(), 5U);
}

TEST(MeshFile, UnitScalesVertices) {
  const TemporaryFolder folder;
  writeMesh(awkwardSoup(), folder.file("a.ply"));
  EXPECT_DOUBLE_EQ(readMesh(folder.file("a.ply"), 25.4).vertices[1].x(), 25.4);
  const std::string text =
      errorText(Status::InvalidInput, "BadOption", [&] { readMesh(folder.file("a.ply"), 0); });
  EXPECT_NE(text.find("per unit is 0, but"), std::string::npos) << text;
}

TEST(MeshFile, SplitsPolygonsWithoutLeavingThem) {
  const TemporaryFolder folder;
  // An L: a fan from its first corner would lie outside of it.
  const std::string path = folder.write(
      "l.obj", "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 2/1 3/1 4/1 5/1 6/1 1/1\n");
  const TriMesh mesh = readMesh(path);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d n = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                  .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    EXPECT_GT(n.z(), 0);
    area += n.z() / 2;
  }
  EXPECT_DOUBLE_EQ(area, 3.0);
}

TEST(MeshFile, TextAndBigEndianPly) {
  const TemporaryFolder folder;
  const std::string head =
      "element vertex 3\r\ncomment x\r\nproperty double x\r\nproperty double y\r\n"
      "property double z\r\nproperty uchar quality\r\nelement face 1\r\n"
      "property list uchar int vertex_indices\r\nend_header\r\n";
  const std::string path =
      folder.write("a.ply", "ply\r\nformat ascii 1.0\r\n" + head +
                                "0.1 0 0 9\r\n1 0 0 9\r\n0 1 0 9\r\n3 0 1 2\r\n");
  EXPECT_EQ(readMesh(path).vertices[0].x(), 0.1);

  std::string body;
  const auto put = [&](double value) {
    std::array<char, 8> bytes{};
    std::memcpy(bytes.data(), &value, 8);
    body.append(bytes.rbegin(), bytes.rend());
  };
  std::string unixHead = head;
  unixHead.erase(std::remove(unixHead.begin(), unixHead.end(), '\r'), unixHead.end());
  for (const double value : {0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    put(value);
    if (body.size() % 25 == 24) body.push_back(9);
  }
  body += std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13);
  const TriMesh big =
      readMesh(folder.write("b.ply", "ply\nformat binary_big_endian 1.0\n" + unixHead + body));
  EXPECT_EQ(big.vertices[0].x(), 0.1);
  EXPECT_EQ(big.triangles[0], (std::array<std::int32_t, 3>{0, 1, 2}));
}

// Version 11 of OpenMesh's PLY reader crashes on the other elements of this file.
TEST(MeshFile, PlyWithPropertiesOfAllKinds) {
  const TemporaryFolder folder;
  const std::string head =
      "comment 1 2 3\nobj_info x\nelement tag 2\nproperty uchar a\nelement vertex 3\n"
      "property list uchar short more\nproperty short x\nproperty float32 y\nproperty char w\n"
      "property float64 z\nelement nothing 9\nelement edge 1\nproperty list uchar int "
      "vertex_indices\n"
      "element face 2\nproperty float quality\nproperty list uint8 uint16 vertex_index\n"
      "property list uchar float uv\nend_header\n";
  const std::string text =
      folder.write("a.ply", "ply\nformat ascii 1.0\n" + head +
                                "7 8  2 5 6 -3 0.5 1 0.1\n0 1 0 1 0\n1 9 0 1 1 0\n"
                                "2 0 1\n0.5 3 0 1 2 0\n0.5 3 2 1 0 2 .1 .2\n");
  std::string body("\7\10\2\5\0\6\0\xfd\xff\0\0\0\x3f\1", 14);
  const auto put = [&](double value) {
    std::array<char, 8> bytes{};
    std::memcpy(bytes.data(), &value, 8);
    body.append(bytes.data(), 8);
  };
  put(0.1);
  body += std::string("\0\1\0\0\0\0\0\1", 8);
  put(0);
  body += std::string("\1\11\0\0\0\0\0\x80\x3f\1", 10);
  put(0);
  body += std::string("\2\0\0\0\0\1\0\0\0", 9);
  body += std::string("\0\0\0\0\3\0\0\1\0\2\0\0", 12);
  body += std::string("\0\0\0\0\3\2\0\1\0\0\0\2", 12) + std::string(8, '\0');
  const std::string binary =
      folder.write("b.ply", "ply\nformat binary_little_endian 1.0\n" + head + body);
  for (const std::string& path : {text, binary}) {
    const TriMesh mesh = readMesh(path);
    ASSERT_EQ(mesh.vertices.size(), 3u) << path;
    EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(-3, 0.5, 0.1)) << path;
    EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0, 1, 0)) << path;
    ASSERT_EQ(mesh.triangles.size(), 2u) << path;
    EXPECT_EQ(mesh.triangles[1], (std::array<std::int32_t, 3>{2, 1, 0})) << path;
  }
}

struct BrokenMesh {
  const char* name;
  std::string bytes;
  const char* code;
  const char* says;
};

std::vector<BrokenMesh> brokenMeshes() {
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list int int vertex_indices\nend_header\n";
  std::string points(36, '\0');
  std::string hugeStl(84, '\0');
  hugeStl[83] = '\x7f';
  std::string nanStl(134, '\0');
  nanStl[80] = 1;
  std::memcpy(&nanStl[84 + 12], "\x00\x00\xc0\x7f", 4);
  return {
      {"empty.ply", "", "BadFile", "empty"},
      {"noheader.ply", "hello\n", "BadFile", "line 1"},
      {"noend.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "BadFile", "end_header"},
      {"manyvertices.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
       "element face 0\nproperty list uchar int vertex_indices\nend_header\n",
       "BadFile", "truncated"},
      {"version.ply", "ply\nformat ascii one\n", "BadFile", "version 1.0"},
      {"more.ply", "ply\nformat ascii 1.0\nelement vertex 3 4\n", "BadFile", "line 3"},
      {"nolist.ply",
       "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
       "property float z\nelement face 0\nproperty int vertex_indices\nend_header\n",
       "BadFile", "a list vertex_indices"},
      {"below.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float "
       "y\nproperty float z\nelement face 1\nproperty list char char vertex_index\nend_header\n" +
           points + std::string("\3\0\xff\1", 4),
       "BadFile", "vertex -1"},
      {"cut.ply", ply + points.substr(0, 20), "BadFile", "truncated"},
      {"cutface.ply", ply + points + std::string("\3\0\0\0\0\0\0\0", 8), "BadFile", "truncated"},
      {"hugelist.ply", ply + points + std::string("\xff\xff\xff\xff\0\0\0\0\0\0\0\0\0\0\0\0", 16),
       "BadFile", "more than the file can hold"},
      {"badindex.ply", ply + points + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\7\0\0\0", 16),
       "BadFile", "vertex 7"},
      {"text.obj", "v 0 0 0\nv 1 x 0\n", "BadFile", "line 2, column 5"},
      {"missing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "BadFile", "line 4"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "BadFile", "line 4, column 3"},
      {"two.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "BadFile", "3 corners"},
      {"counts.off", "OFF\n900000000 5 0\n", "BadFile", "truncated"},
      {"short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "BadFile", "too early"},
      {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "BadFile", "line 6, column 7"},
      {"huge.stl", hugeStl, "BadFile", "triangles"},
      {"nan.stl", nanStl, "NonFiniteVertex", "triangle 0"},
      {"text.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 zz\n",
       "BadFile", "line 5, column 12"},
      {"tiny.stl", "abc", "BadFile", "too short"},
      {"unknown.xyz", "abc", "BadFile", "unknown mesh format"},
  };
}

TEST(MeshFile, BrokenFilesAreRefusedWithAPlace) {
  const TemporaryFolder folder;
  for (const BrokenMesh& broken : brokenMeshes()) {
    const std::string path = folder.write(broken.name, broken.bytes);
    const std::string text = errorText(Status::InvalidInput, broken.code, [&] { readMesh(path); });
    EXPECT_NE(text.find(broken.says), std::string::npos) << broken.name << ": " << text;
  }
  errorText(Status::InvalidInput, "BadFile", [&] { readMesh(folder.file("absent.ply")); });
  errorText(Status::InvalidInput, "BadFile", [&] { readMesh(folder.file("")); });
}

TEST(MeshFile, EveryTruncationOfAFileIsRefusedOrWhole) {
  const TemporaryFolder folder;
  for (const char* suffix : {"ply", "stl", "off"}) {
    const std::string path = folder.file(std::string("whole.") + suffix);
    writeMesh(awkwardSoup(), path);
    const std::string bytes = TemporaryFolder::read(path);
    for (std::size_t n = 0; n + 2 < bytes.size(); ++n) {
      const std::string cut = folder.write(std::string("cut.") + suffix, bytes.substr(0, n));
      EXPECT_THROW(readMesh(cut), Error) << suffix << " cut after " << n;
    }
  }
}

TEST(MeshFile, BadInput38TargetIsTestedBeforeAndNothingIsLeft) {
  const TemporaryFolder folder;
  const TriMesh mesh = awkwardSoup();
  std::string text = errorText(Status::ExportFailed, "MissingFolder",
                               [&] { writeMesh(mesh, folder.file("no/such/a.ply")); });
  EXPECT_NE(text.find("no/such"), std::string::npos) << text;
  std::filesystem::create_directory(folder.file("folder.ply"));
  errorText(Status::ExportFailed, "BadTarget", [&] { writeMesh(mesh, folder.file("folder.ply")); });
  errorText(Status::ExportFailed, "BadFormat", [&] { writeMesh(mesh, folder.file("a.xyz")); });
  const std::string kept = folder.write("kept.ply", "old");
  std::filesystem::permissions(kept, std::filesystem::perms::owner_read);
  errorText(Status::ExportFailed, "ReadOnly", [&] { writeMesh(mesh, kept); });
  EXPECT_EQ(TemporaryFolder::read(kept), "old");
  TriMesh wrong = mesh;
  wrong.triangles[1][2] = 5;
  errorText(Status::InvalidInput, "BadIndex", [&] { writeMesh(wrong, folder.file("b.ply")); });
  EXPECT_EQ(folder.count(), 2U) << "temporary files were left behind";
}

TEST(MeshFile, BadInput36FullDiskKeepsTheOldFile) {
  std::error_code unknown;
  if (!std::filesystem::exists("/dev/full", unknown)) GTEST_SKIP() << "no /dev/full on this system";
  // No file can be created in /proc, or the write fails. In both cases there is an error with a
  // cause, and no incomplete file that looks complete.
  const TriMesh mesh = awkwardSoup();
  EXPECT_THROW(writeMesh(mesh, "/proc/swept.ply"), Error);
}

TEST(MeshFile, LargeBinaryPlyIsFast) {
  const std::string path =
      std::string(SWEPT_SHARED_DATA) + "/meshes/housing_two_halves_360k_thin.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared data are not here: " << path;
  const auto start = std::chrono::steady_clock::now();
  const TriMesh mesh = readMesh(path);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(mesh.triangles.size(), 359904U);
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LT(seconds, 5.0);
}

}  // namespace
}  // namespace swept
