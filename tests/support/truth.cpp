// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/truth.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/mesh_distance.h"
#include "support/profile.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;
constexpr int kBallLevels = 5;  // sagitta below 2e-4 of the radius

Trajectory keys(const std::vector<Eigen::Isometry3d>& placements,
                Interpolation interpolation = Interpolation::Linear) {
  Trajectory motion;
  motion.interpolation = interpolation;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    motion.poses.push_back(poseOf(static_cast<double>(i), placements[i]));
  }
  return motion;
}

Trajectory alongLine(const V3& travel) {
  return keys({placement({0, 0, 1}, 0, {0, 0, 0}), placement({0, 0, 1}, 0, travel)});
}

/// Returns evenly spread directions (golden-angle spiral).
std::vector<V3> directions(int count) {
  std::vector<V3> result;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = M_PI * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - z * z);
    result.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return result;
}

Truth ballAlongLine() {
  Truth truth;
  truth.name = "ball_along_line";
  const double r = 3;
  const V3 a(0, 0, 0), travel(7, 4, 2);
  truth.body = makeBall(a, r, kBallLevels);
  truth.motion = alongLine(travel);
  truth.distance = [=](const V3& p) {
    const double t = std::clamp((p - a).dot(travel) / travel.squaredNorm(), 0.0, 1.0);
    return std::abs((p - a - t * travel).norm() - r);
  };
  truth.volume = 4.0 / 3 * M_PI * r * r * r + M_PI * r * r * travel.norm();
  truth.area = 4 * M_PI * r * r + 2 * M_PI * r * travel.norm();
  for (const V3& d : directions(2000)) {
    truth.surface.push_back(d.dot(travel) < 0 ? V3(a + r * d) : V3(a + travel + r * d));
    const V3 side = (d - d.dot(travel) / travel.squaredNorm() * travel).normalized();
    truth.surface.push_back(a + 0.5 * (d.x() + 1) * travel + r * side);
  }
  return truth;
}

/// The envelope is the Minkowski sum of a box and a line segment: a solid with parallelogram faces.
Truth boxAlongLine() {
  Truth truth;
  truth.name = "box_along_line";
  const V3 half(2, 1.5, 1), travel(4.1, 2.7, 3.3);
  truth.body = makeBox(-half, half);
  truth.motion = alongLine(travel);
  const V3 g[4] = {V3(half.x(), 0, 0), V3(0, half.y(), 0), V3(0, 0, half.z()), travel / 2};
  TriMesh hull;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const V3 n = g[i].cross(g[j]);
      for (const double sign : {1.0, -1.0}) {
        V3 middle = travel / 2;
        for (int k = 0; k < 4; ++k) {
          if (k != i && k != j) middle += (sign * n.dot(g[k]) > 0 ? 1 : -1) * g[k];
        }
        const V3 u = sign * g[i], v = g[j];
        const auto first = static_cast<std::int32_t>(hull.vertices.size());
        const V3 corners[4] = {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
        for (int k = 0; k < 4; ++k) {
          hull.vertices.push_back(corners[k]);
          for (int s = 0; s < 60; ++s) {
            truth.creases.push_back(corners[k] + (corners[(k + 1) % 4] - corners[k]) * (s / 60.0));
          }
        }
        hull.triangles.push_back({first, first + 1, first + 2});
        hull.triangles.push_back({first, first + 2, first + 3});
        for (int s = 0; s < 900; ++s) {
          truth.surface.push_back(middle + (s % 30 / 15.0 - 1) * u + (s / 30 / 15.0 - 1) * v);
        }
      }
    }
  }
  truth.volume = signedVolume(hull);
  truth.area = surfaceArea(hull);
  const auto tree = std::make_shared<MeshDistance>(hull);
  truth.distance = [tree](const V3& p) { return tree->distance(p); };
  return truth;
}

Truth boxTurningAboutEdge() {
  Truth truth;
  truth.name = "box_turning_about_edge";
  const double a = 6, b = 2.5, h = 3, turn = 100 * M_PI / 180;
  truth.body = makeBox({0, 0, 0}, {a, b, h});
  truth.motion = keys({placement({0, 0, 1}, 0, {0, 0, 0}), placement({0, 0, 1}, 100, {0, 0, 0})});
  const double radius = std::hypot(a, b), tip = std::atan2(b, a);
  const Eigen::Vector2d far(radius * std::cos(tip + turn), radius * std::sin(tip + turn));
  const Eigen::Vector2d top(-b * std::sin(turn), b * std::cos(turn));
  Profile profile;
  profile.line({0, 0}, {a, 0});
  profile.line({a, 0}, {a, b});
  profile.arc({0, 0}, radius, tip, turn);
  profile.line(far, top);
  profile.line(top, {0, 0});
  profile.extrude(0, h, 0.1, truth);
  return truth;
}

