// A simulated EGL and OpenGL. It understands the calls of the two passes, does their work on the
// CPU, and fails where a test wants it to. Only one can exist at a time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>

#include "sampling/gl/gl_api.h"

namespace swept::test {

/// What goes wrong. Counts start at 1; 0: never.
struct FakeFaults {
  bool noLibrary = false, noContext = false;
  std::string missingFunction;  ///< e.g. "glFenceSync"
  int major = 4, minor = 5;
  std::string renderer = "Imaginary 9000";
  int storageBlocks = 16;
  long long storageBytes = 1 << 27;
  std::string brokenShader;  ///< a word of the source that does not compile
  bool linkFails = false;
  int resetFromFence = 0;         ///< contexts report a reset from this fence of theirs on
  int silentFromFence = 0;        ///< fences never signal from this one on
  int faultyContexts = 1000;      ///< the two above hold for so many contexts
  int setBitsFromReadback = 0;    ///< marks appear all over the brick
  int setOneBitAtReadback = 0;    ///< one mark appears, well within the empty border of the grid
  int clearBitsFromReadback = 0;  ///< a share of the marks disappears
  int wrongWinnerFromReadback = 0;
};

struct FakeCounts {
  int contexts = 0, alive = 0, fences = 0, dispatches = 0, markReadbacks = 0, winnerReadbacks = 0;
  int buffers = 0, programs = 0;  ///< not yet deleted
};

std::shared_ptr<gl::GlLoader> makeFakeGl(const FakeFaults& faults);
/// Of the fake made last.
const FakeCounts& fakeCounts();

}  // namespace swept::test
