// Swept solids built from their exact faces, written as STEP and checked by the kernel. The
// expected volume is that of the body plus the integral of what its front sweeps.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "solid/sweep/borders.h"
#include "solid/sweep/hand_built.h"
#include "solid/sweep/motions.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

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

// Returns the integral by Gaussian quadrature with three points, on each of many intervals.
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

// Tests the solid of a box that moves along its diagonal and turns so little that front faces stay
// front faces: three caps at each end, and six swept edges.
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
    const auto curve = pathOf(corner(i), path, kWhole);
    ASSERT_TRUE(curve);
    paths[i] = solid.edge(at[0][i], at[1][i], *curve);
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
  // The axis is far away, so that all points move along the diagonal of the box.
  expectBoxSound(screwMotion({200, -200, 10}, {1, 1, 0.2}, 0.25, 20), {20, 14, 9});
}

TEST(SweptSolid, ABoxAlongALineAndOnACircle) {
  expectBoxSound(lineMotion({40, 35, 50}), {20, 14, 9});
  // The axis is perpendicular to the direction of the line. It is so far away that the middle of
  // the box starts in this direction.
  const Vector3d travel(40, 35, 50),
      axis = Vector3d(35, -40, 5).cross(travel).cross(travel).normalized();
  expectBoxSound(screwMotion(-travel.cross(axis) / 0.25, axis, 0.25, 0), {20, 14, 9});
}

// A rod that moves across and along its axis: a disc and half of its side at each end, two arcs
// that sweep and two contact curves.
class Rod {
 public:
  explicit Rod(const TestMotion& motion) : motion_(motion), path_(motion.path()) {}

  void expectSoundSolid() {
    followContacts();
    if (testing::Test::HasFatalFailure()) return;
    makeGrazes();
    if (testing::Test::HasFatalFailure()) return;
    makeEnds();
    makeRings();
    if (testing::Test::HasFatalFailure()) return;
    expectSound(solid_, volume(), 8);
  }

 private:
  static constexpr double kRadius = 8, kHeight = 30;
  using Pair = std::array<std::int32_t, 2>;

  static Vector3d radial(double a) { return {std::cos(a), std::sin(a), 0}; }
  static int sideOf(int k) { return k == 0 ? -1 : 1; }
  Vector3d turned(const Vector3d& d, double s) const { return motion_.turned(d, s); }
  Vector3d bodyVelocity(const Vector3d& x, double s) const {
    const Vector3d v = motion_.velocity(x, s);
    return {turned(Vector3d::UnitX(), s).dot(v), turned(Vector3d::UnitY(), s).dot(v),
            turned(Vector3d::UnitZ(), s).dot(v)};
  }
  // Returns the direction across the axis in which the middle of the rod moves.
  Vector3d direction(double s) const {
    const Vector3d v = bodyVelocity({0, 0, kHeight / 2}, s);
    return Vector3d(v.x(), v.y(), 0).normalized();
  }
  // Returns the angle of contact on one side (+1, -1) of this direction.
  double contactAngle(double h, double s, int side) const {
    const Vector3d v = bodyVelocity({0, 0, h}, s);
    return std::atan2(v.y(), v.x()) + side * M_PI / 2;
  }
  Vector3d contactPoint(double h, double s, int side) const {
    return motion_.at(kRadius * radial(contactAngle(h, s, side)) + Vector3d(0, 0, h), s);
  }
  static Curve ring(int top) {
    Curve circle = circleCurve({0, 0, top * kHeight}, {0, 0, 1}, kRadius);
    circle.xdir = Vector3d::UnitX();
    return circle;
  }

  void followContacts() {
    for (int top = 0; top < 2; ++top) {
      for (int k = 0; k < 2; ++k) {
        const double start = contactAngle(top * kHeight, 0.5, sideOf(k));
        const auto curve =
            contactAlong(ring(top), {start - 1.5, start + 1.5}, radial, path_, kWhole, start);
        ASSERT_TRUE(curve);
        for (int s = 0; s < 2; ++s) {
          const Vector3d end = curve->at(s * curve->last);
          at_[top][k][s] = solid_.vertex(end);
          EXPECT_LE((contactPoint(top * kHeight, s, sideOf(k)) - end).norm(), 1e-7);
        }
        along_[top][k] = solid_.edge(at_[top][k][0], at_[top][k][1], *curve);
      }
    }
  }

