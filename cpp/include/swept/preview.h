// Quick, coarse envelopes of one body while its motion is edited.
//
// Made once for a body: its check, its topology and its clusters of faces stay warm, so that a call
// costs little more than sampling and contouring at the preview's resolution. The motion is
// followed less closely than in a full run (kPreviewChord), and thin walls may end up to a cell
// early; all else, the check and the promise of compute() included, is the same.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "swept/compute.h"

namespace swept {

/// Of a cell: how far a point may leave the refined motion's chord, unless the options allow more.
constexpr double kPreviewChord = 0.1;

class PreviewSession {
 public:
  /// Throws Error as compute() would report it. Of the options, the tolerance for simplification is
  /// left out. The body is copied.
  PreviewSession(const TriMesh& body, const Options& options, RunContext& run);
  ~PreviewSession();
  PreviewSession(PreviewSession&&) noexcept;
  PreviewSession& operator=(PreviewSession&&) noexcept;

  /// As swept::compute() for the body and options of the session; from one thread at a time.
  Result compute(const Trajectory& trajectory, RunContext& run);
  /// The surface alone, to be looked at while the next is made: neither mended nor checked, with
  /// the finding NotChecked. Half the time of compute(). Throws where the options are conservative.
  Result sketch(const Trajectory& trajectory, RunContext& run);
  /// Steps so far that were not sampled again because they were those of the call before.
  std::int64_t stepsKept() const;

 private:
  struct Warm;
  std::unique_ptr<Warm> warm_;
};

}  // namespace swept
