// Makes the faces of which the envelope of a moving body may consist: faces of the body at poses,
// and the surfaces that its edges and contact curves sweep.
// In:      the body; a trajectory whose steps are straight moves without turning, or turns about a
//          fixed axis. For a body that is one solid, any trajectory.
// Out:     kernel faces in world coordinates. They intersect, and parts of them lie inside the
//          swept volume; assemble.h finds the parts on its surface.
// Units:   mm.
// Cost:    O(faces of the body) per motion step.
// Method:  A step moves all points with velocities that the motion itself does not change. So the
//          contact curves (contact_edges.h) stay the same curves of the body during the step. The
//          envelope of a step consists of the parts of the body that move inward at its start, the
//          parts that move outward at its end, and what the edges between the two kinds of parts
//          sweep: planes, cylinders, extrusions, revolutions. For other steps see turning_faces.h.
// Source:  Abdel-Malek, Blackmore and Joy 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Message_ProgressRange.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "solid/assemble/body_shape.h"
#include "solid/assemble/divide_faces.h"
#include "solid/assemble/sides.h"
#include "swept/types.h"

namespace swept::step {

/// A condition for a point of a face, given by its parameters, to lie on the envelope. Negative
/// where it cannot.
using Condition = std::function<double(const Eigen::Vector2d&)>;

struct SweptFace {
  static constexpr int kAlone = -1;
  TopoDS_Face face;
  /// Faces of one group are faces of the body at one pose. They do not intersect each other.
  int group = kAlone;
  /// Borders of other faces that lie on this one.
  std::vector<TopoDS_Edge> inner = {};
  /// The face is divided where the sign of one of these changes.
  std::vector<Condition> conditions = {};
  /// Negative where another face has the same points; null if there is none. (Faces that continue
  /// each other overlap.)
  Condition own = {};

  /// Returns whether a point meets all conditions, or misses them by at most `slack`.
  bool isPossible(const Eigen::Vector2d& on, double slack) const {
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const Condition& condition) { return condition(on) >= -slack; });
  }
};

struct SweptFaces {
  std::vector<SweptFace> faces;
  /// The curves in which the faces intersect, if they are known.
  std::optional<std::vector<SweptSection>> sections;
  /// mm: points of sections that are nearer than this are one vertex. Bodies from files are exact
  /// to about this length.
  double near = 1e-4;
  /// Whether the kernel's general fuse may find other sections. It takes minutes for faces that are
  /// splines.
  bool canFuse = true;
};

/// Returns whether the motion and the body are of these kinds, and the body has few enough faces
/// (faces times steps up to 2,000; if it moves and turns at the same time, up to 500 in ten steps,
/// or up to 250 in more).
bool canSweepFaces(const BodyShape& body, const Trajectory& trajectory);

/// `sides`: of the same sweep. Empty if the kernel fails.
SweptFaces sweptFaces(const BodyShape& body, const Trajectory& trajectory, const Sides& sides,
                      const Message_ProgressRange& progress);

}  // namespace swept::step
