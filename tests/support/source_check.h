// Checks the sources that an envelope reports against the body and the motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/compute.h"

namespace swept::test {

/// Per triangle of the envelope: how far the point of its source, moved back by the pose at the
/// named time, lies from the named faces or the edge between them, in mm; infinite where the body
/// has no such thing or the time does not belong to the step; -1 where no source is known. body:
/// faceOf empty for triangles as faces.
std::vector<double> sourceDistances(const TriMesh& body, const Trajectory& motion,
                                    const Sources& sources);

}  // namespace swept::test
