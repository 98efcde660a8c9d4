// Functions that the fuzzing programs call: bytes in, nothing out. Each one turns the bytes into an
// input and runs the code under test. It throws BrokenPromise if a run ends in another way than
// docs/pipeline.md, "The promise", allows. Tests run the kept cases through the same functions
// (fuzz_cases_test.cpp).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace swept::fuzz {

/// Makes a body, a motion and options from the bytes. Calls compute(), and recut() if the envelope
/// is simplified.
void envelope(const std::uint8_t* data, std::size_t size);
/// Makes a body and options from the bytes, and edits the motion during a PreviewSession.
void preview(const std::uint8_t* data, std::size_t size);
/// Reads the bytes as a table of poses, plain or packed.
void motionFile(const std::uint8_t* data, std::size_t size);
/// Reads a mesh file, whose format is given by the first byte.
void meshFile(const std::uint8_t* data, std::size_t size);
/// Makes a body, a motion and parts that stand still from the bytes, and calls checkClearance().
/// Measures corners of the body at the poses against the parts once more.
void clearance(const std::uint8_t* data, std::size_t size);
/// Makes a surface (mostly an envelope) and options from the bytes, and calls writeSolid(). Only
/// with OpenCASCADE.
void solid(const std::uint8_t* data, std::size_t size);

}  // namespace swept::fuzz
