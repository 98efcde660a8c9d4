// A simulated EGL and OpenGL. It understands the calls of both passes of the GPU sampler, does
// their work on the CPU, and fails where a test wants it to. Only one can exist at a time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>

#include "sampling/gl/gl_api.h"

namespace swept::test {

/// Faults that a test can plant. Counts start at 1; 0: never.
struct FakeFaults {
  bool noLibrary = false, noContext = false;
  std::string missingFunction;  ///< e.g. "glFenceSync"
  int major = 4, minor = 5;
  std::string renderer = "Imaginary 9000";
  int storageBlocks = 16;
  long long storageBytes = 1 << 27;
  std::string brokenShader;  ///< shaders whose source contains this word do not compile
  bool linkFails = false;
  int resetFromFence = 0;     ///< contexts report a reset from the fence with this number on
  int silentFromFence = 0;    ///< fences with this number and later ones never signal
  int faultyContexts = 1000;  ///< number of contexts, from the first on, with the two faults above
  int setBitsFromReadback = 0;    ///< marks appear all over the brick
  int setOneBitAtReadback = 0;    ///< one mark appears, well within the empty border of the grid
  int clearBitsFromReadback = 0;  ///< a fraction of the marks disappears
  int wrongWinnerFromReadback = 0;
};

struct FakeCounts {
  int contexts = 0, alive = 0, fences = 0, dispatches = 0, markReadbacks = 0, winnerReadbacks = 0;
  int buffers = 0, programs = 0;  ///< not yet deleted
};

std::shared_ptr<gl::GlLoader> makeFakeGl(const FakeFaults& faults);
/// Returns the counts of the fake that was made last.
const FakeCounts& fakeCounts();

}  // namespace swept::test
