// The pieces into which the faces of a sweep cut each other, and which of them bound the swept
// volume. Sample points on both sides of a piece vote (assemble.h describes the method).
// Units:   mm.
// Cost:    some 20 queries of swept_interior.h for each piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "solid/assemble/chains.h"
#include "solid/assemble/sides.h"

namespace swept::step {

/// The pieces into which all faces cut each other.
class Pieces {
 public:
  /// `unlikely`: pieces that are chosen only if they close the surface.
  Pieces(const TopoDS_Shape& fused, const Sides& sides, const TopTools_MapOfShape& unlikely = {});

  /// Returns the faces that bound the swept volume, their normals away from it: those of the cells
  /// that the pieces enclose and that lie inside. Empty if the pieces enclose nothing.
  std::vector<TopoDS_Face> aroundCells() const;

  /// Returns the pieces that most samples see on the surface of the swept volume, with their
  /// normals away from it.
  std::vector<TopoDS_Face> chosen() const { return turnedFaces(chosen_); }

  /// Returns whether all samples of each chosen piece agree, unless the piece is narrow.
  bool areCertain() const;

  /// Returns the chosen pieces without those that samples doubt at edges that do not have two of
  /// them. What remains need not be closed.
  std::vector<TopoDS_Face> certain() const;

  /// Tries to close the surface without thin pieces, although samples see the swept volume on one
  /// side of them: a groove may be so thin that its other walls were not found.
  void fillGrooves();
  /// mm: after fillGrooves(), the largest width of a piece that was chosen, or not chosen, against
  /// the samples; 0 if there is none.
  double filled() const { return filled_; }

  /// Returns the pieces, those at the edges one by one, the others together.
  TopTools_ListOfShape looseNear(const std::vector<TopoDS_Edge>& edges) const;

  /// Returns the edges of chosen pieces that do not have two of them.
  std::vector<TopoDS_Edge> openEdges() const;

 private:
  TopoDS_Face face(int f) const { return TopoDS::Face(faces_(f)); }

  // Returns the marked pieces, with their normals away from the swept volume.
  std::vector<TopoDS_Face> turnedFaces(const std::vector<char>& pieces) const;

  Votes votesOf(const std::vector<FaceSample>& samples) const;
  // Returns samples of a piece that are not next to its border.
  std::vector<FaceSample> samplesInside(const TopoDS_Face& piece) const;

  bool isInside(const TopoDS_Shape& cell) const;

  // Returns how often chosen pieces use the edge.
  int uses(int e) const { return uses(e, chosen_); }
  int uses(int e, const std::vector<char>& pieces) const;

  // Returns the edges that a piece uses an odd number of times.
  Chain borderOf(int f) const;

  // Chooses pieces by their votes. The samples cannot judge pieces that are narrower than their
  // distance. So some choices are inverted, to close the surface.
  void choose(const TopTools_MapOfShape& unlikely);
  // Inverts the choice of some of the pieces, so that as few edges as possible are open. Prefers
  // pieces at the front.
  void closeWith(const std::vector<int>& doubtful);
  // Returns the parts of a chain that have no common vertex.
  std::vector<Chain> connectedParts(const Chain& edges) const;
  // Drops pieces that form a closed surface on their own.
  void dropBubbles(const std::vector<int>& doubtful);
  // Orients narrow pieces as their neighbours are oriented.
  void orient();

  // Returns how a chosen piece, turned as it is now, uses the edge.
  TopAbs_Orientation orientationIn(int f, int e) const;

  void measure(int f);
  // Returns whether most samples see the swept volume on one side only.
  bool hasSide(int f) const;
  bool isUnanimous(int f) const;
  // Returns whether the samples may be wrong.
  bool isDoubtful(int f) const { return !isUnanimous(f) || narrow_[f]; }

  const TopoDS_Shape fused_;
  const Sides& sides_;
  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_;
  // By piece, from 1:
  std::vector<Votes> votes_;
  std::vector<double> area_;   // mm^2
  std::vector<double> width_;  // mm, if it is much longer than wide
  std::vector<char> narrow_;   // whether it is narrow, compared with the distance of the samples
  std::vector<char> chosen_, turned_;
  std::vector<char> byVotes_;  // the first choice
  std::vector<int> doubtful_;  // pieces whose choice may be inverted; the first are preferred
  double filled_ = 0;
};

}  // namespace swept::step
