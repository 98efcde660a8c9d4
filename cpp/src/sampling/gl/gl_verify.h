// Tests whether the device computes correctly: a known field at the start, random parts of every
// run after it.
//
// All checks compare with the exact predicates of the CPU; the device has no tolerance. They throw
// Error(DeviceLost, "DeviceGarbage") that names the device, what was expected and where.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "sampling/gl/element_source.h"
#include "sampling/gl/gl_sampler.h"
#include "signs/signs.h"

namespace swept::gl {

/// Samples a small turning body on the device and compares every mark, fraction and element.
void selfTest(const std::shared_ptr<GlDevice>& device, double fenceTimeoutSeconds, RunContext& run);

/// Every crossing of `samples` random elements must be marked.
void verifyMarks(const SamplerInput& input, const ElementSource& source, const MarkedEdges& marked,
                 const std::string& device, int samples);

/// Lattice points inside the body at a random placement must not be outside. Closed bodies only.
/// Cost: one pass over the faces.
void verifySigns(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                 const std::string& device);

/// The winners of about `samples` contributing edges must cross them where the device says.
void verifyWinners(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                   const std::string& device, int samples);

}  // namespace swept::gl
