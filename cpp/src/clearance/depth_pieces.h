// Measures pieces of the surfaces of two parts, to find where the parts overlap most.
// In:      two parts and their relative placement.
// Out:     bounds on how deep the points of a piece lie inside the other part.
// Units:   mm.
// Cost:    one nearest-point query and one inside test per piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/pair_search.h"

namespace swept::clearance {

/// A piece of surface: the triangles of a node of the hierarchy, or one triangle of the mesh or a
/// part of it.
struct Piece {
  bool ofBody = true;
  BoxTree::Node node;
  bool isTriangle = false;
  Triangle3d corners;
  /// Place in the other part's tree of a triangle that is probably near; -1: none is known.
  std::int32_t near = -1;
};

struct Probe {
  double depth = 0;  // mm, depth of the centre of the piece
  double radius = 0;
  double most = 0;               // mm, upper bound of the depth of all points of the piece
  Eigen::Vector3d surfacePoint;  // the centre, in the neighbour's frame at the representative pose
  double surfaceDepth = 0;
  std::int32_t near = -1;  ///< see Piece
};

inline Eigen::Vector3d centroid(const Triangle3d& c) { return (c[0] + c[1] + c[2]) / 3.0; }

/// Returns how deep (mm) a point of one mesh lies below the surface of the other; negative if
/// outside. `local` is the point in the frame of its own mesh: the body if `ofBody`, otherwise the
/// neighbour.
double depthIn(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
               bool ofBody, const Eigen::Vector3d& local);
Probe probe(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
            const Piece& piece);
/// Appends the pieces into which a piece is divided: the children of its node, or the four quarters
/// of its triangle.
void cutPiece(const PairSearch& pair, const Piece& piece, std::vector<Piece>& out);
/// Returns the whole surface of each part as one piece, but only if the other part is closed: no
/// point lies inside an open part.
std::vector<Piece> roots(const PairSearch& pair);

}  // namespace swept::clearance