Truth cylinderAlongAxis() {
  Truth truth;
  truth.name = "cylinder_along_axis";
  truth.body = makeCylinder(2.5, 0, 3, 720);
  truth.motion = alongLine({0, 0, 4});
  Profile profile;
  profile.arc({0, 0}, 2.5, 0, 2 * M_PI);
  profile.extrude(0, 7, 0.12, truth);
  return truth;
}

Truth ballOnCircle() {
  Truth truth;
  truth.name = "ball_on_circle_400_degrees";
  const double ring = 5, r = 1.6;
  truth.body = makeBall({ring, 0, 0}, r, kBallLevels);
  std::vector<Eigen::Isometry3d> placements;
  for (int i = 0; i <= 4; ++i) placements.push_back(placement({0, 0, 1}, 100.0 * i, {0, 0, 0}));
  truth.motion = keys(placements);
  truth.distance = [=](const V3& p) {
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - ring, p.z()) - r);
  };
  truth.volume = 2 * M_PI * M_PI * ring * r * r;
  truth.area = 4 * M_PI * M_PI * ring * r;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double u = 2 * M_PI * i / 100, v = 2 * M_PI * j / 40, q = ring + r * std::cos(v);
      truth.surface.emplace_back(q * std::cos(u), q * std::sin(u), r * std::sin(v));
    }
  }
  return truth;
}

