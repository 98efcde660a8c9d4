// Compares an envelope with the true one, by dense distances over continuous time.
//   swept_deviation MESH MOTION.csv MM_PER_UNIT RESOLUTION... [--samples N] [--tolerance MM]
// Prints, in cells: deviation of creases at the first and last key (mean / max), fraction of the
// area whose normal is more than 20 degrees off, distance of the result from the truth (mean, p95,
// p99, max) and of the truth from the result (max).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "support/swept_distance.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace {

using swept::TriMesh;
using swept::test::MeshDistance;
using swept::test::SweptDistance;
using V3 = Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;

struct SurfacePoint {
  V3 point, normal;
};

/// Returns random points on a mesh, evenly distributed over its area.
std::vector<SurfacePoint> spread(const TriMesh& mesh, int count, std::mt19937& random) {
  std::vector<double> sums;
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += (mesh.vertices[t[1]] - mesh.vertices[t[0]])
               .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
               .norm();
    sums.push_back(sum);
  }
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const double at = sum * (i + unit(random)) / count;
    const auto index =
        std::min<std::ptrdiff_t>(std::lower_bound(sums.begin(), sums.end(), at) - sums.begin(),
                                 static_cast<std::ptrdiff_t>(sums.size()) - 1);
    const auto& t = mesh.triangles[index];
    double u = unit(random), v = unit(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const V3 a = mesh.vertices[t[0]], e = mesh.vertices[t[1]] - a, f = mesh.vertices[t[2]] - a;
    points.push_back({a + u * e + v * f, e.cross(f).normalized()});
  }
  return points;
}

/// Returns points on the sharp edges of the body, placed at the first and the last key, that lie on
/// the envelope.
std::vector<V3> creasePoints(const SweptDistance& truth, double spacing, double slack) {
  std::vector<V3> points;
  const TriMesh& mesh = truth.body().mesh();
  for (const double time : {0.0, truth.lastTime()}) {
    const Eigen::Isometry3d place = truth.placement(time);
    for (const auto& edge : truth.edges()) {
      const V3 left = truth.body().normal(edge.left), right = truth.body().normal(edge.right);
      if (left.dot(right) > std::cos(30 * kDegree)) continue;
      const V3 a = place * mesh.vertices[edge.a], b = place * mesh.vertices[edge.b];
      const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
      for (int i = 0; i < steps; ++i) points.push_back(a + (b - a) * ((i + 0.5) / steps));
    }
  }
  std::vector<char> keep(points.size(), 0);
  tbb::parallel_for(std::size_t{0}, points.size(),
                    [&](std::size_t i) { keep[i] = truth.distance(points[i]) > -slack; });
  std::vector<V3> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i] != 0) kept.push_back(points[i]);
  }
  return kept;
}

/// Returns points of the true envelope: of faces at both ends, and of contour edges at random
/// times.
std::vector<V3> truthPoints(const SweptDistance& truth, int count, double slack,
                            std::mt19937& random) {
  std::vector<V3> points;
  const TriMesh& mesh = truth.body().mesh();
  for (const double time : {0.0, truth.lastTime()}) {
    const Eigen::Isometry3d place = truth.placement(time);
    for (const auto& p : spread(mesh, count / 2, random)) points.push_back(place * p.point);
  }
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<std::size_t> any(0, truth.edges().size() - 1);
  for (int tries = 0, found = 0; truth.lastTime() > 0 && found < 4 * count && tries < 400 * count;
       ++tries) {
    const double time = truth.lastTime() * unit(random);
    const auto& edge = truth.edges()[any(random)];
    const Eigen::Isometry3d place = truth.placement(time);
    const V3 x = place * (mesh.vertices[edge.a] +
                          unit(random) * (mesh.vertices[edge.b] - mesh.vertices[edge.a]));
    const V3 velocity = truth.velocity(time, x, false);
    const double left = velocity.dot(place.linear() * truth.body().normal(edge.left));
    const double right = velocity.dot(place.linear() * truth.body().normal(edge.right));
    if (left * right > 0) continue;
    points.push_back(x);
    ++found;
  }
  std::vector<char> keep(points.size(), 0);
  tbb::parallel_for(std::size_t{0}, points.size(),
                    [&](std::size_t i) { keep[i] = truth.distance(points[i]) > -slack; });
  std::vector<V3> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i] != 0) kept.push_back(points[i]);
  }
  return kept;
}

void printPlace(const char* what, const V3& p, const swept::Report& report) {
  const V3 g = (p - report.gridOrigin) / report.cellSize;
  std::printf("    %s at (%.4f %.4f %.4f) mm, grid (%.3f %.3f %.3f)\n", what, p.x(), p.y(), p.z(),
              g.x(), g.y(), g.z());
}

void measureCreases(const SweptDistance& truth, const MeshDistance& out,
                    const swept::Report& report) {
  const double cell = report.cellSize;
  const std::vector<V3> creases = creasePoints(truth, cell / 2, 0.005 * cell);
  double mean = 0, most = 0;
  V3 worst = V3::Zero();
  std::vector<double> all;
  for (const V3& p : creases) {
    const double d = out.distance(p) / cell;
    all.push_back(d);
    mean += d / static_cast<double>(creases.size());
    if (d > most) {
      most = d;
      worst = p;
    }
  }
  std::sort(all.begin(), all.end());
  std::printf("  creases at both ends (%zu points): mean %.4f  p99 %.4f  max %.4f\n",
              creases.size(), mean, all.empty() ? 0 : all[all.size() * 99 / 100], most);
  printPlace("max", worst, report);
}

