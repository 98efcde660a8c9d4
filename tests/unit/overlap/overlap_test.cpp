// Shared volumes, compared with formulas, with clipping by half-spaces, and with sampling.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/checkpoint_hook.h"
#include "geometry/ray_columns.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

SharedVolume intersect(const TriMesh& a, const TriMesh& b, int threads = 2) {
  RunContext run;
  run.threads = threads;
  return sharedVolume({"a", a}, {"b", b}, run);
}

TriMesh cube(const Vector3d& low, double side) {
  return makeBox(low, low + Vector3d::Constant(side));
}

Eigen::Isometry3d placed(std::mt19937& random, double reach) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-reach, reach);
  Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
  const Eigen::Translation3d shift(even(random), even(random), even(random));
  return shift * turn.normalized();
}

/// Checks that the mesh is closed and consistently oriented. Folds from rounding are not counted.
void expectClosed(const SharedVolume& shared) {
  if (shared.mesh.triangles.empty()) return;
  RunContext run;
  const MeshCheck check = checkMesh(shared.mesh, run);
  EXPECT_EQ(check.openEdges, 0);
  EXPECT_EQ(check.misorientedEdges, 0);
  EXPECT_EQ(check.unusedVertices, 0);
  EXPECT_NEAR(check.volume, shared.volume, 1e-9 * shared.volume);
}

/// Volume of a convex polyhedron cut by the planes of another, polygon by polygon. It shares no
/// code with the code under test.
class Clipped {
 public:
  using Polygon = std::vector<Vector3d>;
  explicit Clipped(const TriMesh& mesh) {
    for (const auto& t : mesh.triangles)
      faces_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  void cut(const Vector3d& at, const Vector3d& normal) {  // keeps what lies behind the plane
    std::vector<Polygon> kept;
    Polygon lid;
    for (const Polygon& face : faces_) {
      Polygon part;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vector3d &p = face[i], &q = face[(i + 1) % face.size()];
        const double hp = normal.dot(p - at), hq = normal.dot(q - at);
        if (hp <= 0) part.push_back(p);
        if (hp == 0) lid.push_back(p);
        if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) {
          const Vector3d x = p + hp / (hp - hq) * (q - p);
          part.push_back(x);
          lid.push_back(x);
        }
      }
      if (part.size() >= 3) kept.push_back(part);
    }
    if (lid.size() >= 3) kept.push_back(ordered(lid, normal));
    faces_ = kept;
  }
  double volume() const {
    double sum = 0;
    for (const Polygon& face : faces_)
      for (std::size_t i = 2; i < face.size(); ++i)
        sum += (face[0] - origin()).dot((face[i - 1] - origin()).cross(face[i] - origin())) / 6;
    return sum;
  }

 private:
  Vector3d origin() const { return faces_[0][0]; }
  static Polygon ordered(Polygon lid, const Vector3d& normal) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : lid) middle += p / double(lid.size());
    const Vector3d u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
    std::sort(lid.begin(), lid.end(), [&](const Vector3d& a, const Vector3d& b) {
      return std::atan2(v.dot(a - middle), u.dot(a - middle)) <
             std::atan2(v.dot(b - middle), u.dot(b - middle));
    });
    return lid;
  }
  std::vector<Polygon> faces_;
};

double clippedVolume(const TriMesh& a, const TriMesh& b) {
  Clipped found(a);
  for (const auto& t : b.triangles) {
    const Vector3d &p = b.vertices[t[0]], &q = b.vertices[t[1]], &r = b.vertices[t[2]];
    found.cut(p, (q - p).cross(r - p));
  }
  return found.volume();
}

/// Returns a convex body of few triangles: a ball with random radii along the axes, turned.
TriMesh pebble(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(4, 12);
  TriMesh mesh = makeBall(Vector3d::Zero(), 1, std::uniform_int_distribution<int>(0, 2)(random));
  const Vector3d scale(radius(random), radius(random), radius(random));
  for (Vector3d& p : mesh.vertices) p = p.cwiseProduct(scale);
  return transformed(mesh, placed(random, 0));
}

