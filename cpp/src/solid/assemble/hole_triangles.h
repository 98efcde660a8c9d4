// Triangles of the envelope's mesh that fill the holes between faces.
// In:      faces that are right, with their normals outward, and their open edges; the closed mesh
//          of the whole envelope.
// Out:     triangles whose border vertices lie on the open edges, and these vertices along each
//          edge. Or, faces along which the mesh cannot be cut: without them, it may be possible.
// Units:   mm.
// Cost:    O(n log n) for n triangles of the mesh.
// Method:  The mesh is cut along the open edges (mesh/imprint.h). Each region between these paths
//          is a hole, or is covered by faces, depending on the side on which the faces at its
//          border lie. Then the triangles of the holes are simplified; vertices on open edges stay
//          there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "solid/assemble/open_edges.h"
#include "solid/mesh/decimate.h"
#include "solid/mesh/imprint.h"
#include "swept/run_context.h"

namespace swept::step {

/// How far the straight side of a triangle may be off a curved edge, as a fraction of the
/// tolerance.
constexpr double kSagFraction = 0.25;

/// The vertices of triangles along an edge, and their parameters on it.
struct EdgePath {
  std::vector<std::int32_t> vertices;
  std::vector<double> params;
};

class HoleTriangles {
 public:
  /// A side of a triangle on an open edge.
  struct Side {
    std::size_t edge;  ///< index in open()
    double from, to;   ///< parameters
    auto operator<=>(const Side&) const = default;
  };
  using Sides = std::set<Side>;
  /// By edge (its TShape): parameters of vertices that it gets in addition to those that the
  /// tolerance demands.
  using MorePoints = std::map<const void*, std::set<double>>;

  /// `areas`: of the faces, mm^2. `mesh`: thinned, if it is large.
  HoleTriangles(const std::vector<double>& areas, std::vector<OpenEdge> open,
                const MorePoints& more, const HalfEdgeMesh& mesh, double tolerance);

  /// Cuts the mesh. Marks faces that must be left out, if this fails.
  void cut(std::vector<char>& isWrong);
  /// Simplifies the triangles in the holes, after cut(). They stay within the tolerance of the
  /// `original` mesh. Returns sidesAround() of triangles without area, and of triangles that
  /// intersect.
  std::vector<Sides> simplify(const NearestTriangle& original, RunContext& run);

  const std::vector<OpenEdge>& open() const { return open_; }
  /// By open edge.
  const std::vector<EdgePath>& paths() const { return paths_; }
  const std::vector<Eigen::Vector3d>& points() const { return mesh_.points; }
  /// Returns the triangles in the holes.
  const std::vector<std::int32_t>& inHoles() const { return inHoles_; }
  const std::array<std::int32_t, 3>& triangle(std::int32_t t) const { return mesh_.triangles[t]; }
  /// Returns the sides on open edges that end at vertices of a triangle.
  Sides sidesAround(std::int32_t t) const;
  /// Returns whether a vertex in the middle of a side would be far enough from others.
  bool canHalve(const Side& side) const;
  int smallestFaceAt(const Sides& sides) const;

 private:
  using Ends = std::pair<std::int32_t, std::int32_t>;  // of an edge of the mesh, sorted
  bool insertPoints(std::size_t edge);
  bool connect(std::size_t edge);
  void findHoles(std::vector<char>& isWrong);
  int smallestOf(const std::set<int>& faces) const;
  // Calls use(side, from, to) for each step of the paths, in the direction in which the face lies
  // on its left.
  template <class Use>
  void forSteps(const Use& use) const;
  void takeSimplified(const Decimated& simple, const std::vector<Eigen::Vector3d>& before);
  int faceAt(const Side& side) const { return open_[side.edge].face; }

  const std::vector<double> area_;  // mm^2, by face
  const std::vector<OpenEdge> open_;
  const MorePoints& more_;
  const double tolerance_;
  Imprint imprint_;
  std::map<const void*, std::int32_t> ends_;       // vertices of the mesh for those of the faces
  std::vector<std::vector<std::int32_t>> points_;  // by open edge: vertices that must stay
  std::vector<EdgePath> paths_;
  std::vector<char> isHole_;  // by triangle of the cut mesh
  HalfEdgeMesh mesh_;         // simplified
  std::vector<std::int32_t> inHoles_;
  std::map<Ends, Side> sideAt_;  // by edge of a path
};

}  // namespace swept::step
