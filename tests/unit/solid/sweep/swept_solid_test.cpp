// Swept solids put together by hand from their true faces, written as STEP and judged by the
// kernel. The volume is that of the body plus what flows through its front, by quadrature.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "solid/sweep/borders.h"
#include "solid/sweep/hand_built.h"
#include "solid/sweep/motions.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

constexpr Range kWhole{0, 1};

void expectSound(HandBuilt& solid, double volume, int faces) {
  ASSERT_TRUE(solid.isClosed());
  EXPECT_LE(solid.largestGap(), 2e-7);
  const test::JudgedSolid judged = solid.judge(true);
  EXPECT_TRUE(judged.valid);
  EXPECT_EQ(judged.solids, 1);
  EXPECT_EQ(judged.faces, faces);
  EXPECT_LE(judged.edgeTolerance, 1e-5);
  EXPECT_LE(judged.vertexTolerance, 1e-5);
  EXPECT_NEAR(judged.volume / volume, 1, 1e-7);
  EXPECT_GE(judged.blockError, 0);
  EXPECT_LE(judged.blockError, 1e-6);
  EXPECT_TRUE(judged.faults.empty()) << (judged.details.empty() ? "" : judged.details.front());
  const test::JudgedSolid made = solid.judgeMade();
  EXPECT_EQ(solid.failed(), 0U);
  EXPECT_TRUE(made.valid);
  EXPECT_LE(made.edgeTolerance, 1e-5);
  EXPECT_NEAR(made.volume / volume, 1, 1e-7);
}

// Three points of Gauss on each of many intervals.
double integral(const std::function<double(double)>& f, double from, double to) {
  constexpr int kPanels = 40;
  const double h = (to - from) / kPanels, off = h / 2 * std::sqrt(0.6);
  double sum = 0;
  for (int i = 0; i < kPanels; ++i) {
    const double m = from + (i + 0.5) * h;
    sum += h / 18 * (5 * f(m - off) + 8 * f(m) + 5 * f(m + off));
  }
  return sum;
}

// A box that moves so far along its diagonal, and turns so little, that its faces stay front or
// back faces: three caps at each end and six swept edges.
void expectBoxSound(const TestMotion& motion, const Vector3d& size) {
  const StepPath path = motion.path();
  const auto corner = [&](int i) {
    return Vector3d((i & 1) != 0 ? size.x() : 0, (i & 2) != 0 ? size.y() : 0,
                    (i & 4) != 0 ? size.z() : 0);
  };
  constexpr std::array<int, 6> kRing{1, 3, 2, 6, 4, 5};
  HandBuilt solid;
  std::array<std::array<std::int32_t, 8>, 2> at{};
  for (int s = 0; s < 2; ++s) {
    for (int i = 0; i < 8; ++i) {
      if (i == (s == 0 ? 7 : 0)) continue;
      at[s][i] = solid.vertex(motion.at(corner(i), s));
    }
  }
  std::array<std::int32_t, 8> paths{};
  for (const int i : kRing) {
    const auto way = pathOf(corner(i), path, kWhole);
    ASSERT_TRUE(way);
    paths[i] = solid.edge(at[0][i], at[1][i], *way);
  }
  std::array<std::array<std::array<std::int32_t, 8>, 8>, 2> between{};
  const auto join = [&](int s, int a, int b) {
    between[s][a][b] = between[s][b][a] = solid.line(at[s][a], at[s][b]);
  };
  for (int s = 0; s < 2; ++s) {
    for (std::size_t k = 0; k < 6; ++k) join(s, kRing[k], kRing[(k + 1) % 6]);
    for (const int i : s == 0 ? std::array{1, 2, 4} : std::array{3, 5, 6})
      join(s, s == 0 ? 0 : 7, i);
  }
  double flux = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int s = 0; s < 2; ++s) {
      const int a = 1 << ((axis + 1) % 3), b = 1 << ((axis + 2) % 3), low = s == 0 ? 0 : 1 << axis;
      const std::array<int, 4> ring{low, low | a, low | a | b, low | b};
      const Vector3d out = motion.turned((s == 0 ? -1 : 1) * Vector3d::Unit(axis), s);
      std::vector<std::int32_t> edges;
      for (std::size_t k = 0; k < 4; ++k) edges.push_back(between[s][ring[k]][ring[(k + 1) % 4]]);
      solid.face(carrierOf(CarrierKind::Plane, motion.at(corner(low), s), out), edges, out);
    }
    const double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
    Vector3d centre = size / 2;
    centre[axis] = size[axis];
    flux += integral(
        [&](double s) {
          return area * motion.turned(Vector3d::Unit(axis), s).dot(motion.velocity(centre, s));
        },
        0, 1);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const int a = kRing[k], b = kRing[(k + 1) % 6];
    const Curve edge = lineThrough(corner(a), corner(b));
    const auto swept = sweptBy(edge, {0, edge.last}, path, kWhole);
    ASSERT_TRUE(swept.carrier) << degeneracyText(swept.why);
    const Vector3d out = motion.at((corner(a) + corner(b)) / 2, 0.5) - motion.at(size / 2, 0.5);
    solid.face(*swept.carrier, {between[0][a][b], paths[b], between[1][a][b], paths[a]}, out);
  }
  expectSound(solid, size.prod() + flux, 12);
}

