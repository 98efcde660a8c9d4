// Tells on which side of a face the swept volume lies, from sample points on both sides of it.
// Units:   mm.
// Cost:    2 queries of swept_interior.h for each sample.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "solid/assemble/face_samples.h"
#include "solid/assemble/swept_interior.h"

namespace swept::step {

/// Where samples of a piece see the swept volume: behind the piece only, before it only (on the
/// side of the normal), on both sides, or on none.
struct Votes {
  int behind = 0, before = 0, both = 0, none = 0;
  int count() const { return behind + before + both + none; }
};

/// Judges on which side of a face the swept volume is.
class Sides {
 public:
  Sides(const TopoDS_Shape& body, const Trajectory& trajectory);

  /// mm: how far sample points lie from the face that they judge.
  double distance() const;
  /// mm: how far the triangles may lie from the body. Nearer to its surface, samples tell nothing.
  double accuracy() const { return interior_.accuracy(); }
  /// mm: how finely surfaces of the swept volume are triangulated and measured.
  double detail() const;
  const SweptInterior& interior() const { return interior_; }
  void vote(const FaceSample& sample, Votes& votes) const;
  /// Returns whether a sample of the face lies on the surface of the swept volume.
  bool isOnSurface(const TopoDS_Face& face) const;
  /// Returns whether the swept volume contains the middle of the sector between two unit vectors at
  /// p. The sample is so far from p that it is at the given distance from both sides of the sector,
  /// unless the sector is very thin.
  bool isInSector(const gp_Pnt& p, const gp_Vec& a, const gp_Vec& b, double distance) const;
  /// Returns whether two faces that intersect at p form an edge of the swept volume: of the four
  /// sectors between them, some lie inside and some outside. `a`, `b`: directions in the faces,
  /// perpendicular to the edge.
  bool isEdge(const gp_Pnt& p, const gp_Vec& a, const gp_Vec& b) const;

 private:
  bool contains(const gp_Pnt& p) const { return interior_.contains({p.X(), p.Y(), p.Z()}); }
  double size_;
  SweptInterior interior_;
};

}  // namespace swept::step
