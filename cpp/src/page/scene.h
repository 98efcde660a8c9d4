// The 3D view of a page: shapes, motion and places as data for resources/page/view.js.
// Shapes are thinned to about a number of triangles (drawable.h); positions are 16 bits of the
// shape's box, normals 8 bits. The motion is a list of frames: about 120 moments and the moment of
// each row, at which every moving part has its pose.
// Cost: O(triangles); a frame is 28 bytes a part.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "page/rows.h"
#include "page/words.h"
#include "swept/page.h"
#include "swept/run_context.h"

namespace swept::page {

/// Markup with its data and its script; a sentence where this program has no 3D view, nothing where
/// there are no parts. Throws Error(Cancelled).
std::string viewOf(const Told& told, const PageOptions& options, const Words& words,
                   RunContext& run);

/// Where a part is at a moment, clamped to its motion. Without interpolation: the last pose that
/// is not after it.
Pose poseAt(const Trajectory& motion, double time);

}  // namespace swept::page
