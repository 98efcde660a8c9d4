// The contact curves within a face of the body at a pose, traced on its parameters. They are needed
// where there is no grazing surface.
// In:      a kernel face; the velocity of each point; the points of its border at which the
//          velocity is tangent to the face.
// Out:     kernel edges with curves in the parameters of the face. They end at the given points.
// Units:   mm.
// Cost:    that of contact_edges.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "solid/assemble/contact_edges.h"

namespace swept::step {

/// Curves that the kernel cannot project onto the face are left out.
std::vector<TopoDS_Edge> contactsWithin(const TopoDS_Face& face, const Velocity& velocity,
                                        const std::vector<gp_Pnt>& atBorder);

}  // namespace swept::step
