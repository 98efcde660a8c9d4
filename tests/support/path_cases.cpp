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

// Moves the whole case to a random frame, and describes the part in another one, so that nothing is
// parallel to an axis.
PathCase inFrames(PathCase c, Random& random) {
  const Eigen::Isometry3d world = randomFrame(random);
  Eigen::Isometry3d partFrame = randomFrame(random);
  partFrame.translation() *= 0.1;
  c.part = transformed(c.part, partFrame);
  for (TriMesh& mesh : c.neighbours) mesh = transformed(mesh, world);
  for (Pose* pose : {&c.start, &c.goal}) {
    const Eigen::Isometry3d back = partFrame.inverse();
    Pose local;
    local.rotation = (pose->rotation * Eigen::Quaterniond(back.linear())).normalized();
    local.translation = pose->rotation * back.translation() + pose->translation;
    *pose = after(world, local);
  }
  return c;
}

// Returns walls of thickness `thick` around a space from x = 0 to `length`, open towards +x. Half
// width of the space: w.
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
  // The room is closed far behind the plate, and open at the plate.
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
  // A C-shaped hook of boxes around a bar, which lies along z and ends in plates.
  TriMesh hook;
  append(hook, boxAt(-s - 3, s + 3, -s - 3, -s, -3, 3));
  append(hook, boxAt(-s - 3, -s, -s, s + 3, -3, 3));
  append(hook, boxAt(s, s + 3, -s, s + 3, -3, 3));
  append(hook, boxAt(-s, -0.4 * r, s, s + 3, -3, 3));
  c.part = hook;
  // The bar is flat: only its narrow side passes the opening of the hook.
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

PathCase keyCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "key";
  // The foot of a T-shaped key lies under the lips of a groove that is open at one end. The stem of
  // the key stands in the groove.
  const double w = random.number(2, 3), gap = random.number(0.5, 1), foot = random.number(5, 7);
  append(c.part, boxAt(-8, 8, -w, w, 4, 20));
  append(c.part, boxAt(-8, 8, -foot, foot, 0, 4));
  const double s = w + gap, f = foot + gap;
  TriMesh groove = boxAt(-30, 30, -f - 5, f + 5, -gap - 5, -gap);
  append(groove, boxAt(-30, 30, f, f + 5, -gap, 4 + gap));
  append(groove, boxAt(-30, 30, -f - 5, -f, -gap, 4 + gap));
  append(groove, boxAt(-30, 30, s, f + 5, 4 + gap, 9));
  append(groove, boxAt(-30, 30, -f - 5, -s, 4 + gap, 9));
  append(groove, boxAt(-35, -30, -f - 5, f + 5, -gap - 5, 9));
  c.neighbours = {groove};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({random.number(-10, 10), random.number(-10, 10), 60});
  c.clearance = 0.4 * gap;
  return inFrames(c, random);
}

PathCase ringCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "ring";
  const double r = random.number(1.5, 2), hole = r + random.number(1.5, 2.5);
  c.part = makeSquareRing(hole + 3, hole, -2, 2);
  // A rod that stands on a plate, bent to the side, then up again.
  TriMesh rod = boxAt(-20, 20, -20, 20, -10, -5);
  append(rod, boxAt(-r, r, -r, r, -5, 15));
  append(rod, boxAt(-r, 15, -r, r, 15, 15 + 2 * r));
  append(rod, boxAt(15, 15 + 2 * r, -r, r, 15, 35));
  c.neighbours = {rod};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({random.number(-10, 10), random.number(-10, 10), 60});
  c.clearance = 0.3;
  c.needsTurn = true;
  return inFrames(c, random);
}

PathCase handleCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "handle";
  // A U with long legs through a window in a wall: first one leg, then the bridge, then the other.
  const double a = random.number(1, 1.5), half = random.number(7, 9), leg = random.number(14, 18);
  append(c.part, boxAt(-a, a, -half, half, -a, a));
  append(c.part, boxAt(-a, leg, half - 2 * a, half, -a, a));
  append(c.part, boxAt(-a, leg, -half, -half + 2 * a, -a, a));
  const double w = random.number(5, 6);
  TriMesh wall = boxAt(-2, 2, w, 40, -40, 40);
  append(wall, boxAt(-2, 2, -40, -w, -40, 40));
  append(wall, boxAt(-2, 2, -w, w, w, 40));
  append(wall, boxAt(-2, 2, -w, w, -40, -w));
  const TriMesh room = transformed(channelWalls(40, 60, 3), placement({0, 0, 1}, 0, {-62, 0, 0}));
  c.neighbours = {wall, room};
  c.goal = shifted({-35, 0, 0});
  c.start = shifted({40, 0, 0});
  c.clearance = 0.3;
  c.needsTurn = true;
  return inFrames(c, random);
}

PathCase keyholeCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "keyhole";
  // A pin with a head behind a plate; only the wide end of the hole lets the head pass.
  const double r = random.number(2, 3), head = r + random.number(1.5, 3);
  const double gap = random.number(0.4, 0.8);
  append(c.part, boxAt(-8, 8, -r, r, -r, r));
  append(c.part, boxAt(-11, -8, -head, head, -head, head));
  const double s = r + gap, w = head + gap, top = 20;
  TriMesh plate = boxAt(-3, 3, w, 40, -40, 40);
  append(plate, boxAt(-3, 3, -40, -w, -40, 40));
  append(plate, boxAt(-3, 3, -w, -s, -40, top - w));
  append(plate, boxAt(-3, 3, s, w, -40, top - w));
  append(plate, boxAt(-3, 3, -s, s, -40, -s));
  append(plate, boxAt(-3, 3, -w, w, top + w, 40));
  const TriMesh room = transformed(channelWalls(40, 30, 3), placement({0, 0, 1}, 0, {-33, 0, 0}));
  c.neighbours = {plate, room};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({50, 0, random.number(-20, 20)});
  c.clearance = 0.4 * gap;
  return inFrames(c, random);
}

