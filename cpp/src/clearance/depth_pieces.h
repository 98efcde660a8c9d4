// Pieces of the surfaces of two parts, for the search for their deepest overlap.
// In:    two parts and how one stands to the other. Out: bounds on how deep the points of a piece
// lie
//        inside the other part. Units: mm. Cost: one nearest-point and inside query a piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/pair_search.h"

namespace swept::clearance {

/// A piece of surface: a box of the hierarchy, or a triangle cut out of a leaf's triangle.
struct Piece {
  bool ofBody = true;
  BoxTree::Node node;
  bool isTriangle = false;
  Triangle3d corners;
};

struct Probe {
  double depth = 0;  // at the piece's centre
  double radius = 0;
  double most = 0;               // no point of the piece is deeper
  Eigen::Vector3d surfacePoint;  // world, at the representative pose
  double surfaceDepth = 0;
};

inline Eigen::Vector3d centroid(const Triangle3d& c) { return (c[0] + c[1] + c[2]) / 3.0; }

/// Depth of a point of one mesh, given in that mesh's frame, below the other's surface.
double depthIn(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
               bool ofBody, const Eigen::Vector3d& local);
Probe probe(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
            const Piece& piece);
/// Appends the parts of a piece: what a box of the hierarchy holds, four of a triangle.
void cutPiece(const PairSearch& pair, const Piece& piece, std::vector<Piece>& out);
/// The surfaces whose points can lie inside the other part, which has to be closed.
std::vector<Piece> roots(const PairSearch& pair);

}  // namespace swept::clearance
