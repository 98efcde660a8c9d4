// Makes kernel faces of the triangles that fill holes between faces.
// In:      HoleTriangles, simplified.
// Out:     the faces, with their open edges cut at the vertices of the triangles; and the facets,
//          which share these edges.
// Units:   mm.
// Cost:    some microseconds per facet.
// Method:  A facet with straight sides is plane. One at a curved edge is a cone: the lines from the
//          points of the edge to the opposite corner. So it contains the edge exactly. The edge of
//          a plane face needs no cones: it becomes straight between the vertices.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopTools_DataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <map>
#include <utility>
#include <vector>

#include "solid/assemble/hole_triangles.h"

namespace swept::step {

class HoleFacets {
 public:
  /// Keeps references to its arguments.
  HoleFacets(const std::vector<TopoDS_Face>& faces, const HoleTriangles& triangles);

  /// Returns the sides at which no facet can be made.
  const HoleTriangles::Sides& failed() const { return failed_; }
  /// Returns the faces, in their order, and then the facets.
  std::vector<TopoDS_Face> all() const;
  /// Returns the triangle of the facet with this index.
  std::int32_t triangleOf(std::size_t facet) const { return triangleOf_[facet]; }
  /// Returns all(), with facets that lie in one plane joined.
  std::vector<TopoDS_Face> joinedAll() const;

 private:
  using Ends = std::pair<std::int32_t, std::int32_t>;  // vertices of triangles, sorted
  using Corners = std::array<std::int32_t, 3>;
  struct Border {
    TopoDS_Edge edge;
    std::int32_t from;  // its first vertex
    HoleTriangles::Side side;
  };

  void cutEdge(std::size_t edge, const HoleTriangles& triangles);
  TopoDS_Face withCutEdges(const TopoDS_Face& face) const;
  TopoDS_Vertex vertexOf(std::int32_t v);
  // Returns the edge from a to b, oriented in this direction.
  TopoDS_Edge sideOf(std::int32_t a, std::int32_t b);
  // Returns whether the side from the first corner to the second is a curve outside of the plane of
  // the triangle.
  bool isCurved(const Corners& corners) const;
  void appendFacet(Corners corners);
  // Returns the cone over the curve of an edge; null if there is none.
  Handle(Geom_Surface) coneOver(const TopoDS_Edge& edge, const Eigen::Vector3d& apex) const;
  // Returns the face on a cone. `sides`: the first is the curved one.
  TopoDS_Face coneFace(const Handle(Geom_Surface) & cone, const std::array<TopoDS_Edge, 3>& sides,
                       const TopoDS_Vertex& apex) const;

  const std::vector<TopoDS_Face>& faces_;
  std::vector<Eigen::Vector3d> points_;
  std::map<std::int32_t, TopoDS_Vertex> vertices_;
  std::map<Ends, Border> borders_;
  std::map<Ends, TopoDS_Edge> inner_;
  TopTools_DataMapOfShapeListOfShape parts_;  // of open edges
  std::vector<TopoDS_Face> cut_, facets_;
  std::vector<std::int32_t> triangleOf_;
  std::int32_t triangle_ = -1;  // whose facets are being made
  HoleTriangles::Sides failed_;
};

}  // namespace swept::step
