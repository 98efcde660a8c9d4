// Makes bodies and motions, valid and damaged ones, from the bytes of a fuzzer.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "fuzz/byte_source.h"
#include "swept/types.h"

namespace swept::fuzz {

/// A small body, whole or after a few blows with a hammer, near the origin or far away; mm.
TriMesh body(ByteSource& bytes);
/// 0 to 6 poses.
Trajectory motion(ByteSource& bytes);

/// SWEPT_FUZZ_SHOW=1: inputs are printed in words, to see what an input of bytes means.
bool wantsToSee();
void show(const Trajectory& motion);
void show(const TriMesh& mesh);

}  // namespace swept::fuzz
