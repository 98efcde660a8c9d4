// Turns the exceptions of a run into the status of its result.
//
// In:  a result, and the work that fills it.
// Out: the result of the work; or, if the work threw, an empty result whose report names the
// failure.
// Promise: no exception of this project or of the standard library leaves guarded(), even if no
// memory is free.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/compute.h"

namespace swept {

/// Empties the result and writes the caught exception to its report. Must be called in a catch
/// block.
void failAsThrown(Result& result);

// This is a template, because a std::function might allocate memory before the try block.
template <class Work>
void guarded(Result& result, const Work& work) {
  try {
    work();
  } catch (...) {
    failAsThrown(result);
  }
}

}  // namespace swept
