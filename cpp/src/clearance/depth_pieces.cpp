// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/depth_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swept::clearance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double radiusOf(const Triangle3d& c) {
  const Vector3d m = centroid(c);
  return std::sqrt(
      std::max({(c[0] - m).squaredNorm(), (c[1] - m).squaredNorm(), (c[2] - m).squaredNorm()}));
}

// Transforms a point into the frame of the other part.
Vector3d seen(const Matrix3d& R, const Vector3d& t, bool ofBody, const Vector3d& local) {
  return ofBody ? Vector3d(R * local + t) : Vector3d(R.transpose() * (local - t));
}

// Returns an upper bound of the depth of all points of the piece. `place`: place (box_tree.h) of
// the triangle nearest to the centre. The distance from a triangle is convex, so it is largest at a
// corner of the piece. Where faces lie flat on each other, the bound equals the depth, whatever the
// size of the piece is.
template <class Corners>
double farthestCorner(const PairSearch& pair, const Matrix3d& R, const Vector3d& t,
                      const Piece& piece, std::int32_t place, const Corners& corners) {
  if (place < 0) return std::numeric_limits<double>::infinity();
  const Part& other = piece.ofBody ? pair.neighbour() : pair.body();
  double most = 0;
  for (const Vector3d& corner : corners)
    most = std::max(most, footOnTriangle(seen(R, t, piece.ofBody, corner),
                                         other.corners(static_cast<std::uint32_t>(place)))
                              .offset.norm());
  return most;
}

std::array<Vector3d, 8> cornersOf(const Box& box) {
  std::array<Vector3d, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[k] = box.centre + Vector3d((k & 1) != 0 ? box.half.x() : -box.half.x(),
                                       (k & 2) != 0 ? box.half.y() : -box.half.y(),
                                       (k & 4) != 0 ? box.half.z() : -box.half.z());
  return corners;
}

}  // namespace

double depthIn(const PairSearch& pair, const Matrix3d& R, const Vector3d& t, bool ofBody,
               const Vector3d& local) {
  const Part& other = ofBody ? pair.neighbour() : pair.body();
  return other.depth(seen(R, t, ofBody, local)).depth;
}

Probe probe(const PairSearch& pair, const Matrix3d& R, const Vector3d& t, const Piece& piece) {
  Probe p;
  const Part& own = piece.ofBody ? pair.body() : pair.neighbour();
  const Part& other = piece.ofBody ? pair.neighbour() : pair.body();
  const auto measure = [&](const Vector3d& centre, double radius, const auto& corners) {
    const Part::Depth at = other.depth(seen(R, t, piece.ofBody, centre), piece.near);
    p.radius = radius;
    p.depth = at.depth;
    p.near = at.place >= 0 ? at.place : piece.near;
    p.most = p.depth + p.radius;
    if (p.most > 0) p.most = std::min(p.most, farthestCorner(pair, R, t, piece, at.place, corners));
    p.surfacePoint = piece.ofBody ? Vector3d(R * centre + t) : centre;
  };
  if (piece.isTriangle) {
    measure(centroid(piece.corners), radiusOf(piece.corners), piece.corners);
    p.surfaceDepth = p.depth;
  } else {
    const Box box = own.box(piece.node);
    measure(box.centre, box.half.norm(), cornersOf(box));
    // The centre of a box is not on the surface.
    p.surfaceDepth = -std::numeric_limits<double>::infinity();
  }
  return p;
}

void cutPiece(const PairSearch& pair, const Piece& piece, std::vector<Piece>& out) {
  const Part& own = piece.ofBody ? pair.body() : pair.neighbour();
  if (!piece.isTriangle) {
    for (std::uint32_t k = 0; k < own.tree().children(piece.node); ++k) {
      const BoxTree::Node child = BoxTree::child(piece.node, k);
      Piece p{piece.ofBody, child, child.isItem(), {}, piece.near};
      if (child.isItem()) p.corners = own.corners(child.index);
      out.push_back(p);
    }
    return;
  }
  const Triangle3d& c = piece.corners;
  const Vector3d a = 0.5 * (c[0] + c[1]);
  const Vector3d b = 0.5 * (c[1] + c[2]);
  const Vector3d d = 0.5 * (c[2] + c[0]);
  for (const Triangle3d& part : {Triangle3d{c[0], a, d}, Triangle3d{a, c[1], b},
                                 Triangle3d{d, b, c[2]}, Triangle3d{a, b, d}})
    out.push_back({piece.ofBody, piece.node, true, part, piece.near});
}

std::vector<Piece> roots(const PairSearch& pair) {
  std::vector<Piece> pieces;
  for (const bool ofBody : {true, false}) {
    const Part& own = ofBody ? pair.body() : pair.neighbour();
    const Part& other = ofBody ? pair.neighbour() : pair.body();
    if (!other.closed()) continue;
    Piece p{ofBody, own.tree().root(), own.tree().root().isItem(), {}, -1};
    if (p.isTriangle) p.corners = own.corners(0);
    pieces.push_back(p);
  }
  return pieces;
}

}  // namespace swept::clearance
