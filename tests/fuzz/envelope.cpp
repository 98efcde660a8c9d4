// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzz/byte_source.h"
#include "fuzz/targets.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::fuzz {
namespace {

// Keeps one run within a second: the programs look for faults, not for large grids.
constexpr std::uint64_t kMemoryLimit = 64ull << 20;

TriMesh looseTriangles(ByteSource& bytes) {
  TriMesh mesh;
  const int vertices = bytes.below(24), triangles = bytes.below(40);
  for (int v = 0; v < vertices; ++v) mesh.vertices.push_back(bytes.point());
  for (int t = 0; t < triangles; ++t) {
    const auto index = [&] { return static_cast<std::int32_t>(bytes.below(vertices + 1)); };
    const std::int32_t a = index(), b = index(), c = index();
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

TriMesh evenBox(ByteSource& bytes) {
  const Eigen::Vector3d a(bytes.even(), bytes.even(), bytes.even());
  const Eigen::Vector3d size(bytes.even(), bytes.even(), bytes.even());
  return test::makeBox(a, a + size);
}

TriMesh firstBody(ByteSource& bytes) {
  switch (bytes.below(8)) {
    case 0:
      return looseTriangles(bytes);
    case 1:
      return test::makeBall({0, 0, 0}, 1 + bytes.below(4), bytes.below(3));
    case 2:
      return test::makeTorus(2, 0.25 * (1 + bytes.below(7)), 3 + bytes.below(14),
                             3 + bytes.below(9));
    case 3:
      return test::makeCylinder(1 + bytes.below(3), -1, 1, 3 + bytes.below(20));
    case 4: {
      TriMesh mesh = evenBox(bytes);
      const int more = bytes.below(4);
      for (int i = 0; i < more; ++i) test::append(mesh, evenBox(bytes));
      return mesh;
    }
    case 5:
      return test::makeSquareRing(3, 1, -bytes.below(3), bytes.even());
    default:
      return evenBox(bytes);
  }
}

/// A few blows with a hammer.
void damage(TriMesh& mesh, ByteSource& bytes) {
  const int blows = bytes.below(6);
  for (int i = 0; i < blows; ++i) {
    if (mesh.triangles.empty() || mesh.vertices.empty()) return;
    auto& triangle = mesh.triangles[bytes.byte() % mesh.triangles.size()];
    auto& vertex = mesh.vertices[bytes.byte() % mesh.vertices.size()];
    switch (bytes.below(8)) {
      case 0:
        vertex[bytes.below(3)] = bytes.special();
        break;
      case 1:
        vertex = bytes.point();
        break;
      case 2:
        vertex = mesh.vertices[bytes.byte() % mesh.vertices.size()];
        break;
      case 3:
        triangle[bytes.below(3)] = static_cast<std::int32_t>(bytes.byte()) - 2;
        break;
      case 4:
        std::swap(triangle[0], triangle[1]);
        break;
      case 5: {
        const auto copy = triangle;
        mesh.triangles.push_back(copy);
        break;
      }
      case 6:
        triangle = mesh.triangles.back();
        mesh.triangles.pop_back();
        break;
      default:
        mesh = test::inverted(mesh);
    }
  }
}

TriMesh body(ByteSource& bytes) {
  TriMesh mesh = firstBody(bytes);
  damage(mesh, bytes);
  constexpr double kScales[] = {1, 1, 1, 1, 1e-3, 1e3, 1e-9, 1e7};
  const double scale = kScales[bytes.below(8)];
  constexpr double kPlaces[] = {0, 0, 0, 0, 1, 1e6, 5e8, 1e12};
  const double place = kPlaces[bytes.below(8)];
  for (auto& v : mesh.vertices) v = v * scale + Eigen::Vector3d(place, -place, place / 3);
  return mesh;
}

Trajectory motion(ByteSource& bytes) {
  Trajectory motion;
  constexpr Interpolation kKinds[] = {Interpolation::Linear, Interpolation::Screw,
                                      Interpolation::None};
  motion.interpolation = kKinds[bytes.below(3)];
  const int poses = bytes.below(7);
  double time = 0;
  for (int i = 0; i < poses; ++i) {
    Pose pose;
    const int kind = bytes.below(8);
    if (kind < 4) {
      const Eigen::Vector3d axis(bytes.even(), bytes.even(), bytes.even() + 0.03);
      pose.rotation = Eigen::AngleAxisd(bytes.odd() / 2, axis.normalized());
    } else if (kind == 4) {
      const double x = bytes.number(), y = bytes.number(), z = bytes.number();
      pose.rotation = Eigen::Quaterniond(bytes.number(), x, y, z);
    } else if (kind == 5 && i > 0) {
      pose = motion.poses.back();
    }
    if (kind != 5) pose.translation = bytes.point();
    time += bytes.chance(250) ? 1 : bytes.number();
    pose.timeSeconds = time;
    motion.poses.push_back(pose);
  }
  return motion;
}

Options options(ByteSource& bytes) {
  Options options;
  options.backend = Backend::Cpu;
  options.resolution = 4 + bytes.below(28);
  if (bytes.chance(32)) options.cellSize = std::abs(bytes.odd());
  if (bytes.chance(8)) options.cellSize = bytes.special();
  if (bytes.chance(4)) options.resolution = bytes.byte() * 1000 - 5;
  if (bytes.chance(64)) {
    constexpr ComponentMethod kMethods[] = {
        ComponentMethod::Consistent, ComponentMethod::DualContouring,
        ComponentMethod::DualMarchingCubes, ComponentMethod::Equivalence, ComponentMethod::Greedy};
    options.components = kMethods[bytes.below(5)];
  }
  if (bytes.chance(64)) options.tolerance = std::abs(bytes.number()) / 8;
  options.keepCavities = bytes.chance(64);
  options.cull = bytes.chance(200);
  if (bytes.chance(16)) options.offset = bytes.number() / 4;
  options.conservative = bytes.chance(16);
  if (bytes.chance(16)) options.positionFilter = bytes.number() / 4;
  if (bytes.chance(16)) options.chordTolerance = bytes.number();
  if (bytes.chance(16)) options.weldTolerance = bytes.number() / 800;
  return options;
}

/// On demand (SWEPT_FUZZ_SHOW=1) the input in words, to see what an input of bytes means.
void show(const TriMesh& mesh, const Trajectory& motion, const Options& o) {
  std::printf("resolution %d cell %g components %s tolerance %g cavities %d cull %d offset %g\n",
              o.resolution, o.cellSize, componentMethodName(o.components), o.tolerance,
              o.keepCavities, o.cull, o.offset);
  std::printf("conservative %d filter %g chord %g weld %g\n", o.conservative, o.positionFilter,
              o.chordTolerance, o.weldTolerance);
  std::printf("%s\n", interpolationName(motion.interpolation));
  for (const Pose& p : motion.poses) {
    std::printf("pose %g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", p.timeSeconds,
                p.translation.x(), p.translation.y(), p.translation.z(), p.rotation.x(),
                p.rotation.y(), p.rotation.z(), p.rotation.w());
  }
  for (const auto& v : mesh.vertices) std::printf("v %.17g %.17g %.17g\n", v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles) std::printf("f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
}

void require(bool holds, const std::string& what, const Report& report) {
  if (holds) return;
  throw BrokenPromise(what + " (" + statusName(report.status) + "/" + report.code + ": " +
                      report.message + ")");
}

void requireOk(const Result& result, const Options& options) {
  const Report& report = result.report;
  require(report.code.empty() && report.message.empty(), "Ok with a complaint", report);
  require(!result.mesh.triangles.empty(), "Ok without a mesh", report);
  require(report.check.finite, "Ok with numbers that are not finite", report);
  require(report.check.passes() || options.components != ComponentMethod::Consistent,
          "Ok although the check failed", report);
  require(result.contactTime.size() == result.mesh.vertices.size(), "times do not fit", report);
  Eigen::Vector3d cells(static_cast<double>(report.grid[0]), static_cast<double>(report.grid[1]),
                        static_cast<double>(report.grid[2]));
  const Eigen::AlignedBox3d box(report.gridOrigin, report.gridOrigin + cells * report.cellSize);
  for (const auto& v : result.mesh.vertices) {
    require(box.contains(v), "a vertex outside the planned box", report);
  }
}

void requireFailure(const Result& result) {
  const Report& report = result.report;
  require(!report.code.empty() && !report.message.empty(), "a failure without a name", report);
  require(result.mesh.vertices.empty() && result.mesh.triangles.empty() &&
              result.contactTime.empty() && result.featureEdges.empty() && !result.kept,
          "a failure that leaves something", report);
  // The one status that says that the program is wrong.
  require(report.status != Status::InternalError, "internal error", report);
}

}  // namespace

void envelope(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  const Options chosen = options(bytes);
  const Trajectory way = motion(bytes);
  RunContext run;
  run.threads = 1;
  run.memoryLimitBytes = kMemoryLimit;
  if (bytes.chance(16)) run.cancelAtCheckpoint = bytes.byte();
  const TriMesh mesh = body(bytes);
  if (std::getenv("SWEPT_FUZZ_SHOW") != nullptr) show(mesh, way, chosen);
  const Result result = compute(mesh, way, chosen, run);
  if (result.report.status == Status::Ok) {
    requireOk(result, chosen);
  } else {
    requireFailure(result);
  }
}

}  // namespace swept::fuzz
