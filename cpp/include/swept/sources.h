// Records what made each triangle of an envelope: a face or an edge of the body, and when.
// Recorded if Options::sources is set. TriMesh::faceOf defines the faces of the body; without it,
// each triangle of the body is a face.
// Units: mm, s.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace swept {

enum class SourceKind : std::uint8_t {
  /// A face of the body in its place at one pose of the trajectory.
  Cap,
  /// Swept by an edge of the body: a line where the normals of two faces differ by 8 degrees or
  /// more (the median along the edge), or where the body is open.
  Edge,
  /// Swept by the inside of a face that touches the envelope along a curve, by a face that slides
  /// along itself, or by two faces that meet smoothly.
  Graze,
};

/// Returns "cap", "edge" or "graze".
const char* sourceKindName(SourceKind kind);

/// One point of the envelope and what made it. In coordinates of the body at this time, the point
/// lies on the triangles of its face (Cap, and Graze with one face) or on an edge between triangles
/// (Edge, Graze). The rounding error is 1e-7 of a cell, or 1e-3 of a cell if the surface passes
/// that close to a grid point. An envelope can have millions of these rows, which Python sees as
/// plain arrays, so -1 stands for "none" in place of std::optional.
struct SurfaceSource {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double timeSeconds = 0;
  /// Cap: the face, and -1. Edge: the faces on both sides, the lower index first; the second is -1
  /// at an open edge. Graze: the face, and -1, or the two faces that meet smoothly.
  std::array<std::int32_t, 2> faces{-1, -1};
  /// Cap: index of the pose. Edge and Graze: index of the pose at which the motion step begins.
  /// Poses are counted from 0, as given.
  std::int32_t step = -1;
  SourceKind kind = SourceKind::Cap;
};

struct Sources {
  /// Value in `of`: the source is unknown, for example for the strips that close the ends of thin
  /// walls.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// For each triangle of the envelope, its index in `rows`, or kNone. A simplified triangle may
  /// replace surface from several sources. Its row then has the kind, faces and step of the source
  /// with the largest share of its area.
  std::vector<std::uint32_t> of;
  /// All envelopes made from the same surface share these rows. Null unless Options::sources is
  /// set.
  std::shared_ptr<const std::vector<SurfaceSource>> rows;
};

}  // namespace swept
