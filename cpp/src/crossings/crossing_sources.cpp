// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/crossing_sources.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/parallel.h"
#include "base/union_find.h"

namespace swept {
namespace {

/// The faces beside an edge of the body, and the kind of source of the patches that this edge
/// sweeps.
struct EdgeSource {
  std::array<std::int32_t, 2> faces{-1, -1};
  SourceKind kind = SourceKind::Edge;
};

class EdgeSources {
 public:
  EdgeSources(const TriMesh& body, const BodyTopology& topology, bool namedFaces)
      : faceOf_(body.faceOf), topology_(topology), sources_(topology.edges.size()) {
    for (std::size_t e = 0; e < sources_.size(); ++e) sources_[e] = ofEdge(topology.edges[e]);
    if (namedFaces) decideByChains();
  }
  const EdgeSource& operator[](std::size_t edge) const { return sources_[edge]; }

 private:
  double angleAt(const BodyEdge& edge) const {
    return std::acos(std::clamp(
        static_cast<double>(topology_.normals[edge.left].dot(topology_.normals[edge.right])), -1.0,
        1.0));
  }

  EdgeSource ofEdge(const BodyEdge& edge) const {
    const std::int32_t left = faceOf_[edge.left];
    if (edge.right < 0) return {{left, -1}, SourceKind::Edge};
    const std::int32_t right = faceOf_[edge.right];
    if (left == right) return {{left, -1}, SourceKind::Graze};
    const bool smooth = !edge.opposed && angleAt(edge) < kSmoothAngle;
    return {{std::min(left, right), std::max(left, right)},
            smooth ? SourceKind::Graze : SourceKind::Edge};
  }