/// Returns whether the true envelope has, within `reach`, a normal that differs by less than 20
/// degrees from that of the point. The single nearest point is not enough: near a valley or crease
/// it may lie on the other side, because the result deviates a little. Queries start outside, where
/// nearest points are exact.
bool hasNormalNear(const SweptDistance& truth, const SurfacePoint& at, double reach) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto agrees = [&](const V3& from) {
    const auto contact = truth.contact(from);
    if (contact.distance <= 0 || (contact.point - at.point).norm() > reach) return false;
    return std::any_of(contact.normals.begin(), contact.normals.end(),
                       [&](const V3& n) { return n.dot(at.normal) >= std::cos(20 * kDegree); });
  };
  if (agrees(at.point + 0.5 * reach * at.normal)) return true;
  for (int k = 0; k < 48; ++k) {
    const V3 direction(normal(random), normal(random), normal(random));
    if (agrees(at.point + (k % 2 == 0 ? 1.0 : 0.5) * reach * direction.normalized())) return true;
  }
  return false;
}

void measureSurface(const SweptDistance& truth, const MeshDistance& out,
                    const swept::Report& report, int samples, std::mt19937& random) {
  const double cell = report.cellSize;
  const auto points = spread(out.mesh(), samples, random);
  std::vector<double> deviation(points.size());
  std::vector<char> off(points.size(), 0);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    const auto contact = truth.contact(points[i].point);
    deviation[i] = std::abs(contact.distance) / cell;
    off[i] = !hasNormalNear(truth, points[i], std::abs(contact.distance) + 0.03 * cell);
  });
  std::size_t worst = 0;
  double mean = 0, fraction = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (deviation[i] > deviation[worst]) worst = i;
    mean += deviation[i] / static_cast<double>(points.size());
    fraction += off[i] / static_cast<double>(points.size());
  }
  std::vector<double> sorted = deviation;
  std::sort(sorted.begin(), sorted.end());
  std::printf("  normals over 20 degrees off: %.3f %% of the area\n", 100 * fraction);
  for (std::size_t i = 0, shown = 0; i < points.size() && shown < 6; ++i) {
    if (off[i] == 0) continue;
    printPlace("off", points[i].point, report);
    ++shown;
  }
  std::printf("  out to truth: mean %.4f  p95 %.4f  p99 %.4f  max %.4f\n", mean,
              sorted[sorted.size() * 95 / 100], sorted[sorted.size() * 99 / 100], sorted.back());
  printPlace("max", points[worst].point, report);
}

void measureMissing(const SweptDistance& truth, const MeshDistance& out,
                    const swept::Report& report, int samples, std::mt19937& random) {
  const double cell = report.cellSize;
  const std::vector<V3> points = truthPoints(truth, samples, 0.005 * cell, random);
  double most = 0;
  V3 worst = V3::Zero();
  for (const V3& p : points) {
    const double d = out.distance(p) / cell;
    if (d > most) {
      most = d;
      worst = p;
    }
  }
  std::printf("  truth to out (%zu points): max %.4f\n", points.size(), most);
  printPlace("max", worst, report);
}

int run(int count, char** arguments) {
  if (count < 5) {
    std::fprintf(stderr,
                 "usage: swept_deviation MESH MOTION.csv MM_PER_UNIT RESOLUTION... [--samples N] "
                 "[--tolerance MM]\n");
    return 2;
  }
  const double unit = std::atof(arguments[3]);
  int samples = 20000;
  swept::Options options;
  std::vector<int> resolutions;
  for (int i = 4; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--samples" && i + 1 < count) {
      samples = std::atoi(arguments[++i]);
    } else if (argument == "--tolerance" && i + 1 < count) {
      options.tolerance = std::atof(arguments[++i]);
    } else {
      resolutions.push_back(std::atoi(arguments[i]));
    }
  }
  const TriMesh body = swept::readMesh(arguments[1], unit);
  swept::Trajectory motion =
      swept::readTrajectoryCsv(arguments[2], unit, swept::Interpolation::Linear);
  for (const int resolution : resolutions) {
    options.resolution = resolution;
    swept::RunContext context;
    const swept::Result result = swept::compute(body, motion, options, context);
    const swept::Report& report = result.report;
    if (report.status != swept::Status::Ok) {
      std::printf("resolution %d: %s\n", resolution, report.message.c_str());
      return 1;
    }
    std::printf("resolution %d: cell %.5g mm, %lld triangles, %.2f s, self-intersections %lld\n",
                resolution, report.cellSize, static_cast<long long>(report.check.triangles),
                report.seconds.back().seconds,
                static_cast<long long>(report.check.selfIntersections.value_or(0)));
    const SweptDistance truth(body, motion, 0.1 * report.cellSize);
    const MeshDistance out(result.mesh);
    std::mt19937 random(1);
    measureCreases(truth, out, report);
    measureSurface(truth, out, report, samples, random);
    measureMissing(truth, out, report, samples / 10, random);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
