// The one wall where exceptions become a status.
//
// In:  a result, and the work that fills it.
// Out: what the work left, or, if it threw, an empty result whose report says how it ended.
// Invariant: nothing of ours or of the standard library is thrown on, also without memory to say
// so.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/compute.h"

namespace swept {

/// Within a catch block: empties the result and puts into its report what was caught.
void failAsThrown(Result& result);

// A template, since a std::function may need memory of its own, outside of the wall.
template <class Work>
void guarded(Result& result, const Work& work) {
  try {
    work();
  } catch (...) {
    failAsThrown(result);
  }
}

}  // namespace swept
