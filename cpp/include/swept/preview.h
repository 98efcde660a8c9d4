// Computes quick, coarse envelopes of one body while its motion is edited.
// A session is created once for a body and keeps its checked mesh, its topology and its clusters of
// faces. A call then costs little more than sampling and contouring at the resolution of the
// preview. The motion is followed less closely than in a full run (kPreviewChord), and thin walls
// may be cut off up to a cell before their end. Everything else is as in compute(), including the
// check and the promise.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "swept/compute.h"

namespace swept {

/// Smallest chord tolerance of previews, as a fraction of a cell.
constexpr double kPreviewChord = 0.1;

class PreviewSession {
 public:
  /// Throws the Error that compute() would report. Ignores Options::tolerance. Copies the body.
  PreviewSession(const TriMesh& body, const Options& options, RunContext& run);
  ~PreviewSession();
  PreviewSession(PreviewSession&&) noexcept;
  PreviewSession& operator=(PreviewSession&&) noexcept;

  /// Works as swept::compute() with the body and options of the session. Only one thread may call
  /// at a time.
  Result compute(const Trajectory& trajectory, RunContext& run);
  /// Computes only the surface, for display: it is neither repaired nor checked, and has the
  /// finding NotChecked. Takes half the time of compute(). Fails if the options are conservative.
  Result sketch(const Trajectory& trajectory, RunContext& run);
  /// Returns the number of motion steps, over all calls, that were not sampled again because the
  /// previous call had the same steps.
  std::int64_t stepsKept() const;

 private:
  struct Warm;
  std::unique_ptr<Warm> warm_;
};

}  // namespace swept
