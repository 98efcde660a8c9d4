// Where the faces of turning_faces.h may lie on the envelope, as far as the motion at one moment
// tells.
// Units:   mm; s is the fraction of a step.
// Cost:    O(1) for a point.
// Method:  A point of the body can only be on the envelope at the start of a step if it moves
//          inward then, and at the end if it moves outward. A point of an edge must move outward of
//          one face and inward of the other. A point of contact must lie within a face; and seen
//          from the body, its place in space must come from outside and leave to outside.
// Source:  Blackmore, Leu and Wang, The sweep-envelope differential equation algorithm, CAD 29
//          (1997); Adsul, Machchhar and Sohoni, CAGD 31 (2014).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <functional>
#include <memory>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/body_geometry.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/contact_curves.h"
#include "solid/assemble/swept_faces.h"
#include "swept/types.h"

namespace swept::step {

/// A body and the steps of its motion.
struct MovingBody {
  MovingBody(const TopoDS_Shape& shape, const Trajectory& trajectory);
  MovingBody(const MovingBody&) = delete;
  MovingBody& operator=(const MovingBody&) = delete;

  const BodyGeometry body;
  std::vector<StepPath> paths;
  std::vector<BodyMotion> motions;
};

/// Makes the conditions of faces that belong to one step. They keep the moving body alive.
class EnvelopeConditions {
 public:
  EnvelopeConditions(std::shared_ptr<const MovingBody> moving, std::size_t step)
      : moving_(std::move(moving)), step_(step) {}

  /// `posed`: a face of the body at the start (0) or the end (1) of the step.
  Condition ofCap(const TopoDS_Face& posed, int time) const;
  /// The parameters are that of the edge, and time.
  Condition ofSheet(std::size_t edge) const;
  /// The parameters are the position on the contact curve, and time. `curves`: of the surface in
  /// this step.
  std::vector<Condition> ofGraze(int surface, const ContactCurves& curves, int curve) const;
  /// The parameters are those of the fan, the second multiplied by the length of the step.
  std::vector<Condition> ofFan(int surface, const ContactCurves& curves,
                               const ContactCurves::Fan& fan) const;

 private:
  using Touch = ContactCurves::Touch;
  // `touchAt`: returns a point of contact at the parameters. `doesOwn`: returns whether it belongs
  // to the surface.
  std::vector<Condition> ofContacts(
      int surface, std::function<Touch(const Eigen::Vector2d&)> touchAt,
      std::function<bool(const Eigen::Vector2d&, const Touch&)> doesOwn) const;
  const StepPath& path() const { return moving_->paths[step_]; }

  std::shared_ptr<const MovingBody> moving_;
  std::size_t step_;
};

}  // namespace swept::step
