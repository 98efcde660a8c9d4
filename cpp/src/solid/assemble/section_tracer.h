// Follows the curve in which two faces intersect, and makes an edge of it.
// In:      points near the curve; events: points at which curves of intersection may end.
// Out:     exact points; a kernel edge with its curves in the parameters of both faces.
// Units:   mm.
// Cost:    some microseconds for each point.
// Method:  Newton's method moves the parameters of both faces until their points agree. From there,
//          steps along the tangent lead to the border of a face, or to a point where both faces are
//          tangent. No step reaches such a point; the curve ends at the event that lies there.
// Source:  N. Patrikalakis, T. Maekawa, Shape interrogation for computer aided design and
//          manufacturing, 2002, chapter 5.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <optional>
#include <utility>
#include <vector>

#include "solid/assemble/meshed_faces.h"

namespace swept::step {

/// Sine of the angle between two faces. Where it is smaller, they are taken as tangent.
constexpr double kTangentFaces = 2e-4;

/// mm: points nearer than this are one.
constexpr double kSamePoint = 1e-6;

/// Returns how far (mm) a point where a curve passes through a face may be from the exact one.
/// `sine`: of the angle between both.
double uncertaintyOf(double sine);

struct PointOnBoth {
  Eigen::Vector3d at, tangent;  ///< `tangent` is as long as `sine`
  std::array<Eigen::Vector2d, 2> on;
  std::array<Jet, 2> jets;
  double sine = 0;  ///< of the angle between both faces
};

/// A curve that lies on two faces by construction. Points near it may belong to it, if the faces do
/// not cross at a larger angle there.
struct SharedCurve {
  Handle(Geom_Curve) curve;
  double near;     ///< mm
  double maxSine;  ///< of the angle between the faces
};

/// Returns the parameter of a curve and the parameters of a face at which the curve passes through
/// the face, near those given.
std::optional<std::pair<double, Eigen::Vector2d>> throughFace(const MeshedFaces& faces, int face,
                                                              const BRepAdaptor_Curve& curve,
                                                              double t, Eigen::Vector2d on);

class SectionTracer {
 public:
  /// `shared`: curves of both faces that are no intersections. `folds`: curves at which one of the
  /// faces turns back (0: a, 1: b). Curves of intersection have cusps there, and end.
  SectionTracer(const MeshedFaces& faces, int a, int b, std::vector<SharedCurve> shared,
                std::vector<std::pair<int, TopoDS_Edge>> folds,
                const std::vector<Eigen::Vector3d>& events)
      : faces_(faces),
        of_{a, b},
        shared_(std::move(shared)),
        folds_(std::move(folds)),
        commonVertices_(faces.commonVertices(a, b)),
        events_(events) {}

  /// Exact points along a curve.
  struct Run {
    std::vector<PointOnBoth> points;
    /// Whether the curve ends there, at a border. Otherwise it goes on.
    bool isFirstExact = false, isLastExact = false;
    double length() const;
  };
  /// Returns the runs of all chains, longest first. Chains are interrupted where the faces are
  /// tangent.
  std::vector<Run> runsOf(const std::vector<std::vector<Piercing>>& chains) const;

  /// Extends a run at its ends that are not exact, and makes an edge of it. Null if it is too
  /// short.
  TopoDS_Edge edgeAlong(Run run);
  /// Makes the edge through a point of both faces. Null if there is none within both.
  TopoDS_Edge edgeThrough(const Eigen::Vector3d& p, const std::array<Eigen::Vector2d, 2>& on);

  /// The points at which edges end at borders.
  const std::vector<Eigen::Vector3d>& ends() const { return ends_; }

 private:
  using Plane = std::pair<Eigen::Vector3d, Eigen::Vector3d>;  // a point and the normal

  Jet jet(int side, const Eigen::Vector2d& on) const { return faces_.jet(of_[side], on); }
  PointOnBoth pointAt(const Eigen::Vector3d& p, const std::array<Eigen::Vector2d, 2>& on) const;
  std::optional<PointOnBoth> onBoth(std::array<Eigen::Vector2d, 2> on,
                                    const std::optional<Plane>& plane = std::nullopt) const;
  std::optional<PointOnBoth> atBorder(int side, const TopoDS_Edge& edge,
                                      const Eigen::Vector3d& near,
                                      const Eigen::Vector2d& onOther) const;
  PointOnBoth snappedToEvent(const PointOnBoth& point, double sine) const;
  std::optional<Eigen::Vector2d> footOn(int side, Eigen::Vector2d on,
                                        const Eigen::Vector3d& p) const;
  bool isShared(const PointOnBoth& point) const;
  bool isInBoth(const PointOnBoth& point) const;
  bool isCommonVertex(const Eigen::Vector3d& p) const;
  std::optional<PointOnBoth> next(const PointOnBoth& from, double h) const;
  void extend(std::vector<PointOnBoth>& points);
  bool endAtBorder(const PointOnBoth& outside, std::vector<PointOnBoth>& points);
  void endAtEvent(std::vector<PointOnBoth>& points) const;
  std::optional<PointOnBoth> between(const PointOnBoth& a, const PointOnBoth& b) const;
  TopoDS_Edge edgeOf(std::vector<PointOnBoth> points) const;

  const MeshedFaces& faces_;
  const std::array<int, 2> of_;
  const std::vector<SharedCurve> shared_;
  const std::vector<std::pair<int, TopoDS_Edge>> folds_;  // of which face
  const std::vector<Eigen::Vector3d> commonVertices_;
  const std::vector<Eigen::Vector3d>& events_;
  std::vector<Eigen::Vector3d> ends_;
};

}  // namespace swept::step
