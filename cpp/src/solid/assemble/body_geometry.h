// The faces and edges of a moving body, and the body at a pose. Planes, cylinders, cones,
// spheres and tori are known by their formulas, other surfaces only by their parameters.
// Units:   mm, rad, in coordinates of the body whose origin is the pivot.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
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

/// Returns the angle plus whole turns, within pi of another one.
double angleNear(double other, double angle);

struct BodyEdge {
  TopoDS_Edge shape;
  int from = 0, to = 0;  ///< vertices
  Handle(Geom_Curve) curve;
  Range range;  ///< of the parameter: mm on a line, rad on a circle
  /// By face: the edge in the parameters of its surface, for surfaces without a formula.
  std::array<Handle(Geom2d_Curve), 2> onFaces;
  bool isStraight = true;
  double scale = 1;  ///< mm per unit of the parameter
  std::array<int, 2> faces{-1, -1};
  Eigen::Vector3d at(double u) const;
  Eigen::Vector3d tangent(double u) const;  ///< unit vector
};

struct BodySurface {
  enum class Kind { Plane, Cylinder, Cone, Torus, Other };
  Kind kind = Kind::Plane;
  /// Only for other surfaces, which have none of the members below, except for `outward`.
  Handle(Geom_Surface) shape;
  /// A point of the plane, or of the axis: of a torus, its centre.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /// Orthogonal unit vectors; `axis`: normal of the plane.
  Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                  axis = Eigen::Vector3d::UnitZ();
  double radius = 0;  ///< of a cone, at `origin`; of a torus, from the axis to the tube
  double slope = 0;   ///< rad: angle between a cone and its axis
  double tube = 0;    ///< radius of the tube of a torus; a sphere is a torus with radius 0
  /// -1 if `axis`, or the direction away from it, or the normal of `shape` points into the body
  double outward = 1;

  bool isPlane() const { return kind == Kind::Plane; }
  bool isCylinder() const { return kind == Kind::Cylinder; }
  /// Returns the unit vector from the axis to a point.
  Eigen::Vector3d awayFromAxis(const Eigen::Vector3d& p) const;
  /// Returns the unit vector that points away from the body.
  Eigen::Vector3d normalAt(const Eigen::Vector3d& p) const;
  /// mm, along `axis`, or away from it.
  double distanceTo(const Eigen::Vector3d& p) const;
  /// Returns the kernel's parameters of a point of the surface. Angles are within pi of those
  /// given.
  Eigen::Vector2d parametersOf(const Eigen::Vector3d& p, const Eigen::Vector2d& near) const;
  /// Returns the foot of the perpendicular from the origin onto the plane or the axis.
  Eigen::Vector3d footOfOrigin() const;
  /// Returns whether both are one surface up to `distance` (mm), on whichever side the body is.
  bool isAtPlaceOf(const BodySurface& other, double distance) const;
  /// Returns whether, in addition, the body is on the same side.
  bool isSame(const BodySurface& other) const;
};

struct BodyFace {
  TopoDS_Face shape;
  int surface = 0;  ///< of the body; other faces on it may have other parameters
  BodySurface own;  ///< with the parameters of this face
  std::vector<int> edges;
  Eigen::AlignedBox2d range;  ///< of the kernel's parameters
  std::shared_ptr<const BRepTopAdaptor_FClass2d> border;
};

/// The parts of a body. Closed faces are cut in two. Faces may share a surface.
struct BodyGeometry {
  explicit BodyGeometry(const TopoDS_Shape& body);

  Eigen::Vector3d point(int vertex) const;
  const BodySurface& surfaceOf(int face) const { return faces[face].own; }
  /// Returns the unit vector that points away from the body, on a face at its edge. Zero where the
  /// surface has no normal.
  Eigen::Vector3d normalAt(const BodyEdge& edge, int f, double u) const;
  /// Returns the sine of the angle by which the body is convex at the edge; negative if it is
  /// concave.
  double convexity(const BodyEdge& edge) const;
  /// Returns the unit vector from a point of an edge into a face at the edge.
  Eigen::Vector3d intoFace(const BodyEdge& edge, int f, double u) const;
  /// Returns the range of the kernel's angle around the axis on a face.
  Range anglesOf(int f) const;
  /// Returns between which positions along a unit vector the faces of a surface lie (mm from a
  /// point).
  Range extentOf(int surface, const Eigen::Vector3d& origin, const Eigen::Vector3d& along) const;
  /// Returns whether a point of the surface of a face is inside or outside of the face, or on its
  /// border. (The kernel's classifier for points in space cannot be used: it classifies a foot of
  /// the point on the face, however far that is. So a point is inside of both halves of a
  /// cylinder.)
  TopAbs_State placeOf(int f, const Eigen::Vector3d& p) const;
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
    return TopoDS::Face(maker_->ModifiedShape(face.shape).Oriented(face.shape.Orientation()));
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
