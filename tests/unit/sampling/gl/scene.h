// A body on a path with its grid, and a comparison of the results of two samplers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "pipeline/backend.h"
#include "sampling/gl/gl_sampler.h"
#include "support/shapes.h"

namespace swept::test {

struct Scene {
  TriMesh body;
  BodyTopology topology;
  Motion motion;
  GridPlan grid;
  bool cull = true, orientable = true;

  Scene(TriMesh mesh, const Trajectory& trajectory, int resolution);
  SamplerInput input() const { return {body, topology, motion, grid, cull, orientable}; }
};

/// Returns a path along which a body turns and moves.
Trajectory turningPath(int poses, Interpolation interpolation);

struct Difference {
  std::int64_t edges = 0;      ///< contributing edges of only one result, or with different signs
  std::int64_t fractions = 0;  ///< contributing crossings with different fractions
  std::int64_t elements = 0;   ///< contributing crossings won by different elements
  double largestFraction = 0;  ///< cells
  std::int64_t contributing = 0;
  double longestDispatch = 0;  ///< s, of the GPU
};
/// Compares the contributing edges, and their crossings next to outside ends. `signs`: those of
/// `a`.
Difference compare(const Scene& scene, const MarkedEdges& a, const MarkedEdges& b,
                   const SignRuns& signs);

}  // namespace swept::test
