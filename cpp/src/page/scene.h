// The 3D view of a page: shapes, motion and pairs as data for resources/page/view.js.
// Shapes are simplified to about a given number of triangles (drawable.h). Positions have 16 bits
// along each side of the shape's box, normals 8 bits. The motion is a list of frames with the poses
// of every moving part: about 120 moments or the poses of motions without interpolation, plus the
// moment of each row.
// Cost: O(triangles); 28 bytes per frame and moving part.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "page/rows.h"
#include "page/words.h"
#include "swept/page.h"
#include "swept/run_context.h"

namespace swept::page {

/// Returns markup with data and script; a sentence if this program has no 3D view; nothing if there
/// are no parts. Throws Error(Cancelled).
std::string viewOf(const CheckReport& check, const PageOptions& options, const Words& words,
                   RunContext& run);

/// Returns the pose of a part at a moment, clamped to its motion. Without interpolation, returns
/// the last pose that is not later than the moment.
Pose poseAt(const Trajectory& motion, double time);

}  // namespace swept::page
