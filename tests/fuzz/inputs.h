// Makes bodies and motions, valid and damaged ones, from the bytes of a fuzzer.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "fuzz/byte_source.h"
#include "swept/types.h"

namespace swept::fuzz {

/// Returns a small body (mm), intact or damaged, near the origin or far away.
TriMesh body(ByteSource& bytes);
/// Returns a motion of 0 to 6 poses.
Trajectory motion(ByteSource& bytes);

/// Returns whether SWEPT_FUZZ_SHOW=1 is set. Then the inputs are printed as text, to show what the
/// bytes mean.
bool printsInputs();
void show(const Trajectory& motion);
void show(const TriMesh& mesh);

}  // namespace swept::fuzz
