// Samples on the GPU in two passes (gl_passes.h). The CPU computes the signs in between.
// In: body, motion, grid. Out: marked edges. Without culling they are those of sampleCpu(); with
// culling, more edges deep inside may be marked, but the contributing edges are the same. Elements
// and fractions are set for contributing edges only; fractions may differ by the rounding of one
// unit.
// Cost: time O(elements x bricks + crossings), device memory within a budget.
// Source: J. Brummer, bachelor's thesis, Mainz 2017, chapter 3; docs/gpu.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>

#include "sampling/gl/gl_passes.h"
#include "signs/signs.h"

namespace swept::gl {

class GlSampler {
 public:
  using OpenDevice = std::function<std::shared_ptr<GlDevice>()>;

  /// Opens a device. Throws Error(DeviceUnavailable). `input` must outlive the sampler.
  GlSampler(const SamplerInput& input, OpenDevice open, const GlSettings& settings);
  ~GlSampler();

  /// Returns the seconds that both passes are expected to take. It is estimated from a sample of
  /// the elements, which takes about 1/200 of this time.
  double expectedSeconds(RunContext& run);
  /// Pass 1. After a first loss of the device, repeats the brick on a new context; after a second
  /// loss throws Error(DeviceLost).
  MarkedEdges mark(RunContext& run);
  /// Pass 2. Handles losses of the device like mark(). Also throws Error(DeviceLost) if an edge has
  /// no winner (EdgeWinner).
  void resolve(MarkedEdges& marked, const SignRuns& signs, RunContext& run);

  const std::string& device() const { return deviceName_; }
  const ElementSource& elements() const { return source_; }
  const GlPasses& passes() const { return *passes_; }
  const std::vector<Brick>& bricks() const { return bricks_; }
  int reopened() const { return reopened_; }

 private:
  void open();
  template <class Work>
  auto withDevice(const Work& work);
  void resolveBrick(const Brick& brick, MarkedEdges& marked, const SignRuns& signs,
                    const std::function<void()>& afterDispatch);

  const SamplerInput& input_;
  OpenDevice openDevice_;
  GlSettings settings_;
  ElementSource source_;
  std::shared_ptr<GlDevice> device_;
  std::unique_ptr<GlPasses> passes_;
  std::vector<Brick> bricks_;
  std::string deviceName_;
  std::vector<std::uint64_t> winners_;  // numbers of the winning elements, in order of discovery
  int reopened_ = 0;
};

}  // namespace swept::gl
