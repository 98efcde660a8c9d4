// Cuts the faces of a moving body where they touch the envelope: along the curves on which the
// velocity of the body is tangent to the face (n.v = 0, the contact curves). On one side of such a
// curve the face moves outward, on the other side inward.
// In:      kernel shapes; the velocity of each point.
// Out:     kernel edges and faces. A contact curve is a line, a circle or a cubic spline.
// Units:   mm. A spline is within 5e-8 mm of the exact curve, except where n.v is not smooth.
// Cost:    some thousand evaluations for each smooth piece of a surface.
// Source:  contact curves: Abdel-Malek, Blackmore and Joy 2006. They are traced as level lines of
//          n.v on a grid of surface parameters (marching squares); each point is then exact.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <vector>

namespace swept::step {

using Velocity = std::function<gp_Vec(const gp_Pnt&)>;

/// Returns the contact curves of the face. They may extend beyond its border.
std::vector<TopoDS_Edge> contactEdges(const TopoDS_Face& face, const Velocity& velocity);

/// Returns the faces of the shape, cut along their contact curves. Adjacent faces share edges.
/// Empty if the kernel fails.
TopoDS_Compound cutAtContact(const TopoDS_Shape& shape, const Velocity& velocity,
                             const Message_ProgressRange& progress);

/// Returns 1 if the face moves outward, -1 if inward, 0 if it slides along itself. The face must
/// not cross a contact curve.
int sideOf(const TopoDS_Face& face, const Velocity& velocity);

}  // namespace swept::step
