// Surfaces swept by the curves along which smooth faces of a moving body touch the envelope. They
// are compared with formulas. At their points, the normal of the face must also be perpendicular to
// the velocity. The velocities come from a separate implementation of the motion (motions.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "solid/sweep/borders.h"
#include "solid/sweep/motions.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

// Returns the point of contact on a curve x(v) of a face, v in [from, to], found by bisection.
std::optional<Vector3d> bisected(const Carrier& face, const std::function<Vector3d(double)>& x,
                                 double from, double to, const TestMotion& motion, double s) {
  const auto speed = [&](double v) {
    return motion.turned(face.normal(x(v)), s).dot(motion.velocity(x(v), s));
  };
  // Finds the first interval in which the sign changes.
  constexpr int kScan = 16;
  const double step = (to - from) / kScan, first = speed(from);
  int k = 1;
  while (k <= kScan && first * speed(from + k * step) >= 0) ++k;
  if (k > kScan) return std::nullopt;
  to = from + k * step;
  from = to - step;
  for (int i = 0; i < 48; ++i) {
    const double middle = (from + to) / 2;
    (speed(middle) * first > 0 ? from : to) = middle;
  }
  return x(from);
}

// Points of contact on a face with parameters (w, v), for w in a range and v between two values.
struct Truth {
  std::vector<Contact> contacts;
  std::vector<Vector3d> normals;  // outward, in the world
};
Truth contactsOf(const Carrier& face, const std::function<Vector3d(double, double)>& x, Range w,
                 Range v, const TestMotion& motion, Range during = {}) {
  Truth truth;
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 13; ++j) {
      const double s = during.at(j / 13.0), rail = w.at(i / 16.0);
      const auto found = bisected(
          face, [&](double at) { return x(rail, at); }, v.from, v.to, motion, s);
      if (!found) continue;
      truth.contacts.push_back({motion.at(*found, s), s});
      truth.normals.push_back(motion.turned(face.normal(*found), s));
    }
  }
  return truth;
}

void expectGrazes(const SweptSurface& made, const Truth& truth, double bound = 2 * kOnCarrier) {
  ASSERT_GE(truth.contacts.size(), 60U);
  ASSERT_TRUE(made.carrier) << degeneracyText(made.why) << " at " << made.where.transpose();
  for (std::size_t i = 0; i < truth.contacts.size(); ++i) {
    const Vector3d& p = truth.contacts[i].point;
    ASSERT_LE(std::abs(made.carrier->distance(p)), bound) << truth.contacts[i].s;
    ASSERT_GT(made.carrier->normal(p).dot(truth.normals[i]), 1 - 1e-6);
  }
  if (made.carrier->kind == CarrierKind::Sheet) {
    EXPECT_LE(made.carrier->sheet->poles().size(), 400U);
  }
}

Vector3d onCylinder(const Carrier& c, double h, double angle) {
  const Vector3d x = anyOrthogonal(c.axis), y = c.axis.cross(x);
  return c.point + h * c.axis + c.radius * (std::cos(angle) * x + std::sin(angle) * y);
}

// Returns two angles, half a turn apart, between which the contact of a cylinder must lie.
Range aroundContact(const Carrier& face, const TestMotion& motion, double shift = 0) {
  const Vector3d v = motion.velocity(face.point, 0.5);
  const Vector3d body = Vector3d(motion.turned(Vector3d::UnitX(), 0.5).dot(v),
                                 motion.turned(Vector3d::UnitY(), 0.5).dot(v),
                                 motion.turned(Vector3d::UnitZ(), 0.5).dot(v));
  const Vector3d x = anyOrthogonal(face.axis), y = face.axis.cross(x);
  const double along = std::atan2(body.dot(y), body.dot(x)) + shift;
  return {along, along + M_PI};
}

TEST(Graze, APlaneInAGeneralMotion) {
  const TestMotion motion = generalMotion();
  const Carrier face = carrierOf(CarrierKind::Plane, {0, 0, 15}, {0.1, 0.2, 1});
  // The contact lines run along the projection of the rotation axis onto the plane. The curves run
  // across them.
  const Vector3d turn = motion.from.rotation.conjugate() * Vector3d(1, 2, 3).normalized();
  const Vector3d x = (turn - turn.dot(face.axis) * face.axis).normalized(), y = face.axis.cross(x);
  const auto at = [&](double w, double v) { return Vector3d(face.point + w * x + v * y); };
  const Truth truth = contactsOf(face, at, {-20, 20}, {-400, 400}, motion);
  expectGrazes(grazeOf(face, truth.contacts, motion.path()), truth);
}

