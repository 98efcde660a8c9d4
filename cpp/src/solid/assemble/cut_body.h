// Cuts the faces of a moving body along their contact curves (contact_edges.h), and tells which of
// the parts move outward.
// In:      kernel shapes; the velocity of each point.
// Cost:    one intersection of the kernel for each face with a contact curve, and one of the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "solid/assemble/contact_edges.h"

namespace swept::step {

/// Returns the faces of the shape, cut along their contact curves. Adjacent faces share edges.
/// Empty if the kernel fails.
TopoDS_Compound cutAtContact(const TopoDS_Shape& shape, const Velocity& velocity,
                             const Message_ProgressRange& progress);

/// Returns 1 if the face moves outward, -1 if inward, 0 if it slides along itself. The face must
/// not cross a contact curve.
int sideOf(const TopoDS_Face& face, const Velocity& velocity);

}  // namespace swept::step
