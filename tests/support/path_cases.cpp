// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/path_cases.h"

#include <array>
#include <numbers>

#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

TriMesh boxAt(double x0, double x1, double y0, double y1, double z0, double z1) {
  return makeBox({x0, y0, z0}, {x1, y1, z1});
}

Pose shifted(const Vector3d& t) {
  Pose pose;
  pose.translation = t;
  return pose;
}

Eigen::Isometry3d randomFrame(Random& random) {
  return placement(random.point(1) + Vector3d(0, 0, 1e-3), random.number(0, 180), random.point(50));
}

Pose after(const Eigen::Isometry3d& frame, const Pose& pose) {
  Pose out;
  out.rotation = (Eigen::Quaterniond(frame.linear()) * pose.rotation).normalized();
  out.translation = frame * pose.translation;
  return out;
}

// Everything in a frame that no axis of the world is parallel to; the part in one of its own.
PathCase inFrames(PathCase c, Random& random) {
  const Eigen::Isometry3d world = randomFrame(random);
  Eigen::Isometry3d own = randomFrame(random);
  own.translation() *= 0.1;
  c.part = transformed(c.part, own);
  for (TriMesh& mesh : c.neighbours) mesh = transformed(mesh, world);
  for (Pose* pose : {&c.start, &c.goal}) {
    const Eigen::Isometry3d back = own.inverse();
    Pose local;
    local.rotation = (pose->rotation * Eigen::Quaterniond(back.linear())).normalized();
    local.translation = pose->rotation * back.translation() + pose->translation;
    *pose = after(world, local);
  }
  return c;
}

// Walls round a space open towards +x: half width w, from x = 0 to length.
TriMesh channelWalls(double w, double length, double thick) {
  TriMesh walls;
  append(walls, boxAt(-thick, 0, -w - thick, w + thick, -w - thick, w + thick));
  append(walls, boxAt(0, length, w, w + thick, -w - thick, w + thick));
  append(walls, boxAt(0, length, -w - thick, -w, -w - thick, w + thick));
  append(walls, boxAt(0, length, -w, w, w, w + thick));
  append(walls, boxAt(0, length, -w, w, -w - thick, -w));
  return walls;
}

}  // namespace

PathCase channelCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "channel";
  const double w = random.number(4, 8), gap = random.number(0.3, 1);
  const double length = random.number(15, 30);
  c.part = boxAt(0, length, -w, w, -w, w);
  c.neighbours = {channelWalls(w + gap, length, 5)};
  c.goal = shifted({2, 0, 0});
  c.start = shifted({3 * length, random.number(-20, 20), random.number(-20, 20)});
  c.clearance = 0.5 * gap;
  return inFrames(c, random);
}

PathCase cornerCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "corner";
  const double a = random.number(4, 6), w = a + random.number(1, 2), l = random.number(30, 40);
  c.part = boxAt(-a, a, -a, a, -a, a);
  // A tunnel along x from 0 to l, then along y; open at the end of the second arm.
  TriMesh walls;
  for (const double side : {-1.0, 1.0})
    append(walls, side < 0 ? boxAt(-w - 5, l + w + 5, -w - 5, l, -w - 5, -w)
                           : boxAt(-w - 5, l + w + 5, -w - 5, l, w, w + 5));
  append(walls, boxAt(-w - 5, -w, -w - 5, w + 5, -w, w));
  append(walls, boxAt(-w, l + w + 5, -w - 5, -w, -w, w));
  append(walls, boxAt(-w, l - w, w, w + 5, -w, w));
  append(walls, boxAt(l - w - 5, l - w, w + 5, l, -w, w));
  append(walls, boxAt(l + w, l + w + 5, -w, l, -w, w));
  c.neighbours = {walls};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({l, l + 5 * a, 0});
  c.clearance = 0.4;
  return inFrames(c, random);
}

PathCase slotCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "slot";
  const double length = random.number(12, 18), thin = random.number(2, 3);
  const double gap = random.number(0.8, 1.5);
  c.part = boxAt(-length, length, -thin, thin, -thin, thin);
  // A plate at x = 0 with a slot along z; behind it a room in which the bar lies across.
  const double half = 2 * length, s = thin + gap, t = length + gap;
  TriMesh plate;
  append(plate, boxAt(-2, 2, s, half, -half, half));
  append(plate, boxAt(-2, 2, -half, -s, -half, half));
  append(plate, boxAt(-2, 2, -s, s, t, half));
  append(plate, boxAt(-2, 2, -s, s, -half, -t));
  // Closed far behind the plate, its mouth at the plate.
  const TriMesh room = transformed(channelWalls(half, 4 * length, 3),
                                   placement({0, 0, 1}, 0, {-4 * length - 2, 0, 0}));
  c.neighbours = {plate, room};
  Pose across;
  across.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ());
  across.translation = {-2 * length, 0, 0};
  c.goal = across;
  Pose out = across;
  out.translation = {3 * length, 0, 0};
  c.start = out;
  c.clearance = 0.3;
  c.needsTurn = true;
  return inFrames(c, random);
}

