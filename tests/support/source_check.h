// Checks the sources that an envelope reports against the body and the motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/compute.h"

namespace swept::test {

/// Returns a distance (mm) for each triangle of the envelope. The point of the triangle's source is
/// moved back by the pose at the source's time. The distance is that of the moved point from the
/// source's faces, or from the edge between them. It is infinite if the body has no such face or
/// edge, or if the time does not belong to the step, and -1 if there is no source. body: an empty
/// faceOf means that each triangle is a face.
std::vector<double> sourceDistances(const TriMesh& body, const Trajectory& motion,
                                    const Sources& sources);

}  // namespace swept::test
