// Quadric edge collapse with a bound on the deviation that holds at every step.
//
// In:    closed manifold mesh (cells), a quadric a vertex, samples: points of the original surface
//        with the largest distance allowed for each and the vertex near which they lie.
// Out:   fewer triangles; no sample lies farther from the mesh than allowed, no new vertex farther
//        from the original.
// Order: cheapest first (Garland and Heckbert 1997). Every triangle knows the samples nearest to
//        it; a collapse is refused if one of them would be left too far behind, if the ring is not
//        a disc (link condition), if a triangle turns over or loses its shape.
// Cost:  about 10 us a collapse; serial, hence deterministic.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "swept/run_context.h"

namespace swept {

struct CollapseVertex {
  Eigen::Vector3d position;
  Quadric quadric;
  std::int32_t sample = -1;  ///< an original vertex near it
  Eigen::Vector3d samplePoint;
};

struct CollapseMesh {
  std::vector<CollapseVertex> vertices;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Points of the original surface whose distance is kept within their limit.
struct Samples {
  std::vector<Eigen::Vector3d> points;
  std::vector<float> limit;            ///< cells
  std::vector<std::int32_t> vertex;    ///< in: vertex of the mesh near the sample
  std::vector<std::int32_t> triangle;  ///< out: triangle of the result nearest to it
  double largest = 0;                  ///< out: largest distance of a sample, cells
};

void collapseEdges(CollapseMesh& mesh, Samples& samples, const NearestTriangle& original,
                   double tolerance, RunContext& run);

}  // namespace swept
