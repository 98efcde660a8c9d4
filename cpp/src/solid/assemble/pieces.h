// The pieces into which the faces of a sweep cut each other, and which of them bound the swept
// volume. Sample points on both sides of a piece vote (assemble.h describes the method).
// Units:   mm.
// Cost:    some 20 queries of swept_interior.h for each piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

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
  void vote(const FaceSample& sample, Votes& votes) const;
  /// Returns whether a sample of the face lies on the surface of the swept volume.
  bool isOnSurface(const TopoDS_Face& face) const;

 private:
  bool contains(const gp_Pnt& p) const { return interior_.contains({p.X(), p.Y(), p.Z()}); }
  double size_;
  SweptInterior interior_;
};

/// The pieces into which all faces cut each other.
class Pieces {
 public:
  Pieces(const TopoDS_Shape& fused, const Sides& sides);

  /// Returns the faces that bound the swept volume, their normals away from it: those of the cells
  /// that the pieces enclose and that lie inside. Empty if the pieces enclose nothing.
  std::vector<TopoDS_Face> aroundCells() const;

  /// Returns the pieces that most samples see on the surface of the swept volume, with their
  /// normals away from it.
  std::vector<TopoDS_Face> chosen() const;

  /// Returns the pieces, those at the edges one by one, the others together.
  TopTools_ListOfShape looseNear(const std::vector<TopoDS_Edge>& edges) const;

  /// Returns the edges of chosen pieces that do not have two of them.
  std::vector<TopoDS_Edge> openEdges() const;

 private:
  TopoDS_Face face(int f) const { return TopoDS::Face(faces_(f)); }

  bool isInside(const TopoDS_Shape& cell) const;

  // Returns how often chosen pieces use the edge. `flipped`: a piece whose choice is inverted.
  int uses(int e, int flipped = 0) const;

  int openEdgesOf(int f, bool isFlipped) const;

  // Chooses pieces by their votes. The samples cannot judge pieces that are narrower than their
  // distance. So choices are inverted where this leaves fewer open edges.
  void choose();

  bool isDoubtful(int f) const;

  const TopoDS_Shape fused_;
  const Sides& sides_;
  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_;
  std::vector<Votes> votes_;  // by piece, from 1
  std::vector<char> chosen_;
};

}  // namespace swept::step
