// What the fuzzing programs call: bytes in, nothing out. Each turns the bytes into an input, runs
// the code under test and throws BrokenPromise when a run ends in another way than
// docs/pipeline.md, "The promise", allows. The kept cases are run through the same functions by
// the tests (fuzz_cases_test.cpp).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace swept::fuzz {

/// Body, motion and options from the bytes, then compute(), and recut() where it is simplified.
void envelope(const std::uint8_t* data, std::size_t size);
/// Body and options from the bytes, then a PreviewSession while the motion is edited.
void preview(const std::uint8_t* data, std::size_t size);
/// The bytes as a table of poses, plain or packed, then checkTrajectory's part of compute().
void motionFile(const std::uint8_t* data, std::size_t size);
/// First byte: the format; the rest: a mesh file, then the body check.
void meshFile(const std::uint8_t* data, std::size_t size);
/// Body, motion and parts that stand still from the bytes, then checkClearance(); corners of the
/// body at the poses are measured against the parts once more.
void clearance(const std::uint8_t* data, std::size_t size);
/// A surface (mostly an envelope) and options from the bytes, then writeSolid(). Only with
/// OpenCASCADE.
void solid(const std::uint8_t* data, std::size_t size);

}  // namespace swept::fuzz