PathCase hookCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "hook";
  const double r = random.number(1.5, 2.5), gap = random.number(0.8, 1.2), s = r + gap;
  // A C of boxes round a bar along z that ends in plates; its mouth is narrower than the bar is
  // high.
  TriMesh hook;
  append(hook, boxAt(-s - 3, s + 3, -s - 3, -s, -3, 3));
  append(hook, boxAt(-s - 3, -s, -s, s + 3, -3, 3));
  append(hook, boxAt(s, s + 3, -s, s + 3, -3, 3));
  append(hook, boxAt(-s, -0.4 * r, s, s + 3, -3, 3));
  c.part = hook;
  // The bar is flat: the mouth lets it pass only edgewise.
  const double flat = 0.5 * (s + 0.4 * r) - 0.5 * gap;
  TriMesh bar;
  append(bar, boxAt(-r, r, -flat, flat, -25, 25));
  append(bar, boxAt(-15, 15, -15, 15, 25, 30));
  append(bar, boxAt(-15, 15, -15, 15, -30, -25));
  c.neighbours = {bar};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({0, -60, 0});
  c.clearance = 0.2;
  return inFrames(c, random);
}

PathCase elbowCase(unsigned seed) {
  PathCase c = cornerCase(seed);
  Random random(seed + 77);
  c.name = "elbow";
  const double a = random.number(1.5, 2), w = 7, l = 36;
  TriMesh part;
  append(part, boxAt(-a, 12, -a, a, -a, a));
  append(part, boxAt(-a, a, a, 12, -a, a));
  c.part = part;
  TriMesh walls;
  append(walls, boxAt(-25, l + w + 5, -w - 5, l, -w - 5, -w));
  append(walls, boxAt(-25, l + w + 5, -w - 5, l, w, w + 5));
  append(walls, boxAt(-25, -20, -w - 5, 12 + w, -w, w));
  append(walls, boxAt(-20, l + w + 5, -w - 5, -w, -w, w));
  append(walls, boxAt(-20, l - w, 12, 17, -w, w));
  append(walls, boxAt(l - w - 5, l - w, 17, l, -w, w));
  append(walls, boxAt(l + w, l + w + 5, -w, l, -w, w));
  c.neighbours = {walls};
  c.goal = shifted({-14, -3, 0});
  c.start = shifted({l, l + 40, 0});
  c.clearance = 0.3;
  return inFrames(c, random);
}

PathCase sealedCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "sealed";
  const double a = random.number(3, 5), w = a + random.number(2, 6);
  c.part = boxAt(-a, a, -a, a, -a, a);
  TriMesh walls = transformed(channelWalls(w, 2 * w, 3), placement({0, 0, 1}, 0, {-w, 0, 0}));
  append(walls, boxAt(w, w + 3, -w - 3, w + 3, -w - 3, w + 3));
  c.neighbours = {walls};
  c.start = shifted({60, 0, 0});
  c.clearance = 0.1;
  c.possible = false;
  return inFrames(c, random);
}

PathCase narrowCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "narrow";
  const double w = random.number(4, 8), length = 20;
  c.part = boxAt(0, length, -w, w, -w, w);
  TriMesh walls = channelWalls(w + 1, length + 10, 5);
  const double m = w - 0.5;
  append(walls, boxAt(length + 5, length + 10, m, w + 1.5, -w - 1.5, w + 1.5));
  append(walls, boxAt(length + 5, length + 10, -w - 1.5, -m, -w - 1.5, w + 1.5));
  c.neighbours = {walls};
  c.goal = shifted({1, 0, 0});
  c.start = shifted({4 * length, 0, 0});
  c.clearance = 0.2;
  c.possible = false;
  return inFrames(c, random);
}

PathCase touchingCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "touching";
  const double a = random.number(3, 8), b = random.number(3, 8);
  c.part = boxAt(-a, a, -b, b, 0, 10);
  c.neighbours = {boxAt(-40, 40, -40, 40, -5, 0), boxAt(-40, 40, b, b + 5, 0, 20),
                  boxAt(-40, 40, -b - 5, -b, 0, 20)};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({random.number(-20, 20), 0, random.number(50, 80)});
  c.clearance = 1;
  c.release = 25;
  return inFrames(c, random);
}

PathCase scatteredCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "scattered";
  const Vector3d size = Vector3d::Constant(2) + (random.point(2).cwiseAbs());
  c.part = makeBox(-size, size);
  c.start = shifted({-45, 0, 0});
  c.goal = shifted({45, 0, 0});
  const int count = 8 + static_cast<int>(seed % 17);
  for (int i = 0; i < count; ++i) {
    const Vector3d half = Vector3d::Constant(1) + random.point(9).cwiseAbs();
    const Eigen::Isometry3d where =
        placement(random.point(1) + Vector3d(0, 0, 1e-3), random.number(0, 180), random.point(25));
    const TriMesh box = transformed(makeBox(-half, half), where);
    c.neighbours.push_back(box);
  }
  c.clearance = random.number(0, 1);
  return inFrames(c, random);
}

PathCase pathCase(unsigned number) {
  using Make = PathCase (*)(unsigned seed);
  constexpr unsigned kCount = 9;
  constexpr std::array<Make, kCount> kKinds{channelCase, cornerCase,   slotCase,
                                            hookCase,    elbowCase,    sealedCase,
                                            narrowCase,  touchingCase, scatteredCase};
  return kKinds[number % kCount](number / kCount + 1);
}

}  // namespace swept::test
