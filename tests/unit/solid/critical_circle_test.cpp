// Circles of cylinders and tori that touch the envelope as a whole, and the surfaces near them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/critical_circle.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/contact_curves.h"
#include "solid/sweep/contact.h"
#include "unit/solid/test_poses.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Case {
  BodyGeometry body;
  StepPath path;
  int surface() const {
    int i = 0;
    while (body.surfaces[i].isPlane()) ++i;
    return i;
  }
};

// A rod that nearly moves along its axis, and a ring; both turn.
std::vector<Case> cases() {
  const Vector3d axis = Vector3d(1, 0, 1).normalized(), other = Vector3d(1, -2, 1).normalized();
  return {{BodyGeometry(BRepPrimAPI_MakeCylinder(2, 10).Shape()),
           StepPath(poseAt({0, -0.565, -15}, -0.2, axis), poseAt({0, 0.565, 15}, 0.2, axis),
                    Interpolation::Linear)},
          {BodyGeometry(BRepPrimAPI_MakeTorus(6, 2).Shape()),
           StepPath(poseAt({0, 0, 0}, 0, other), poseAt({9, 3, 1}, 0.4, other),
                    Interpolation::Linear)}};
}

std::vector<CriticalCircle> circlesOf(const Case& of) {
  const Pipe pipe(of.body.surfaces[of.surface()]);
  return CriticalCircle::find(pipe, of.path, pipe.isCylinder() ? Range{0, 10} : Range{0, 2 * M_PI},
                              {0, 1}, !pipe.isCylinder());
}

TEST(CriticalCircle, ItsCentreMovesAlongTheCentreLine) {
  for (const Case& of : cases()) {
    const Pipe pipe(of.body.surfaces[of.surface()]);
    const std::vector<CriticalCircle> circles = circlesOf(of);
    ASSERT_GE(circles.size(), 1u);
    for (const CriticalCircle& circle : circles) {
      const Moment moment(of.path, circle.time());
      EXPECT_NEAR(pipe.speeds(circle.position(), moment).norm(), 0, 1e-9);
      const double near = circle.position() + 0.5 * circle.positions(circle.time()).length();
      EXPECT_GT(pipe.speeds(near, moment).norm(), 1e-3);
    }
  }
}

TEST(CriticalCircle, TheSurfaceNearItConsistsOfPointsOfContact) {
  for (const Case& of : cases()) {
    const BodySurface& surface = of.body.surfaces[of.surface()];
    const Pipe pipe(surface);
    for (const CriticalCircle& circle : circlesOf(of)) {
      for (const int half : {0, 1}) {
        for (const bool isAfter : {false, true}) {
          const Range psis = circle.directions(half), taus = CriticalCircle::reach(isAfter);
          for (const double a : {0.0, 0.2, 0.5, 0.9}) {
            for (const double b : {0.0, 0.4, 1.0}) {
              const Vector2d on(psis.at(a), taus.at(b));
              const auto [x, s] = circle.at(half, on.x(), on.y());
              ASSERT_TRUE(std::isfinite(x));
              const Vector3d p = pipe.at(x, {std::cos(on.x()), std::sin(on.x())});
              const Moment moment(of.path, s);
              EXPECT_NEAR(surface.distanceTo(p), 0, 1e-12);
              EXPECT_NEAR(surface.normalAt(p).dot(moment.velocityAt(p)), 0, 1e-9);
              EXPECT_NEAR((circle.parametersOf(half, x, on.x(), s) - on).norm(), 0, 1e-9);
            }
          }
          // In the middle of a half, what touches after the critical moment is beyond zero.
          const double middle = psis.at(0.5);
          EXPECT_EQ(circle.at(half, middle, taus.at(0.5)).s > circle.time(), isAfter);
        }
      }
    }
  }
}

TEST(CriticalCircle, TheContactCurvesAtItsMomentAreSmooth) {
  for (const Case& of : cases()) {
    const Pipe pipe(of.body.surfaces[of.surface()]);
    for (const CriticalCircle& circle : circlesOf(of)) {
      const Moment moment(of.path, circle.time());
      const Range x = circle.positions(circle.time());
      Vector2d before = circle.directionAtMoment(x.from);
      constexpr int kSteps = 2000;  // some very near to the circle
      for (int i = 0; i <= kSteps; ++i) {
        const double at = x.at(static_cast<double>(i) / kSteps);
        const Vector2d direction = circle.directionAtMoment(at);
        EXPECT_NEAR(direction.dot(pipe.speeds(at, moment)), 0, 1e-9);
        EXPECT_LT((direction - before).norm(), 0.01);
        before = direction;
      }
    }
  }
}

// At all times, each point of contact on the faces belongs to one curve. Where a curve continues
// into another one, both have the same point.
TEST(ContactCurves, CoverAllTimesNearCriticalCircles) {
  for (const Case& of : cases()) {
    const Pipe pipe(of.body.surfaces[of.surface()]);
    const ContactCurves curves(of.body, of.surface(), of.path);
    const Range x = pipe.isCylinder() ? Range{0, 10} : Range{0, 2 * M_PI};
    int inFans = 0;
    for (double s = 0.0113; s < 1; s += 0.0217) {
      const Moment moment(of.path, s);
      for (double part = 0.003; part < 1; part += 0.0171) {
        const Vector2d speeds = pipe.speeds(x.at(part), moment);
        for (const double sign : {1.0, -1.0}) {
          const Vector2d direction = sign * Vector2d(speeds.y(), -speeds.x()).normalized();
          const Vector3d p = pipe.at(x.at(part), direction);
          const int curve = curves.curveOf(p, s);
          ASSERT_NE(curve, ContactCurves::kNoCurve) << s << " " << part;
          const double w = curves.positionAt(curve, p, s);
          EXPECT_TRUE(curves.doesOwn(curve, w)) << s << " " << part;
          EXPECT_NEAR((curves.at(curve, w, s) - p).norm(), 0, 1e-6) << s << " " << part;
          const auto fan = curves.fanOf(curve);
          if (!fan) continue;
          const ContactCurves::Touch touch = curves.at(*fan, curves.parametersOf(*fan, p, s));
          EXPECT_NEAR((touch.p - p).norm(), 0, 1e-9);
          EXPECT_NEAR(touch.s, s, 1e-9);
          EXPECT_TRUE(curves.doesOwn(*fan, touch));
          ++inFans;
        }
      }
    }
    EXPECT_GE(inFans, 10);
    int joints = 0;
    for (int curve = 0; curve < curves.count(); ++curve) {
      for (int next = 0; next < curves.count(); ++next) {
        if (!curves.doesContinue(curve, next)) continue;
        const Range one = curves.times(curve), other = curves.times(next);
        const Range both{std::max(one.from, other.from), std::min(one.to, other.to)};
        for (const double part : {0.1, 0.6}) {
          const double s = both.at(part);
          const Vector3d end = curves.at(curve, curves.extent(curve).to, s),
                         start = curves.at(next, curves.extent(next).from, s);
          EXPECT_NEAR((end - start).norm(), 0, 1e-8);
        }
        ++joints;
      }
    }
    EXPECT_GE(joints, 4);
  }
}

}  // namespace
}  // namespace swept::step