TEST(Graze, APlaneThatTurnsAboutAnAxisInItOrAcrossIt) {
  const TestMotion turn = screwMotion({0, 0, 0}, {0, 0, 1}, 1.0, 0);
  // Parallel to the axis, 7 mm from it: the envelope is a cylinder.
  const Carrier beside = carrierOf(CarrierKind::Plane, {7, 3, 0}, {1, 0, 0});
  const auto flat = [&](double w, double v) { return Vector3d(7, v, w); };
  const Truth truth = contactsOf(beside, flat, {-5, 5}, {-50, 51}, turn);
  const auto made = grazeOf(beside, truth.contacts, turn.path());
  expectGrazes(made, truth);
  ASSERT_EQ(made.carrier->kind, CarrierKind::Cylinder);
  EXPECT_NEAR(made.carrier->radius, 7, 1e-9);
  // Inclined to the axis: the envelope is a cone. All contacts lie on one side of its apex.
  const Carrier slanted = carrierOf(CarrierKind::Plane, {7, 0, 0}, {1, 0, 1});
  const auto incline = [&](double w, double v) { return Vector3d(7 - w, v, w); };
  const Truth cone = contactsOf(slanted, incline, {-5, 5}, {-50, 51}, turn);
  const auto round = grazeOf(slanted, cone.contacts, turn.path());
  expectGrazes(round, cone);
  EXPECT_EQ(round.carrier->kind, CarrierKind::Cone);
  // Contacts on both sides of the apex, which is at z = 7, are refused.
  const Truth both = contactsOf(slanted, incline, {-5, 20}, {-50, 51}, turn);
  EXPECT_EQ(grazeOf(slanted, both.contacts, turn.path()).why, Degeneracy::Singular);
}

TEST(Graze, ACylinderAlongAStraightWayGivesPlanes) {
  const TestMotion move = lineMotion({10, 20, 30});
  const Carrier face = carrierOf(CarrierKind::Cylinder, {1, 2, 3}, {0, 0, 1}, 5);
  const auto at = [&](double w, double v) { return onCylinder(face, w, v); };
  const Truth truth = contactsOf(face, at, {0, 20}, aroundContact(face, move), move);
  const auto made = grazeOf(face, truth.contacts, move.path());
  expectGrazes(made, truth);
  EXPECT_EQ(made.carrier->kind, CarrierKind::Plane);
  // Moved along its own axis, the face only slides along itself.
  const TestMotion slide = lineMotion({0, 0, 30});
  EXPECT_EQ(grazeOf(face, truth.contacts, slide.path()).why, Degeneracy::AlongItself);
}

TEST(Graze, ACylinderInGeneralMotions) {
  for (const double angle : {0.3, 0.7, 1.2}) {
    const TestMotion motion = generalMotion(angle);
    Carrier face = carrierOf(CarrierKind::Cylinder, {0, 0, 0}, {1, 2, -1}, 8);
    const auto at = [&](double w, double v) { return onCylinder(face, w, v); };
    for (const double side : {0.0, M_PI}) {
      const Truth truth = contactsOf(face, at, {0, 15}, aroundContact(face, motion, side), motion);
      expectGrazes(grazeOf(face, truth.contacts, motion.path()), truth);
    }
    face.reversed = true;
    const Truth bore = contactsOf(face, at, {0, 15}, aroundContact(face, motion), motion);
    expectGrazes(grazeOf(face, bore.contacts, motion.path()), bore);
  }
}

TEST(Graze, ACylinderThatTurnsAboutAnAxisBesideIt) {
  const TestMotion turn = screwMotion({20, 0, 0}, {0, 0, 1}, 1.0, 0);
  const Carrier face = carrierOf(CarrierKind::Cylinder, {0, 0, 0}, {0, 0, 1}, 5);
  const auto at = [&](double w, double v) { return onCylinder(face, w, v); };
  const Truth truth = contactsOf(face, at, {0, 20}, aroundContact(face, turn), turn);
  const auto made = grazeOf(face, truth.contacts, turn.path());
  expectGrazes(made, truth);
  ASSERT_EQ(made.carrier->kind, CarrierKind::Cylinder);
  EXPECT_TRUE(std::abs(made.carrier->radius - 25) < 1e-7 ||
              std::abs(made.carrier->radius - 15) < 1e-7);
  // Turned about its own axis, the cylinder slides along itself.
  const TestMotion own = screwMotion({0, 0, 0}, {0, 0, 1}, 1.0, 0);
  EXPECT_EQ(grazeOf(face, truth.contacts, own.path()).why, Degeneracy::AlongItself);
  // Turned about an axis across its own, it makes a surface of revolution.
  const TestMotion across = screwMotion({20, 3, 0}, {0.3, 1, 0.1}, 0.8, 0);
  const Truth ring = contactsOf(face, at, {1, 9}, aroundContact(face, across), across);
  const auto turned = grazeOf(face, ring.contacts, across.path(), 1e-3);
  expectGrazes(turned, ring, 2e-3);
  EXPECT_EQ(turned.carrier->kind, CarrierKind::Revolution);
}

