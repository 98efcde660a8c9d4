// What made each triangle of an envelope: a face or an edge of the body, and when.
// Asked for by Options::sources. The body's faces are named by TriMesh::faceOf, else every triangle
// of the body is a face of its own.
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
  /// A face of the body as it lies at one pose of the trajectory.
  Cap,
  /// Swept by an edge of the body: where two faces meet at an angle of 8 degrees or more (the
  /// median along the edge), or where the body is open.
  Edge,
  /// Swept by the inside of a face that the sweep touches along a curve, by one that slides along
  /// itself, or by two faces that meet smoothly.
  Graze,
};

/// "cap", "edge" or "graze".
const char* sourceKindName(SourceKind kind);

/// One point of the envelope and what made it. Moved back by the body's motion at that time, the
/// point lies on the triangles of its face (Cap, and Graze with one face) or on an edge between
/// triangles (Edge, Graze), but for rounding: 1e-7 of a cell, a thousandth where the surface passes
/// a lattice point that closely.
struct SurfaceSource {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double timeSeconds = 0;
  /// Cap: the face, and -1. Edge: the faces on either side, the smaller first; -1 second where
  /// there is none. Graze: the face, or the two that meet smoothly.
  std::array<std::int32_t, 2> faces{-1, -1};
  /// Cap: number of the pose. Edge, Graze: of the pose at which the step begins. Poses are counted
  /// as given, from 0.
  std::int32_t step = -1;
  SourceKind kind = SourceKind::Cap;
};

struct Sources {
  /// In `of`: no source is known, as for the strips that close the ends of thin walls.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// Per triangle of the envelope: index of its row, or kNone. Of a simplified envelope: a row
  /// whose kind, faces and step are those of the largest part of the triangle's area.
  std::vector<std::uint32_t> of;
  /// Shared by all envelopes that are cut from one surface; null unless asked for.
  std::shared_ptr<const std::vector<SurfaceSource>> rows;
};

}  // namespace swept
