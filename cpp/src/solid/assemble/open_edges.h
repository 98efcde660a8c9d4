// The edges of faces that only one of the faces uses.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

namespace swept::step {

struct OpenEdge {
  TopoDS_Edge edge;       ///< forward
  int face = 0;           ///< index of the face that uses it
  bool isForward = true;  ///< as the face uses it
};

/// Removes the faces that are not marked. Returns whether there were any.
bool keepMarked(std::vector<TopoDS_Face>& faces, const std::vector<char>& isMarked);

/// Returns the open edges of the faces. Faces at an edge that more than two faces use, or two in
/// the same direction, are removed from `faces` first.
std::vector<OpenEdge> openEdgesOf(std::vector<TopoDS_Face>& faces);

}  // namespace swept::step