PathCase hooksCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "hooks";
  // Two open hooks that hang in each other; a plate holds the second one.
  const double r = random.number(1.5, 2), inner = random.number(5, 6), mouth = 2 * r + 1.5;
  const auto hook = [&] {
    TriMesh mesh = boxAt(-inner - 2 * r, inner + 2 * r, -r, r, -inner - 2 * r, -inner);
    append(mesh, boxAt(-inner - 2 * r, -inner, -r, r, -inner, inner + 2 * r));
    append(mesh, boxAt(inner, inner + 2 * r, -r, r, -inner, inner + 2 * r));
    append(mesh, boxAt(-inner, inner - mouth, -r, r, inner, inner + 2 * r));
    return mesh;
  };
  c.part = hook();
  TriMesh other = transformed(hook(), placement({0, 0, 1}, 90, {0, 0, -inner - r}));
  append(other, boxAt(-20, 20, -20, 20, -2 * inner - 6 * r - 5, -2 * inner - 3 * r));
  c.neighbours = {other};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({random.number(-10, 10), random.number(-10, 10), 50});
  c.clearance = 0.2;
  return inFrames(c, random);
}

PathCase nutCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "nut";
  // A round ring on a round shaft of three pieces, with bends of 25 to 40 degrees.
  const double r = random.number(1.5, 2.5), hole = r + random.number(1, 1.5);
  c.part = makeTorus(hole + 1.5, 1.5, 32, 12);
  const double bend = random.number(25, 40);
  TriMesh shaft = makeCylinder(8, -16, -8, 24);
  append(shaft, makeCylinder(r, -8, 10, 24));
  const Eigen::Isometry3d second = placement({1, 0, 0}, bend, {0, 0, 10});
  append(shaft, transformed(makeCylinder(r, -1, 18, 24), second));
  append(shaft, transformed(makeCylinder(r, -1, 18, 24),
                            second * placement({0, 1, 0}, -bend, {0, 0, 18})));
  c.neighbours = {shaft};
  c.goal = shifted({0, 0, -2});
  c.start = shifted({random.number(-20, 20), random.number(-20, 20), 80});
  c.clearance = 0.2;
  c.needsTurn = true;
  return inFrames(c, random);
}

PathCase drawerCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "drawer";
  // A drawer with a stop at its back: it has to be lifted at the end of its movement.
  const double w = random.number(8, 12), gap = random.number(0.5, 1), stop = random.number(2, 3);
  const double length = 24, height = 8;
  append(c.part, boxAt(0, length, -w, w, 0, height));
  append(c.part, boxAt(0, 3, -w, w, -stop, 0));
  const double s = w + gap, low = stop + gap, high = height + stop + 2 * gap;
  TriMesh cabinet = boxAt(-10, length + 4, -s - 4, s + 4, -low - 4, -low);
  append(cabinet, boxAt(-10, length + 4, -s - 4, s + 4, high, high + 4));
  append(cabinet, boxAt(-10, length + 4, s, s + 4, -low, high));
  append(cabinet, boxAt(-10, length + 4, -s - 4, -s, -low, high));
  append(cabinet, boxAt(-14, -10, -s - 4, s + 4, -low - 4, high + 4));
  append(cabinet, boxAt(length, length + 4, -s, s, -low, -gap));
  c.neighbours = {cabinet};
  c.goal = shifted({-2, 0, 0});
  c.start = shifted({3 * length, 0, random.number(-10, 10)});
  c.clearance = 0.4 * gap;
  return inFrames(c, random);
}

PathCase engineCase(unsigned seed) {
  Random random(seed);
  PathCase c;
  c.name = "engine";
  // A tall block in a bay under a beam: it moves along under the beam, and tilts to get past it.
  const double a = random.number(8, 10), h = random.number(10, 12), gap = random.number(1.5, 2.5);
  append(c.part, boxAt(-a, a, -a, a, -h, h));
  append(c.part, boxAt(a, a + 8, -3, 3, -h, -h + 6));
  const double x0 = -a - gap, x1 = a + 8 + 2 * gap + 14, y = a + gap, top = h + gap;
  TriMesh bay = boxAt(x0 - 4, x1 + 4, -y - 4, y + 4, -h - gap - 4, -h - gap);
  append(bay, boxAt(x0 - 4, x0, -y - 4, y + 4, -h - gap, top));
  append(bay, boxAt(x1, x1 + 4, -y - 4, y + 4, -h - gap, top));
  append(bay, boxAt(x0, x1, y, y + 4, -h - gap, top));
  append(bay, boxAt(x0, x1, -y - 4, -y, -h - gap, top));
  append(bay, boxAt(x0 + 3, x0 + 9, -y - 4, y + 4, top, top + 5));
  c.neighbours = {bay};
  c.goal = shifted({0, 0, 0});
  c.start = shifted({random.number(-10, 10), random.number(-10, 10), 80});
  c.clearance = 0.5;
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

PathCase hardPathCase(unsigned number) {
  using Make = PathCase (*)(unsigned seed);
  constexpr unsigned kCount = 8;
  constexpr std::array<Make, kCount> kKinds{keyCase,   ringCase, handleCase, keyholeCase,
                                            hooksCase, nutCase,  drawerCase, engineCase};
  return kKinds[number % kCount](number / kCount + 1);
}

}  // namespace swept::test
