// The points in which a cylinder, a torus or a sphere of a moving body touches its envelope. Each
// circle of such a pipe (pipe.h) has two of them. So there are two curves.
// Units:   mm, rad; s is the fraction of the motion step. Positions x: see pipe.h.
// Cost:    O(1) for a point.
// Method:  Let p and q be the two speeds of pipe.h. The normal at a point of contact has the
//          direction (q, -p) or the opposite one. Both speeds are functions of x: linear ones on a
//          cylinder, trigonometric ones on a torus. At a complex zero of p + i q, the curve bends:
//          it runs around the circle within a range of positions that is as wide as the zero is far
//          from the real positions. There, asinh((x - zero) / width) is a better measure than x. So
//          positions on the curve are sums of x and of such terms. At some moments a zero is real.
//          Then a whole circle touches the envelope (critical_circle.h). Shortly before and after,
//          curves are divided in parts: those inside the window of this circle, and those beside
//          it.
//          Contact curves of a sphere are great circles orthogonal to the velocity of its centre.
//          Angles are measured around this velocity, so that circles do not bend. Where it turns
//          far, the step is divided into ranges of times with different axes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "solid/assemble/body_geometry.h"
#include "solid/assemble/critical_circle.h"
#include "solid/assemble/pipe.h"

namespace swept::step {

class PipeContacts {
 public:
  /// `index`: of the surface. `within`: one of timesOf(). A cylinder without critical circles has
  /// no curves here, but in contact_curves.h.
  PipeContacts(const BodyGeometry& body, int index, const StepPath& path, Range within);

  /// Returns the ranges of times that need different axes, in order: only spheres have several.
  static std::vector<Range> timesOf(const BodySurface& surface, const StepPath& path);

  std::size_t count() const { return curves_.size(); }
  const Range& times(int curve) const { return curves_[curve].s; }
  /// Returns the positions (mm) between which the curve can be on a face. They are the same all
  /// the time.
  Range extent(int curve) const;
  /// Returns whether the curve is a part of a longer one: one half of a curve that can be on faces
  /// all around an axis, or a part inside or beside a window.
  bool isPart(int curve) const { return curves_[curve].isPart; }
  /// Returns whether the curve ends where another one begins.
  bool doesContinue(int curve, int next) const;
  /// Returns whether the curve begins (or ends) at a window.
  bool isAtWindow(int curve, bool isEnd) const { return endOf(curve, isEnd).isMoving(); }
  /// Returns x at a point minus x at the start or the end of a curve.
  double offsetFromEnd(int curve, bool isEnd, const Eigen::Vector3d& p, double s) const;
  /// Returns a point in coordinates of the body; not finite where there is none.
  Eigen::Vector3d at(int curve, double w, double s) const;
  double positionAt(int curve, const Eigen::Vector3d& p, double s) const;
  /// Returns the point of a curve at the x of p; not finite if it belongs to another part.
  Eigen::Vector3d atPositionOf(int curve, const Eigen::Vector3d& p, double s) const;

  const Pipe& pipe() const { return pipe_; }
  const std::vector<CriticalCircle>& criticals() const { return criticals_; }
  static constexpr int kNone = -1;
  /// Returns the critical circle in whose window the curve is, or kNone.
  int criticalOf(int curve) const { return curves_[curve].critical; }
  CriticalCircle::Quarter quarterOf(int curve) const;

 private:
  // An end of a curve. Those at windows move.
  struct End {
    double x, drift = 0, start = 0;
    // Equal where a curve ends and another one begins.
    int joint = kNone;
    bool isMoving() const { return joint != kNone && joint < kFirstHalf; }
    double at(double s) const { return x + drift * (s - start); }
    // Returns the positions in a range of times.
    Range during(Range s) const { return Range{at(s.from), at(s.from)}.with(at(s.to)); }
  };
  static constexpr int kFirstHalf = 1 << 20;  // joints of halves

  struct Curve {
    double sign;  // of the two curves
    Range s;
    End from, to;
    int critical = kNone;
    bool isPart = false;
    // Returns the positions at which it can be on a face.
    Range on(double time) const { return {from.at(time), to.at(time)}; }
  };
  struct Bend {
    double at, width;
  };
  struct Window {
    int critical;
    double turn;  // whole turns that bring it to the faces
    double at;
  };
  class Measure;

  const End& endOf(int curve, bool isEnd) const {
    return isEnd ? curves_[curve].to : curves_[curve].from;
  }
  // Returns the point of contact at a position.
  Eigen::Vector3d onPipe(double sign, double x, double s) const;
  // Returns the positions at which curves with this sign can be on a face, with 2 pi if all around;
  // nothing if they are never on one.
  std::optional<Range> positionsOnFaces(const BodyGeometry& body, int index, double sign) const;
  // Returns the bends of both curves. Angles are within pi of the middle.
  std::array<Bend, 2> bendsAt(double middle, double s) const;
  // Returns how far a bend is beyond the ends of a part. It grows smoothly from zero.
  double beyond(Range on, const Bend& bend) const;
  // Returns those outside of the windows in the times of the curve.
  std::vector<Bend> bendsBeside(const Curve& curve, double s) const;
  // Appends curves in these times without windows.
  void appendWhole(double sign, Range on, Range within);
  // Returns the windows at a time, in order.
  std::vector<Window> windowsIn(Range on, double s) const;
  // Returns where the curve with this sign enters or leaves a window.
  End endAt(const Window& window, bool isEnd, double sign) const;
  // Appends the part of a curve inside a window, before and after the critical moment.
  void appendInside(const Window& window, double sign, Range within);
  // Appends the parts of curves inside and beside the windows in these times.
  void appendParts(Range on, Range within);
  // Appends a curve in all times in which it is regular.
  void appendRegular(const Curve& curve, Range within);
  bool isRegular(const Curve& curve, double s) const;
  // Returns the shortest time in which positions change much.
  double quickestChange(const Curve& curve, Range s) const;
  bool isAllAround(Range on) const;
  // Returns the range of both.
  Range joined(Range a, Range b) const;
  // Returns the critical circles whose windows contain a time.
  std::vector<int> windowsAt(double s) const;

  Pipe pipe_;
  const StepPath& path_;
  Range within_;
  double unit_ = 1;  // of x: 1 rad on a torus, as much of its length on a cylinder
  std::vector<CriticalCircle> criticals_;
  std::vector<Curve> curves_;
  int joints_ = kFirstHalf;
};

}  // namespace swept::step