/// Rounds all corners to whole numbers. Faces, edges and corners of two such parts lie on each
/// other.
TriMesh onWholeNumbers(TriMesh mesh) {
  for (Vector3d& p : mesh.vertices) p = p.array().round();
  return mesh;
}

TriMesh together(const TriMesh& a, const TriMesh& b) {
  TriMesh both = a;
  const auto first = static_cast<std::int32_t>(a.vertices.size());
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return both;
}

TEST(Overlap, BoxesAtWholeNumbersOnEachOther) {
  // Faces, edges and corners lie on each other in all combinations.
  const TriMesh a = cube(Vector3d::Zero(), 4);
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= x; ++y)
      for (int z = -5; z <= y; ++z) {
        const SharedVolume shared = intersect(a, cube({double(x), double(y), double(z)}, 4));
        const auto side = [](int d) { return std::max(0, 4 - std::abs(d)); };
        ASSERT_NEAR(shared.volume, side(x) * side(y) * side(z), 1e-10) << x << y << z;
        ASSERT_EQ(shared.mesh.triangles.empty(), shared.volume == 0) << x << y << z;
        expectClosed(shared);
      }
}

TEST(Overlap, OneInTheOtherAndFlushWithIt) {
  const TriMesh a = cube(Vector3d::Zero(), 10);
  EXPECT_NEAR(intersect(a, cube({2, 3, 4}, 2)).volume, 8, 1e-12);
  EXPECT_NEAR(intersect(a, cube({0, 0, 0}, 2)).volume, 8, 1e-12);
  EXPECT_NEAR(intersect(a, makeBox({-5, 0, 3}, {15, 10, 7})).volume, 400, 1e-9);
  EXPECT_NEAR(intersect(a, a).volume, 1000, 1e-9);
}

TEST(Overlap, ATurnedCubeInACubeIsAnOctagonPrism) {
  // The other cube is turned by 45 degrees about z. Its square of side s cuts corners off, and the
  // area 2 (sqrt 2 - 1) s^2 is left.
  const TriMesh a = cube({-5, -5, -5}, 10);
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::atan(1.0), Vector3d::UnitZ()));
  const SharedVolume shared = intersect(a, transformed(a, turn));
  EXPECT_NEAR(shared.volume, 1000 * 2 * (std::sqrt(2.0) - 1), 1e-6);
  expectClosed(shared);
}

TEST(Overlap, BallsShareALens) {
  // The common volume of two balls of radius r, d apart: pi (4 r + d) (2 r - d)^2 / 12. The
  // volume that a mesh lacks of its ball shrinks to a sixteenth with two more levels.
  const double r = 10, d = 12, exact = M_PI * (4 * r + d) * std::pow(2 * r - d, 2) / 12;
  double before = 0;
  for (int levels = 3; levels <= 5; ++levels) {
    const SharedVolume shared =
        intersect(makeBall({0, 0, 0}, r, levels), makeBall({d, 0.3, 0.1}, r, levels));
    const double lacks = 1 - shared.volume / exact;
    EXPECT_GT(lacks, 0);
    if (levels > 3) {
      EXPECT_LT(lacks, before / 2);
    }
    before = lacks;
    expectClosed(shared);
  }
  EXPECT_LT(before, 0.01);
}

TEST(Overlap, ConvexPolyhedraAgainstClippingByHalfSpaces) {
  std::mt19937 random(5);
  int shared = 0;
  for (int k = 0; k < 150; ++k) {
    const TriMesh a = pebble(random), b = transformed(pebble(random), placed(random, 8));
    const double expected = clippedVolume(a, b);
    const SharedVolume found = intersect(a, b);
    ASSERT_NEAR(found.volume, expected, 1e-9 * (1 + expected)) << k;
    expectClosed(found);
    shared += found.volume > 0;
  }
  EXPECT_GT(shared, 90);
}