TEST(SweptSolid, ABoxInAGeneralMotion) {
  for (const double angle : {0.1, 0.3, 0.5}) {
    TestMotion motion;
    motion.from = pose({3, -2, 5}, {1, 0, 2}, 0.4);
    motion.to.rotation =
        Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()) * motion.from.rotation;
    motion.to.translation = motion.from.translation + motion.from.rotation * Vector3d(50, 55, 60);
    expectBoxSound(motion, {30, 20, 12});
  }
}

TEST(SweptSolid, ABoxAlongAScrew) {
  // About an axis far away, so that all points move along the diagonal of the box.
  expectBoxSound(screwMotion({200, -200, 10}, {1, 1, 0.2}, 0.25, 20), {20, 14, 9});
}

TEST(SweptSolid, ABoxAlongALineAndOnACircle) {
  expectBoxSound(lineMotion({40, 35, 50}), {20, 14, 9});
  // About an axis across this way and so far off that the middle of the box begins along it.
  const Vector3d way(40, 35, 50), axis = Vector3d(35, -40, 5).cross(way).cross(way).normalized();
  expectBoxSound(screwMotion(-way.cross(axis) / 0.25, axis, 0.25, 0), {20, 14, 9});
}

// A rod that moves across and along its axis.
void expectRodSound(const TestMotion& motion) {
  constexpr double kRadius = 8, kHeight = 30;
  const StepPath path = motion.path();
  const Carrier rod = carrierOf(CarrierKind::Cylinder, {0, 0, 0}, {0, 0, 1}, kRadius);
  const auto bodyVelocity = [&](const Vector3d& x, double s) {
    const Vector3d v = motion.velocity(x, s);
    return Vector3d(motion.turned(Vector3d::UnitX(), s).dot(v),
                    motion.turned(Vector3d::UnitY(), s).dot(v),
                    motion.turned(Vector3d::UnitZ(), s).dot(v));
  };
  const auto radial = [](double a) { return Vector3d(std::cos(a), std::sin(a), 0); };
  // The angle of contact on one side (+1, -1) of the way.
  const auto contactAngle = [&](double h, double s, int side) {
    const Vector3d v = bodyVelocity({0, 0, h}, s);
    return std::atan2(v.y(), v.x()) + side * M_PI / 2;
  };
  const auto ring = [&](int top) {
    Curve circle = circleCurve({0, 0, top * kHeight}, {0, 0, 1}, kRadius);
    circle.xdir = Vector3d::UnitX();
    return circle;
  };
  const auto sideOf = [](int k) { return k == 0 ? -1 : 1; };
  HandBuilt solid;
  // By [top][side][s].
  std::array<std::array<std::array<std::int32_t, 2>, 2>, 2> at{};
  std::array<std::array<std::int32_t, 2>, 2> along{};  // [top][side]
  for (int top = 0; top < 2; ++top) {
    for (int k = 0; k < 2; ++k) {
      const double start = contactAngle(top * kHeight, 0.5, sideOf(k));
      const auto curve =
          contactAlong(ring(top), {start - 1.5, start + 1.5}, radial, path, kWhole, start);
      ASSERT_TRUE(curve);
      for (int s = 0; s < 2; ++s) {
        at[top][k][s] = solid.vertex(curve->at(s * curve->last));
        const Vector3d truth =
            motion.at(kRadius * radial(contactAngle(top * kHeight, s, sideOf(k))) +
                          Vector3d(0, 0, top * kHeight),
                      s);
        EXPECT_LE((truth - curve->at(s * curve->last)).norm(), 1e-7);
      }
      along[top][k] = solid.edge(at[top][k][0], at[top][k][1], *curve);
    }
  }
  // Arcs from side -1 over the front to side +1, and on over the rear.
  const auto arc = [&](int top, int s, bool front) {
    Curve curve = posed(ring(top), path.at(s));
    const Vector3d a = solid.model().vertices[at[top][front ? 0 : 1][s]].point;
    const Vector3d b = solid.model().vertices[at[top][front ? 1 : 0][s]].point;
    curve.xdir = (a - curve.start).normalized();
    const Vector3d d = b - curve.start;
    curve.last = std::atan2(d.dot(curve.axis.cross(curve.xdir)), d.dot(curve.xdir));
    if (curve.last < 0) curve.last += 2 * M_PI;
    return solid.edge(at[top][front ? 0 : 1][s], at[top][front ? 1 : 0][s], curve);
  };
  const std::int32_t bottomRear0 = arc(0, 0, false), bottomFront0 = arc(0, 0, true),
                     topRear0 = arc(1, 0, false), topRear1 = arc(1, 1, false),
                     topFront1 = arc(1, 1, true), bottomFront1 = arc(0, 1, true);
  // Grazing surfaces and their contact curves at both ends.
  std::array<std::array<std::int32_t, 2>, 2> lines{};  // [side][s]
  std::array<Carrier, 2> graze;
  for (int k = 0; k < 2; ++k) {
    std::vector<Contact> contacts;
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; j <= 8; ++j) {
        const double h = kHeight * i / 8, s = j / 8.0;
        const Vector3d x = kRadius * radial(contactAngle(h, s, sideOf(k))) + Vector3d(0, 0, h);
        contacts.push_back({motion.at(x, s), s});
      }
    }
    const auto made = grazeOf(rod, contacts, path);
    ASSERT_TRUE(made.carrier) << degeneracyText(made.why);
    graze[k] = *made.carrier;
    for (int s = 0; s < 2; ++s) {
      std::vector<Vector3d> line;
      for (int i = 0; i <= 8; ++i) {
        const double h = kHeight * i / 8;
        line.push_back(
            motion.at(kRadius * radial(contactAngle(h, s, sideOf(k))) + Vector3d(0, 0, h), s));
      }
      const auto contact = contactAt(rod, line, path, s);
      ASSERT_TRUE(contact);
      lines[k][s] = solid.edge(at[0][k][s], at[1][k][s], *contact);
    }
  }
  const auto turned = [&](const Vector3d& d, double s) { return motion.turned(d, s); };
  const Vector3d up = Vector3d::UnitZ();
  solid.face(carrierOf(CarrierKind::Plane, motion.at({0, 0, 0}, 0), turned(-up, 0)),
             {bottomRear0, bottomFront0}, turned(-up, 0));
  solid.face(carrierOf(CarrierKind::Plane, motion.at({0, 0, kHeight}, 1), turned(up, 1)),
             {topRear1, topFront1}, turned(up, 1));
  const auto way = [&](double s) {
    const Vector3d v = bodyVelocity({0, 0, kHeight / 2}, s);
    return Vector3d(v.x(), v.y(), 0).normalized();
  };
  Carrier rear = posed(rod, path.at(0)), front = posed(rod, path.at(1));
  rear.xdir = turned(way(0), 0);  // the seam lies opposite to the face
  front.xdir = turned(-way(1), 1);
  solid.face(rear, {bottomRear0, lines[0][0], topRear0, lines[1][0]}, turned(-way(0), 0));
  solid.face(front, {bottomFront1, lines[1][1], topFront1, lines[0][1]}, turned(way(1), 1));
  for (int k = 0; k < 2; ++k) {
    solid.face(graze[k], {lines[k][0], along[1][k], lines[k][1], along[0][k]},
               turned(radial(contactAngle(kHeight / 2, 0.5, sideOf(k))), 0.5));
  }
  for (int top = 0; top < 2; ++top) {
    const double middle = contactAngle(top * kHeight, 0.5, 1) + (top == 1 ? 1 : -1) * M_PI / 2;
    const auto swept = sweptBy(ring(top), {middle - 1.8, middle + 1.8}, path, kWhole);
    ASSERT_TRUE(swept.carrier) << degeneracyText(swept.why);
    const Vector3d out = turned(radial(middle), 0.5) + (top == 1 ? 0.3 : -0.3) * turned(up, 0.5);
    solid.face(*swept.carrier,
               top == 1 ? std::vector{topRear0, along[1][0], topRear1, along[1][1]}
                        : std::vector{bottomFront0, along[0][1], bottomFront1, along[0][0]},
               out);
  }
  const double flux = integral(
      [&](double s) {
        const double top = M_PI * kRadius * kRadius * bodyVelocity({0, 0, kHeight}, s).z();
        return top + integral(
                         [&](double h) {
                           return 2 * kRadius * bodyVelocity({0, 0, h}, s).head<2>().norm();
                         },
                         0, kHeight);
      },
      0, 1);
  expectSound(solid, M_PI * kRadius * kRadius * kHeight + flux, 8);
}

TEST(SweptSolid, ARodInAGeneralMotion) {
  TestMotion motion = generalMotion(0.4);
  motion.to.translation = motion.from.translation + motion.from.rotation * Vector3d(45, 10, 40);
  expectRodSound(motion);
}

TEST(SweptSolid, ARodAlongALineAndOnACircle) {
  expectRodSound(lineMotion({45, 10, 40}));
  expectRodSound(screwMotion({150, 20, -150}, {0.1, 1, 0.2}, 0.3, 0));
}

}  // namespace
}  // namespace swept::step