  /// Gives all connected edges between the same two faces one kind. The median of their angles
  /// decides.
  void decideByChains() {
    std::vector<std::uint32_t> border;
    for (std::uint32_t e = 0; e < sources_.size(); ++e) {
      if (sources_[e].faces[1] >= 0) border.push_back(e);
    }
    using End = std::tuple<std::array<std::int32_t, 2>, std::int32_t, std::uint32_t>;
    std::vector<End> ends;  // faces, vertex, index in `border`
    for (std::uint32_t n = 0; n < border.size(); ++n) {
      const BodyEdge& edge = topology_.edges[border[n]];
      for (const std::int32_t v : {edge.a, edge.b})
        ends.emplace_back(sources_[border[n]].faces, v, n);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::uint32_t> chain(border.size());
    std::iota(chain.begin(), chain.end(), 0u);
    for (std::size_t n = 1; n < ends.size(); ++n) {
      const auto& [faces, vertex, at] = ends[n];
      const auto& [facesBefore, vertexBefore, before] = ends[n - 1];
      if (faces == facesBefore && vertex == vertexBefore) unite(chain, at, before);
    }
    std::vector<std::pair<std::uint32_t, double>> angles;  // by chain
    for (std::uint32_t n = 0; n < border.size(); ++n) {
      const BodyEdge& edge = topology_.edges[border[n]];
      angles.emplace_back(findRoot(chain, n), edge.opposed ? M_PI : angleAt(edge));
    }
    std::sort(angles.begin(), angles.end());
    std::vector<SourceKind> kindOf(border.size(), SourceKind::Edge);
    for (std::size_t begin = 0, end = 0; begin < angles.size(); begin = end) {
      while (end < angles.size() && angles[end].first == angles[begin].first) ++end;
      const double median = angles[begin + (end - begin) / 2].second;
      if (median < kSmoothAngle) kindOf[angles[begin].first] = SourceKind::Graze;
    }
    for (std::uint32_t n = 0; n < border.size(); ++n)
      sources_[border[n]].kind = kindOf[findRoot(chain, n)];
  }

  const std::vector<std::int32_t>& faceOf_;
  const BodyTopology& topology_;
  std::vector<EdgeSource> sources_;
};

/// A patch counts as lying in the plane of a face if the cosine of the angle between their normals
/// exceeds this (2e-3 rad).
constexpr double kInPlane = 1 - 2e-6;

/// `patch` is the side patch of an edge, and `normal` its normal at a crossing. If a face beside
/// the edge slides along itself in the plane of the patch, returns this face, otherwise -1.
std::int32_t slidingFace(const SamplerInput& input, const SweptElement& patch,
                         const Eigen::Vector3f& normal) {
  const BodyEdge& edge = input.topology.edges[patch.index()];
  const Eigen::Matrix3d& rotation = input.motion.placements[patch.placement].rotation;
  for (const std::int32_t face : {edge.left, edge.right}) {
    if (face < 0) continue;
    const Eigen::Vector3d normalInWorld = rotation * input.topology.normals[face].cast<double>();
    if (normalInWorld.dot(normal.cast<double>()) > kInPlane) return input.body.faceOf[face];
  }
  return -1;
}

/// Returns the last pose at or before a time. The time lies within the step that starts at the
/// placement. A merged step has several poses.
std::size_t lastPose(const Motion& motion, const Trajectory& trajectory, std::uint32_t placement,
                     double seconds) {
  const auto [first, end] = std::equal_range(motion.poses.begin(), motion.poses.end(), placement);
  const auto inStep = trajectory.poses.begin() + (first - motion.poses.begin());
  const auto after =
      std::upper_bound(inStep, inStep + (end - first), seconds,
                       [](double time, const Pose& pose) { return time < pose.timeSeconds; });
  return static_cast<std::size_t>(after - trajectory.poses.begin()) - 1;
}

}  // namespace

std::vector<SurfaceSource> sourcesOfCrossings(const SamplerInput& input,
                                              const std::vector<SweptElement>& elements,
                                              const HermiteGrid& grid, bool namedFaces,
                                              const Trajectory& trajectory,
                                              const std::vector<std::int32_t>& pose) {
  const EdgeSources edges(input.body, input.topology, namedFaces);
  std::vector<SurfaceSource> rows(grid.crossings.size());
  const auto describe = [&](std::uint32_t crossing, const Eigen::Vector3d& at) {
    const SweptElement& element = elements[grid.winner[crossing]];
    SurfaceSource& row = rows[crossing];
    row.point = grid.plan.origin + grid.plan.cell * at;
    row.timeSeconds = grid.exactSeconds[crossing];
    const std::size_t last = lastPose(input.motion, trajectory, element.placement, row.timeSeconds);
    row.step = pose[last];
    if (element.isSidePatch()) {
      row.faces = edges[element.index()].faces;
      row.kind = edges[element.index()].kind;
      if (row.kind == SourceKind::Graze) return;
      const std::int32_t sliding = slidingFace(input, element, grid.crossings[crossing].normal);
      if (sliding >= 0) {
        row.faces = {sliding, -1};
        row.kind = SourceKind::Graze;
      }
    } else {
      row.faces = {input.body.faceOf[element.index()], -1};
      row.kind =
          input.motion.poses[last] == element.placement ? SourceKind::Cap : SourceKind::Graze;
    }
  };
  parallelFor(grid.layers.size(), [&](std::size_t i) {
    const HermiteLayer& layer = grid.layers[i];
    for (int axis = 0; axis < 3; ++axis) {
      const auto& start = layer.columnStart[axis];
      for (std::size_t j = 0; j + 1 < start.size(); ++j) {
        for (std::uint32_t e = start[j]; e < start[j + 1]; ++e) {
          const HermiteEdge& edge = layer.edges[axis][e];
          const std::uint32_t end = edge.first + (edge.sides == 3 ? 2 : 1);
          for (std::uint32_t crossing = edge.first; crossing < end; ++crossing) {
            Eigen::Vector3d at(static_cast<double>(i), static_cast<double>(j), edge.k);
            at[axis] += grid.crossings[crossing].fraction;
            describe(crossing, at);
          }
        }
      }
    }
  });
  return rows;
}

}  // namespace swept