TEST(Overlap, ToriAgainstSampling) {
  std::mt19937 random(11);
  const TriMesh ring = makeTorus(20, 6, 48, 24);
  for (int k = 0; k < 6; ++k) {
    const TriMesh other = transformed(ring, placed(random, 12));
    const SharedVolume found = intersect(ring, other);
    ASSERT_GT(found.volume, 0);
    expectClosed(found);
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : found.mesh.vertices) box.extend(p);
    const RayColumns first(ring), second(other);
    std::uniform_real_distribution<double> part(0, 1);
    constexpr int kPoints = 100000;
    int hits = 0;
    for (int i = 0; i < kPoints; ++i) {
      const Vector3d fractions(part(random), part(random), part(random));
      const Vector3d p = box.min() + fractions.cwiseProduct(box.sizes());
      hits += first.winding(p) != 0 && second.winding(p) != 0;
    }
    const double sampled = box.volume() * hits / kPoints;
    const double deviation = box.volume() * std::sqrt(double(hits)) / kPoints;
    EXPECT_NEAR(found.volume, sampled, 5 * deviation) << k;
  }
}

TEST(Overlap, ShellsThatOverlapCountOnce) {
  const TriMesh two = together(cube({0, 0, 0}, 4), cube({2, 0.5, 0.5}, 4));
  const SharedVolume shared = intersect(two, cube({-10, -10, -10}, 30));
  EXPECT_NEAR(shared.volume, 64 + 64 - 2 * 3.5 * 3.5, 1e-9);
  expectClosed(shared);
}

TEST(Overlap, ABodyWithACavity) {
  const TriMesh hollow = together(cube({0, 0, 0}, 10), inverted(cube({2, 2, 2}, 6)));
  EXPECT_NEAR(intersect(hollow, cube({3, 3, 3}, 2)).volume, 0, 0);
  EXPECT_NEAR(intersect(hollow, cube({1, 1, 1}, 4)).volume, 64 - 27, 1e-9);
  EXPECT_NEAR(intersect(hollow, cube({-1, -1, -1}, 12)).volume, 1000 - 216, 1e-9);
}

TEST(Overlap, WhatIsSharedAndWhatIsUnitedAddUp) {
  // A box shares with a mesh of two parts in it the union of the parts. The volumes of the union
  // and of what the parts share add up to the volumes of both parts.
  std::mt19937 random(23);
  std::uniform_int_distribution<int> by(-14, 14), kind(0, 2);
  const TriMesh all = cube({-100, -100, -100}, 200);
  const auto shape = [&] {
    switch (kind(random)) {
      case 0:
        return onWholeNumbers(makeBall({0, 0, 0}, 9, 2));
      case 1:
        return onWholeNumbers(makeTorus(12, 5, 16, 8));
      default:
        return cube({-6, -6, -6}, 12);
    }
  };
  int overlapping = 0;
  for (int k = 0; k < 60; ++k) {
    const TriMesh a = shape();
    const Eigen::Isometry3d move(Eigen::Translation3d(by(random), by(random), by(random)));
    const TriMesh b = transformed(shape(), move);
    const SharedVolume shared = intersect(a, b);
    expectClosed(shared);
    ASSERT_NEAR(intersect(b, a).volume, shared.volume, 1e-9 * (1 + shared.volume)) << k;
    const double parts = intersect(a, all).volume + intersect(b, all).volume;
    const double united = intersect(together(a, b), all).volume;
    ASSERT_NEAR(united + shared.volume, parts, 1e-9 * parts) << k;
    overlapping += shared.volume > 0;
  }
  EXPECT_GT(overlapping, 20);
}

TEST(Overlap, TheSameBytesForAnyNumberOfThreads) {
  const TriMesh a = makeTorus(20, 6, 64, 32);
  std::mt19937 random(3);
  const TriMesh b = transformed(a, placed(random, 9));
  const SharedVolume one = intersect(a, b, 1), many = intersect(a, b, 7);
  ASSERT_EQ(one.mesh.triangles, many.mesh.triangles);
  ASSERT_EQ(one.mesh.vertices, many.mesh.vertices);
  EXPECT_EQ(one.volume, many.volume);
}