TEST(Graze, ASphereIsATubeAboutThePathOfItsCentre) {
  const Carrier ball = carrierOf(CarrierKind::Sphere, {4, 0, 0}, {0, 0, 1}, 5);
  const auto onBall = [&](double w, double v) {
    return Vector3d(ball.point + 5 * Vector3d(std::cos(v) * std::cos(w), std::cos(v) * std::sin(w),
                                              std::sin(v)));
  };
  const auto kindOf = [&](const TestMotion& motion, Range w) {
    const Truth truth = contactsOf(ball, onBall, w, {-1.5, 1.5}, motion);
    const auto made = grazeOf(ball, truth.contacts, motion.path());
    expectGrazes(made, truth);
    return made.carrier ? made.carrier->kind : CarrierKind::Facet;
  };
  EXPECT_EQ(kindOf(lineMotion({3, 4, 40}), {0, 3}), CarrierKind::Cylinder);
  EXPECT_EQ(kindOf(screwMotion({20, 0, 0}, {1, 1, 0}, 1, 0), {0, 2}), CarrierKind::Torus);
  EXPECT_EQ(kindOf(screwMotion({20, 0, 0}, {1, 1, 0}, 1, 9), {0, 2}), CarrierKind::Sheet);
  TestMotion motion = generalMotion();
  motion.to.translation = Vector3d(3, 10, 45);
  EXPECT_EQ(kindOf(motion, {0, 2}), CarrierKind::Sheet);
}

TEST(Graze, ConesAndTori) {
  const TestMotion motion = generalMotion(0.5);
  Carrier cone = carrierOf(CarrierKind::Cone, {0, 0, 0}, {1, 2, -1}, 8);
  cone.setHalfAngle(0.3);
  const Vector3d x = anyOrthogonal(cone.axis), y = cone.axis.cross(x);
  const auto onCone = [&](double h, double v) {
    return Vector3d(cone.point + h * cone.axis +
                    (8 + h * std::tan(0.3)) * (std::cos(v) * x + std::sin(v) * y));
  };
  const Truth truth = contactsOf(cone, onCone, {0, 12}, aroundContact(cone, motion), motion);
  expectGrazes(grazeOf(cone, truth.contacts, motion.path()), truth);

  const Carrier torus = carrierOf(CarrierKind::Torus, {0, 0, 0}, {0, 0, 1}, 20, 6);
  const auto onTorus = [&](double w, double v) {  // rails are circles of the tube
    const Vector3d out(std::cos(w), std::sin(w), 0);
    return Vector3d((20 + 6 * std::cos(v)) * out + 6 * std::sin(v) * Vector3d::UnitZ());
  };
  const Truth ring = contactsOf(torus, onTorus, {0.2, 1.1}, {-1.2, 1.9}, motion);
  expectGrazes(grazeOf(torus, ring.contacts, motion.path()), ring);
}

TEST(Graze, ExtrusionsAndSheets) {
  std::vector<Profile::Node> nodes;
  for (int i = 0; i <= 16; ++i) {  // an arc of an ellipse, to be smooth
    const double a = 0.2 + 2.4 * i / 16;
    nodes.push_back(
        {{20 * std::cos(a), 12 * std::sin(a)}, {-20 * std::sin(a), 12 * std::cos(a)}, a});
  }
  Carrier face = carrierOf(CarrierKind::Extrusion, {0, 0, 0}, {0, 0, 1});
  face.xdir = Vector3d::UnitX();
  face.profile = std::make_shared<const Profile>(nodes, false, 0.0);
  TestMotion motion = generalMotion(0.4);
  motion.to.translation = Vector3d(50, 10, 20);
  const auto at = [&](double w, double v) {
    const Eigen::Vector2d q = face.profile->at(v);
    return Vector3d(q.x(), q.y(), w);
  };
  const Truth truth = contactsOf(face, at, {0, 10}, {0.3, 2.5}, motion);
  // The profile's curvature jumps between its cubics, so the bound cannot be as small.
  expectGrazes(grazeOf(face, truth.contacts, motion.path(), 1e-4), truth, 2e-4);
}

TEST(Graze, WhereThereIsNoContact) {
  const TestMotion motion = generalMotion(0.3);
  const Carrier face = carrierOf(CarrierKind::Cylinder, {0, 0, 0}, {1, 2, -1}, 8);
  EXPECT_EQ(grazeOf(face, {}, motion.path()).why, Degeneracy::NoContact);
  // A plane that moves along its normal touches nothing.
  const TestMotion up = lineMotion({0, 0, 9});
  const Carrier plane = carrierOf(CarrierKind::Plane, {0, 0, 0}, {0, 0, 1});
  const std::vector<Contact> some{{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 0.5}};
  EXPECT_EQ(grazeOf(plane, some, up.path()).why, Degeneracy::NoContact);
  const TestMotion flat = lineMotion({5, 0, 0});
  EXPECT_EQ(grazeOf(plane, some, flat.path()).why, Degeneracy::AlongItself);
}

}  // namespace
}  // namespace swept::step
