// Merges successive steps of a motion if every point moves nearly along one chord. A recording has
// many more poses than the accuracy of the chords requires.
//
// In:    a motion from refineMotion(), and the body. Units: mm, s.
// Out:   the same motion with fewer placements. The first and the last placement remain.
// Cost:  O(n log n) for n placements.
// Promise: at every time, every point of the body is within Motion::chordError of its position in
//        the true motion. A merged step deviates by at most `chord`.
// Source: own method; the greedy search for long pieces is that of Imai and Iri, 1986.
//
// A merged step moves each point at constant speed along the chord between two kept placements. The
// deviation at a dropped placement is an affine function of the point. So it is largest at a corner
// of the body's bounding box. Between two successive placements, the true motion deviates from
// their chord by the arc of this step. The distance between this chord and the merged chord, at
// equal times, is largest at an end. So the bound is the sum of three terms: the largest deviation
// of a dropped placement, the largest arc of a step, and the warp of the side patches
// (step_path.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Returns the motion with merged steps. Returns it unchanged if this would save less than half of
/// the steps. `chord`: the largest bound of a merged step (mm); dropped placements use at most half
/// of it. The chords of the given motion must deviate by at most motion.chordError.
Motion mergeSteps(Motion motion, const TriMesh& body, double chord, RunContext& run);

}  // namespace swept
