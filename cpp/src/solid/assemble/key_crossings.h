// Points at which surfaces of two motion steps are tangent, at the pose between the steps. There,
// curves of intersection end.
// Units:   mm.
// Cost:    some hundred evaluations for each edge and surface of the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gp_Pnt.hxx>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/body_geometry.h"

namespace swept::step {

/// Appends points on edges of the body, whose sheets of both steps have a common border there, and
/// crossings of contact curves of both steps. In world coordinates.
void appendKeyCrossings(const BodyGeometry& body, const StepPath& before, const StepPath& after,
                        std::vector<gp_Pnt>& to);

}  // namespace swept::step
