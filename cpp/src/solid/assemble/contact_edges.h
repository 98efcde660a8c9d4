// Finds the curves along which a face of a moving body touches the envelope (contact curves). The
// velocity of the body is tangent to the face there: n.v = 0. On one side of such a curve the face
// moves outward, on the other side inward.
// In:      a kernel face; the velocity of each point.
// Out:     kernel edges: lines, circles or cubic splines.
// Units:   mm. A spline is within 5e-8 mm of the exact curve, except where n.v is not smooth.
// Cost:    some thousand evaluations for each smooth piece of a surface.
// Source:  contact curves: Abdel-Malek, Blackmore and Joy 2006. They are traced as level lines of
//          n.v on a grid of surface parameters (marching squares); each point is then exact.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <vector>

namespace swept::step {

using Velocity = std::function<gp_Vec(const gp_Pnt&)>;

/// Where the sine of the angle between velocity and face is smaller than this everywhere, the face
/// slides along itself.
constexpr double kSliding = 1e-6;

/// Returns the contact curves of the face, cut at their cusps: where they run along the velocity.
/// They may extend beyond the border of the face.
std::vector<TopoDS_Edge> contactEdges(const TopoDS_Face& face, const Velocity& velocity);

}  // namespace swept::step
