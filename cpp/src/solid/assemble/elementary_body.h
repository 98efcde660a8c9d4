// A body with planes, cylinders, straight and circular edges, and the body at a pose.
// Units:   mm, rad, in coordinates of the body whose origin is the pivot.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_Transform.hxx>
#include <Eigen/Core>
#include <Geom_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <memory>
#include <vector>

#include "solid/carrier/bspline.h"
#include "swept/types.h"

namespace swept::step {

struct BodyEdge {
  TopoDS_Edge shape;
  int from = 0, to = 0;  ///< vertices
  Handle(Geom_Curve) curve;
  Range range;  ///< of the parameter: mm on a line, rad on a circle
  bool isStraight = true;
  double scale = 1;  ///< mm per unit of the parameter
  std::array<int, 2> faces{-1, -1};
  Eigen::Vector3d at(double u) const;
  Eigen::Vector3d tangent(double u) const;  ///< unit vector
};

/// A plane or a cylinder.
struct BodySurface {
  bool isPlane = true;
  /// A point of the plane, or of the axis.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /// Orthogonal unit vectors; `axis`: normal of the plane.
  Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                  axis = Eigen::Vector3d::UnitZ();
  double radius = 0;
  double outward = 1;  ///< -1 if `axis`, or the direction away from it, points into the body

  /// Returns the unit vector that points away from the body.
  Eigen::Vector3d normalAt(const Eigen::Vector3d& p) const;
  /// mm, along `axis`, or away from it.
  double distanceTo(const Eigen::Vector3d& p) const;
  /// Returns the kernel's parameters of a point of the surface. On a cylinder, the angle is within
  /// pi of the given one.
  Eigen::Vector2d parametersOf(const Eigen::Vector3d& p, double angle) const;
  /// Returns the foot of the perpendicular from the origin onto the plane or the axis.
  Eigen::Vector3d footOfOrigin() const;
  /// Returns whether both are one plane or cylinder up to `distance` (mm), on whichever side the
  /// body is.
  bool isAtPlaceOf(const BodySurface& other, double distance) const;
  /// Returns whether, in addition, the body is on the same side.
  bool isSame(const BodySurface& other) const;
};

struct BodyFace {
  TopoDS_Face shape;
  int surface = 0;
  std::vector<int> edges;
};

/// Returns whether all faces are planes or cylinders and all edges straight or circular.
bool isElementary(const TopoDS_Shape& body);

/// The parts of a body for which isElementary() is true. Closed faces are cut in two. Faces may
/// share a surface.
struct ElementaryBody {
  explicit ElementaryBody(const TopoDS_Shape& body);

  Eigen::Vector3d point(int vertex) const;
  const BodySurface& surfaceOf(int face) const { return surfaces[faces[face].surface]; }
  /// Returns the sine of the angle by which the body is convex at the edge; negative if it is
  /// concave.
  double convexity(const BodyEdge& edge) const;
  /// Returns the unit vector from a point of an edge into a face at the edge.
  Eigen::Vector3d intoFace(const BodyEdge& edge, int f, double u) const;
  /// Returns the range of the kernel's angle on a face of a cylinder.
  Range anglesOf(int f) const;
  /// Returns whether a plane face has an angle of less than 180 degrees at a vertex.
  bool isCorner(int vertex, int f) const;
  /// Other edges sweep no surface of the envelope.
  bool isConvex(const BodyEdge& edge) const;
  /// Returns whether both faces of an edge have the same surface.
  bool isWithinSurface(const BodyEdge& edge) const {
    return faces[edge.faces[0]].surface == faces[edge.faces[1]].surface;
  }

  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape vertices;
  std::vector<BodyEdge> edges;
  std::vector<BodyFace> faces;
  std::vector<BodySurface> surfaces;
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
