// A body with plane faces and straight edges, and the body at a pose.
// Units:   mm, in coordinates of the body whose origin is the pivot.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_Transform.hxx>
#include <Eigen/Core>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <memory>
#include <vector>

#include "swept/types.h"

namespace swept::step {

struct BodyEdge {
  TopoDS_Edge shape;
  int from = 0, to = 0;          ///< vertices
  Eigen::Vector3d start, along;  ///< `along`: unit vector
  double length = 0;
  std::array<int, 2> faces{-1, -1};
  Eigen::Vector3d at(double u) const { return start + u * along; }
};

struct BodyFace {
  TopoDS_Face shape;
  Eigen::Vector3d normal;  ///< unit vector that points away from the body
  std::vector<int> edges;
};

/// Returns whether the body has plane faces and straight edges only.
bool isPolyhedron(const TopoDS_Shape& body);

/// The parts of a body for which isPolyhedron() is true.
struct Polyhedron {
  explicit Polyhedron(const TopoDS_Shape& body);

  Eigen::Vector3d point(int vertex) const;
  /// Returns whether the body is convex at the edge. Other edges sweep no surface of the envelope.
  bool isConvex(const BodyEdge& edge) const;

  TopTools_IndexedMapOfShape vertices;
  std::vector<BodyEdge> edges;
  std::vector<BodyFace> faces;
};

/// A copy of the body at one pose.
class PosedBody {
 public:
  PosedBody(const TopoDS_Shape& body, const Pose& pose);
  TopoDS_Face of(const BodyFace& face) const {
    return TopoDS::Face(maker_->ModifiedShape(face.shape));
  }
  /// Forward.
  TopoDS_Edge of(const BodyEdge& edge) const {
    return TopoDS::Edge(maker_->ModifiedShape(edge.shape).Oriented(TopAbs_FORWARD));
  }
  TopoDS_Shape of(const TopoDS_Shape& vertex) const { return maker_->ModifiedShape(vertex); }

 private:
  std::unique_ptr<BRepBuilderAPI_Transform> maker_;
};

}  // namespace swept::step
