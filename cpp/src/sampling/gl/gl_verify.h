// Tests whether the device computes correctly: with a known case at the start, and with random
// parts of every run.
//
// All checks compare with the exact predicates of the CPU. Only fractions may differ, by at most
// 2^-22 of an edge. Failures throw Error(DeviceLost, "DeviceGarbage") with the device and the
// position.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "sampling/gl/gl_sampler.h"
#include "signs/signs.h"

namespace swept::gl {

/// Samples a small turning body on the device, without and with culling. Compares the marks
/// (without culling) and the contributing edges with those of the CPU. Then calls verifyWinners()
/// for all edges.
void selfTest(const std::shared_ptr<GlDevice>& device, double fenceTimeoutSeconds, RunContext& run);

/// Chooses about `samples` random elements that culling on the CPU keeps, at 16 random placements.
/// Checks that every lattice edge that they cross is marked.
void verifyMarks(const SamplerInput& input, const MarkedEdges& marked, const std::string& device,
                 int samples);

/// Checks that no lattice point inside the body at a random placement has the sign "outside". Only
/// for closed bodies. Cost: one pass over the faces.
void verifySigns(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                 const std::string& device);

/// Chooses about `samples` contributing edges in at most 16 random layers. Checks that their
/// winners (EdgeWinner) cross them at the given fractions.
void verifyWinners(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                   const std::string& device, int samples);

}  // namespace swept::gl
