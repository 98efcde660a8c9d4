// Kernel faces with their triangulations, which show where the faces intersect.
// In:      faces; two of them may share edges. Faces of one group are not intersected.
// Out:     chains of points at which the triangulations of two faces intersect.
// Units:   mm; parameters of the faces.
// Cost:    O(n log n) for n triangles.
// Method:  Where an edge of one triangulation passes through a triangle of the other one, a curve
//          of intersection begins or continues. Pairs of triangles join such points to chains.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Dense>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/box_tree.h"
#include "solid/assemble/swept_faces.h"

namespace swept::step {

/// A point of a surface, with the derivatives there.
struct Jet {
  Eigen::Vector3d at, u, v;
  Eigen::Vector3d normal() const { return u.cross(v).normalized(); }
};

/// Where an edge of the triangulation of one face passes through a triangle of another one, or a
/// node of both triangulations.
struct Piercing {
  Eigen::Vector3d at;
  std::array<Eigen::Vector2d, 2> on;  ///< parameters on both faces
  int border = -1;                    ///< the edge, if it lies on the border of a face
  int borderSide = 0;                 ///< which of the two faces that is
  bool isNode = false;
};

/// Two faces, and a chain of points at which they intersect.
struct FaceChain {
  int a, b;
  std::vector<Piercing> points;
};

class MeshedFaces {
 public:
  /// `deflection`: mm, how far the triangles may lie from the faces.
  MeshedFaces(const std::vector<SweptFace>& faces, double deflection);

  std::size_t size() const { return faces_.size(); }
  const TopoDS_Face& face(int f) const { return given_[f].face; }
  double deflection() const { return deflection_; }
  /// All edges that are not degenerated, from 1.
  const TopTools_IndexedMapOfShape& edges() const { return edges_; }
  TopoDS_Edge edge(int e) const { return TopoDS::Edge(edges_(e)); }
  const std::set<int>& edgesOf(int f) const { return faces_[f].edges; }
  /// Returns the borders of other faces that lie on a face.
  const std::vector<TopoDS_Edge>& innerEdges(int f) const { return given_[f].inner; }
  bool hasEdge(int f, int e) const { return faces_[f].edges.count(e) != 0; }
  /// Returns the common vertices of two faces that have a common edge; none for other faces.
  std::vector<Eigen::Vector3d> commonVertices(int f, int g) const;
  bool areOfOneGroup(int f, int g) const;

  Jet jet(int f, const Eigen::Vector2d& on) const;
  bool isInFace(int f, const Eigen::Vector2d& on) const;
  /// Returns whether a point of a face may be on the envelope and belongs to no other face. If
  /// there are few faces, the first is not tested.
  bool isPossible(int f, const Eigen::Vector2d& on) const;
  /// Returns whether a point of a face belongs to no other face.
  bool doesOwn(int f, const Eigen::Vector2d& on) const;
  /// Returns whether the parameters are within the range of those of the face, or a little beyond.
  bool isInRange(int f, const Eigen::Vector2d& on) const;
  /// Returns the curve of an edge in the parameters of a face; null if there is none.
  Handle(Geom2d_Curve) curveOn(int f, const TopoDS_Edge& edge) const;

  /// The chains of all pairs of faces.
  std::vector<FaceChain> chains() const;
  /// Returns the faces near a segment, with the parameters of a point nearby.
  std::map<int, Eigen::Vector2d> near(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  // A part of the border of a face, in its parameters, along which v only grows or only falls.
  struct BorderPart {
    Handle(Geom2d_Curve) curve;
    std::array<double, 2> range;
    std::array<Eigen::Vector2d, 2> ends;
    bool isStraight;
    double uAt(double v) const;
  };
  struct Meshed {
    Handle(Geom_Surface) surface;
    std::vector<Eigen::Vector3d> nodes;
    std::vector<Eigen::Vector2d> parameters;  // by node
    std::vector<int> shared;                  // by node: its index among the nodes of all faces
    std::vector<std::array<int, 3>> triangles;
    std::map<std::pair<int, int>, int> borders;  // two nodes -> edge
    std::set<int> edges;
    std::vector<BorderPart> parts;
    Eigen::AlignedBox2d range;  // of the parameters
  };
  using Triangle = std::pair<int, int>;  // face, triangle of the face
  struct FoundPiercing;
  struct PairChains;

  static void appendParts(const TopoDS_Face& face, const TopoDS_Edge& edge,
                          std::vector<BorderPart>& to);
  Meshed meshOf(const TopoDS_Face& face, std::map<std::array<long long, 3>, int>& nodes) const;
  const std::array<int, 3>& corners(const Triangle& t) const {
    return faces_[t.first].triangles[t.second];
  }
  BoxTree::Bounds boxOf(const Triangle& t) const;
  void pierceEdges(const Triangle& s, const Triangle& t, int side, int sharedNode,
                   std::vector<FoundPiercing>& to) const;
  std::vector<FoundPiercing> piercingsOf(const Triangle& s, const Triangle& t) const;

  const std::vector<SweptFace>& given_;
  const double deflection_;
  TopTools_IndexedMapOfShape edges_;
  std::vector<Meshed> faces_;
  std::vector<Triangle> triangles_;
  BoxTree tree_;
};

}  // namespace swept::step