  // Adds the grazing surfaces and their contact curves at both ends.
  void makeGrazes() {
    for (int k = 0; k < 2; ++k) {
      std::vector<Contact> contacts;
      for (int i = 0; i <= 80; ++i) {
        const double s = (i % 9) / 8.0;
        contacts.push_back({contactPoint(kHeight * (i / 9) / 8, s, sideOf(k)), s});
      }
      const auto made = grazeOf(rod_, contacts, path_);
      ASSERT_TRUE(made.carrier) << degeneracyText(made.why);
      for (int s = 0; s < 2; ++s) {
        std::vector<Vector3d> line;
        for (int i = 0; i <= 8; ++i) line.push_back(contactPoint(kHeight * i / 8, s, sideOf(k)));
        const auto contact = contactAt(rod_, line, path_, s);
        ASSERT_TRUE(contact);
        lines_[k][s] = solid_.edge(at_[0][k][s], at_[1][k][s], *contact);
      }
      solid_.face(*made.carrier, {lines_[k][0], along_[1][k], lines_[k][1], along_[0][k]},
                  turned(radial(contactAngle(kHeight / 2, 0.5, sideOf(k))), 0.5));
    }
  }

  // Adds an arc from side -1 over the front to side +1, or from side +1 over the rear to side -1.
  std::int32_t arc(int top, int s, bool front) {
    const std::int32_t from = at_[top][front ? 0 : 1][s], to = at_[top][front ? 1 : 0][s];
    Curve curve = posed(ring(top), path_.at(s));
    curve.xdir = (solid_.model().vertices[from].point - curve.start).normalized();
    const Vector3d d = solid_.model().vertices[to].point - curve.start;
    curve.last = std::atan2(d.dot(curve.axis.cross(curve.xdir)), d.dot(curve.xdir));
    if (curve.last < 0) curve.last += 2 * M_PI;
    return solid_.edge(from, to, curve);
  }

  // Adds the discs and halves of the side that remain of the rod at both ends. arcs_[top][s]
  // borders the surface that the arc of this disc sweeps.
  void makeEnds() {
    const Vector3d up = Vector3d::UnitZ();
    arcs_ = {Pair{arc(0, 0, true), arc(0, 1, true)}, Pair{arc(1, 0, false), arc(1, 1, false)}};
    const std::int32_t rearArc = arc(0, 0, false), frontArc = arc(1, 1, true);
    solid_.face(carrierOf(CarrierKind::Plane, motion_.at({0, 0, 0}, 0), turned(-up, 0)),
                {rearArc, arcs_[0][0]}, turned(-up, 0));
    solid_.face(carrierOf(CarrierKind::Plane, motion_.at({0, 0, kHeight}, 1), turned(up, 1)),
                {arcs_[1][1], frontArc}, turned(up, 1));
    Carrier rear = posed(rod_, path_.at(0)), front = posed(rod_, path_.at(1));
    rear.xdir = turned(direction(0), 0);  // the seam lies opposite to the face
    front.xdir = turned(-direction(1), 1);
    solid_.face(rear, {rearArc, lines_[0][0], arcs_[1][0], lines_[1][0]}, turned(-direction(0), 0));
    solid_.face(front, {arcs_[0][1], lines_[1][1], frontArc, lines_[0][1]},
                turned(direction(1), 1));
  }

  void makeRings() {
    for (int top = 0; top < 2; ++top) {
      const double middle = contactAngle(top * kHeight, 0.5, 1) + sideOf(top) * M_PI / 2;
      const auto swept = sweptBy(ring(top), {middle - 1.8, middle + 1.8}, path_, kWhole);
      ASSERT_TRUE(swept.carrier) << degeneracyText(swept.why);
      const Vector3d out = radial(middle) + 0.3 * sideOf(top) * Vector3d::UnitZ();
      solid_.face(*swept.carrier,
                  {arcs_[top][0], along_[top][1 - top], arcs_[top][1], along_[top][top]},
                  turned(out, 0.5));
    }
  }

  double volume() const {
    const auto through = [&](double s) {
      const auto side = [&](double h) {
        return 2 * kRadius * bodyVelocity({0, 0, h}, s).head<2>().norm();
      };
      return M_PI * kRadius * kRadius * bodyVelocity({0, 0, kHeight}, s).z() +
             integral(side, 0, kHeight);
    };
    return M_PI * kRadius * kRadius * kHeight + integral(through, 0, 1);
  }

  const TestMotion& motion_;
  const StepPath path_;
  const Carrier rod_ = carrierOf(CarrierKind::Cylinder, {0, 0, 0}, {0, 0, 1}, kRadius);
  HandBuilt solid_;
  std::array<std::array<Pair, 2>, 2> at_{};         // [top][side][s]
  std::array<Pair, 2> along_{}, lines_{}, arcs_{};  // [top][side], [side][s], [top][s]
};

TEST(SweptSolid, ARodInAGeneralMotion) {
  TestMotion motion = generalMotion(0.4);
  motion.to.translation = motion.from.translation + motion.from.rotation * Vector3d(45, 10, 40);
  Rod(motion).expectSoundSolid();
}

TEST(SweptSolid, ARodAlongALineAndOnACircle) {
  const TestMotion line = lineMotion({45, 10, 40});
  Rod(line).expectSoundSolid();
  const TestMotion turn = screwMotion({150, 20, -150}, {0.1, 1, 0.2}, 0.3, 0);
  Rod(turn).expectSoundSolid();
}

}  // namespace
}  // namespace swept::step