TEST(Overlap, IsCancelledAtAnyCheckpoint) {
  const TriMesh a = makeTorus(20, 6, 64, 32);
  const TriMesh b = transformed(a, Eigen::Isometry3d(Eigen::Translation3d(7, 1, 2)));
  RunContext whole;
  ASSERT_EQ(checkOverlaps({{"a", a}, {"b", b}}, {}, whole).status, Status::Ok);
  for (std::uint64_t k = 1; k <= CheckpointHook::passed(whole); k += 7) {
    RunContext run;
    CheckpointHook::cancelAt(run, k);
    const OverlapReport report = checkOverlaps({{"a", a}, {"b", b}}, {}, run);
    EXPECT_EQ(report.status, Status::Cancelled) << k;
    EXPECT_TRUE(report.pairs.empty());
  }
}

OverlapReport check(const std::vector<OverlapPart>& parts, const OverlapOptions& options = {}) {
  RunContext run;
  return checkOverlaps(parts, options, run);
}

TEST(Overlap, PairsOfSeveralParts) {
  OverlapOptions options;
  options.required = 5;
  const OverlapReport report = check({{"left", cube({0, 0, 0}, 10)},
                                      {"right", cube({8, 1, 1}, 10)},
                                      {"far", cube({0, 0, 13}, 10)},
                                      {"touching", cube({-10, 0, 0}, 10)}},
                                     options);
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  ASSERT_EQ(report.pairs.size(), 6u);
  const PairOverlap& clash = report.pairs[0];
  EXPECT_EQ(clash.clearance.verdict, ClearanceVerdict::Clash);
  EXPECT_NEAR(clash.volume.value(), 2 * 9 * 9, 1e-9);
  EXPECT_NEAR(clash.clearance.penetration.depth, 2, 0.03);
  EXPECT_EQ(report.smallest, 0u);
  const PairOverlap& near = report.pairs[1];
  EXPECT_EQ(near.clearance.verdict, ClearanceVerdict::BelowRequired);
  EXPECT_NEAR(near.clearance.distance, 3, 1e-12);
  EXPECT_EQ(near.volume.value(), 0);
  const PairOverlap& touching = report.pairs[2];
  EXPECT_EQ(touching.clearance.verdict, ClearanceVerdict::Contact);
  EXPECT_EQ(touching.volume.value(), 0);
  EXPECT_NE(report.summary.find("162 mm^3 shared"), std::string::npos) << report.summary;
  EXPECT_EQ(report.summary.find("t ="), std::string::npos) << report.summary;
}

TEST(Overlap, TheSamePartTwiceIsAClash) {
  const TriMesh a = makeTorus(20, 6, 32, 16);
  const OverlapReport report = check({{"a", a}, {"b", a}});
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  EXPECT_EQ(report.pairs[0].clearance.verdict, ClearanceVerdict::Clash);
  RunContext run;
  const double whole = checkMesh(a, run).volume;
  EXPECT_NEAR(report.pairs[0].volume.value(), whole, 1e-6 * whole);
}

TEST(Overlap, BadInputIsNamed) {
  TriMesh open = cube({5, 5, 5}, 10);
  open.triangles.pop_back();
  const OverlapReport report =
      check({{"whole", cube({0, 0, 0}, 10)}, {"lid off", open}, {"block", cube({-5, 0, 0}, 10)}});
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  EXPECT_FALSE(report.pairs[0].volume.has_value());
  EXPECT_NEAR(report.pairs[1].volume.value(), 500, 1e-9);
  bool named = false;
  for (const Finding& finding : report.warnings)
    named |=
        finding.code == "NoSharedVolume" && finding.text.find("'lid off'") != std::string::npos;
  EXPECT_TRUE(named);
  RunContext run;
  try {
    sharedVolume({"whole", cube({0, 0, 0}, 10)}, {"lid off", open}, run);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "OpenMesh");
  }
  EXPECT_EQ(check({{"a", open}}).code, "NoParts");
  EXPECT_EQ(check({{"a", open}, {"a", open}}).code, "PartTwice");
  EXPECT_EQ(check({{"a", {}}, {"b", open}}).code, "EmptyMesh");
  OverlapOptions options;
  options.required = -1;
  EXPECT_EQ(check({{"a", open}, {"b", open}}, options).code, "BadOption");
}

}  // namespace
}  // namespace swept
