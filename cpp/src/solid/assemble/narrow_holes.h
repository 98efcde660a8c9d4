// Fills narrow holes, and holes with a plane border, with few faces.
// In:      the open edges of faces.
// Out:     a plane face if all edges of a hole lie in one plane; else, if the hole is narrow, a
//          face on a Coons patch. A hole with more than four edges is cut in several by straight
//          edges. All faces use the open edges.
// Units:   mm.
// Cost:    some milliseconds per filling.
// Note:    Whether a filling lies on the surface of the swept volume is for the caller to test.
// Source:  S. Coons, Surfaces for computer-aided design of space forms (1967).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <set>
#include <vector>

#include "solid/assemble/open_edges.h"

namespace swept::step {

class NarrowHoles {
 public:
  /// Returns fillings for those holes whose edges form a simple loop, unless all these edges were
  /// given before. Holes for which the kernel accepts no faces have none. `maxWidth`: mm, twice the
  /// area divided by the length of the border, if the border is not plane.
  std::vector<TopoDS_Face> fill(const std::vector<OpenEdge>& open, double maxWidth);

 private:
  std::set<const void*> tried_;  // edges
};

}  // namespace swept::step