std::vector<Eigen::Vector2d> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
std::vector<Eigen::Vector2d> hole(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

Truth ringAlongAxis() {
  Truth truth;
  truth.name = "square_ring_along_axis";
  truth.body = makeSquareRing(4, 2.6, 0, 1.5);
  truth.motion = alongLine({0, 0, 5});
  Profile profile;
  profile.polygon(rectangle(-4, -4, 4, 4));
  profile.polygon(hole(-2.6, -2.6, 2.6, 2.6));
  profile.extrude(0, 6.5, 0.12, truth);
  return truth;
}

Truth ringAcrossAxis() {
  Truth truth;
  truth.name = "square_ring_across_axis";
  truth.body = makeSquareRing(4, 2.6, 0, 1.5);
  truth.motion = alongLine({2.2, 0, 0});
  Profile profile;
  profile.polygon(rectangle(-4, -4, 6.2, 4));
  profile.polygon(hole(-0.4, -2.6, 2.6, 2.6));  // the space that stays free all the time
  profile.extrude(0, 1.5, 0.12, truth);
  return truth;
}

Truth helixOfBall() {
  Truth truth;
  truth.name = "helix_of_ball";
  // The pitch of 4 is larger than the diameter of the ball.
  const double ring = 4, r = 1.1, turns = 1.5, rise = 4 * turns;
  truth.body = makeBall({ring, 0, 0}, r, kBallLevels);
  std::vector<Eigen::Isometry3d> placements;
  for (int i = 0; i <= 6; ++i) {
    placements.push_back(placement({0, 0, 1}, 90.0 * i, {0, 0, rise * i / 6}));
  }
  truth.motion = keys(placements, Interpolation::Screw);
  auto at = [=](double t) {
    const double angle = 2 * M_PI * turns * t;
    return V3(ring * std::cos(angle), ring * std::sin(angle), rise * t);
  };
  truth.distance = [=](const V3& p) {
    double bestT = 0, best = 1e300;
    const int coarse = 400;
    for (int i = 0; i <= coarse; ++i) {
      const double d = (at(i / double(coarse)) - p).norm();
      if (d < best) {
        best = d;
        bestT = i / double(coarse);
      }
    }
    double low = std::max(0.0, bestT - 1.0 / coarse), high = std::min(1.0, bestT + 1.0 / coarse);
    for (int i = 0; i < 60; ++i) {
      const double p1 = low + (high - low) / 3, p2 = high - (high - low) / 3;
      (at(p1) - p).norm() < (at(p2) - p).norm() ? high = p2 : low = p1;
    }
    return std::abs((at((low + high) / 2) - p).norm() - r);
  };
  const double length = std::hypot(2 * M_PI * turns * ring, rise);
  truth.volume = M_PI * r * r * length + 4.0 / 3 * M_PI * r * r * r;
  truth.area = 2 * M_PI * r * length + 4 * M_PI * r * r;
  for (int i = 0; i <= 120; ++i) {
    const double t = i / 120.0;
    const V3 tangent = (at(std::min(1.0, t + 1e-6)) - at(std::max(0.0, t - 1e-6))).normalized();
    const V3 u = tangent.cross(V3::UnitZ()).normalized(), v = tangent.cross(u);
    for (int j = 0; j < 24; ++j) {
      const double angle = 2 * M_PI * j / 24;
      truth.surface.push_back(at(t) + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  return truth;
}

Truth twoEqualKeys() {
  Truth truth;
  truth.name = "two_equal_keys";
  truth.body = makeBox({-3, -2, -1}, {3, 2, 1});
  truth.motion = keys({placement({0, 0, 1}, 0, {1, 1, 1}), placement({0, 0, 1}, 0, {1, 1, 1})});
  Profile profile;
  profile.polygon(rectangle(-2, -1, 4, 3));
  profile.extrude(0, 2, 0.1, truth);
  return truth;
}

Truth sealedCavity() {
  Truth truth;
  truth.name = "sealed_cavity";
  truth.body = makeBox({0, 0, 0}, {5, 4, 3});
  append(truth.body, inverted(makeBox({1, 1, 1}, {4, 3, 2})));
  truth.motion = alongLine({1.5, 0, 0});
  Profile profile;
  profile.polygon(rectangle(0, 0, 6.5, 4));
  profile.extrude(0, 3, 0.1, truth);
  return truth;
}

}  // namespace

std::vector<Truth> allTruths() {
  return {ballAlongLine(), boxAlongLine(),  boxTurningAboutEdge(), cylinderAlongAxis(),
          ballOnCircle(),  ringAlongAxis(), ringAcrossAxis(),      helixOfBall(),
          twoEqualKeys(),  sealedCavity()};
}

std::vector<Truth> thinPlates(double thickness) {
  std::vector<Truth> plates(3);
  const TriMesh plate = makeBox({0, 0, 0}, {6, 4, thickness});
  plates[0].name = "plate_in_its_plane";
  plates[0].motion = alongLine({3, 2, 0});
  Profile hexagon;
  hexagon.polygon({{0, 0}, {6, 0}, {9, 2}, {9, 6}, {3, 6}, {0, 4}});
  hexagon.extrude(0, thickness, 0.12, plates[0]);
  plates[0].thickness = thickness;

  plates[1].name = "plate_across_its_plane";
  plates[1].motion = alongLine({0, 0, 2});
  Profile box;
  box.polygon(rectangle(0, 0, 6, 4));
  box.extrude(0, 2 + thickness, 0.12, plates[1]);

  plates[2].name = "plate_turned_in_its_plane";
  const double turn = 50 * M_PI / 180, radius = std::hypot(6.0, 4.0), tip = std::atan2(4.0, 6.0);
  plates[2].motion =
      keys({placement({0, 0, 1}, 0, {0, 0, 0}), placement({0, 0, 1}, 50, {0, 0, 0})});
  const Eigen::Vector2d top(-4 * std::sin(turn), 4 * std::cos(turn));
  Profile fan;
  fan.line({0, 0}, {6, 0});
  fan.line({6, 0}, {6, 4});
  fan.arc({0, 0}, radius, tip, turn);
  fan.line({radius * std::cos(tip + turn), radius * std::sin(tip + turn)}, top);
  fan.line(top, {0, 0});
  fan.extrude(0, thickness, 0.12, plates[2]);
  plates[2].thickness = thickness;
  for (Truth& truth : plates) truth.body = plate;
  return plates;
}

Truth placed(Truth truth, const Eigen::Isometry3d& frame) {
  for (Pose& pose : truth.motion.poses) {
    pose.rotation = Eigen::Quaterniond(frame.linear()) * pose.rotation;
    pose.translation = frame * pose.translation;
  }
  const Eigen::Isometry3d back = frame.inverse();
  truth.distance = [inner = truth.distance, back](const V3& p) { return inner(back * p); };
  for (V3& p : truth.surface) p = frame * p;
  for (V3& p : truth.creases) p = frame * p;
  return truth;
}

}  // namespace swept::test
