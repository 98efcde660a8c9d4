// Finds the curves in which faces intersect, where they are edges of the swept volume.
// In:      faces; curves along which some of them touch (dividers); the crossings of dividers.
// Out:     parts of the curves of intersection and of the dividers. They end at each other and at
//          borders of faces.
// Units:   mm.
// Cost:    1 s for 50 faces.
// Method:  Curves of intersection begin where triangulations of the faces intersect
//          (meshed_faces.h), and where a border or a divider passes through a face. They are
//          followed on the exact surfaces (section_tracer.h), and cut where they pass through a
//          further face. A part is kept if it is an edge of the swept volume, judged by sample
//          points around it.
//          Where two faces are nearly tangent, it is not certain where exactly they intersect.
//          Points at which the ends of curves meet ("events") are therefore taken from the most
//          certain source: vertices and dividers first, then borders and dividers that pass through
//          faces, then other curves.
// Limits:  closed curves smaller than a triangle; a face that intersects itself.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressRange.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "solid/assemble/divide_faces.h"
#include "solid/assemble/sides.h"
#include "solid/assemble/swept_faces.h"

namespace swept::step {

/// Returns nothing if the user cancels.
std::vector<SweptSection> meshSections(const std::vector<SweptFace>& faces,
                                       const std::vector<SweptSection>& dividers,
                                       const std::vector<SweptSection>& folds,
                                       const std::vector<gp_Pnt>& crossings, const Sides& sides,
                                       const Message_ProgressRange& progress);

}  // namespace swept::step
