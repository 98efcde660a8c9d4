// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/require_passed.h"

#include <cstdint>
#include <string>

#include "base/fault_text.h"
#include "base/number_text.h"

namespace swept {

void requirePassed(const MeshCheck& check, const char* what, double cell) {
  if (check.passes()) return;
  std::string text = textOf(3, what, " failed the final check of the mesh, so it is not returned:");
  const char* before = " ";
  const auto addFault = [&](std::int64_t count, const char* fault) {
    if (count == 0) return;
    text += textOf(3, before, count, " ", fault);
    before = ", ";
  };
  addFault(check.openEdges, "open edges");
  addFault(check.nonManifoldEdges, "non-manifold edges");
  addFault(check.nonManifoldVertices, "non-manifold vertices");
  addFault(check.misorientedEdges, "misoriented edges");
  addFault(check.degenerateTriangles, "degenerate triangles");
  if (!check.finite) text += textOf(3, before, "coordinates that are not finite");
  if (check.finite && check.closed && !check.oriented && check.misorientedEdges == 0) {
    text += textOf(3, before, "some of the ", check.shells, " shells are inside out");
  }
  text += textOf(3, faultText("the part, the motion and the options"),
                 ". Another cell size usually avoids the fault: try ", 0.9 * cell,
                 " mm instead of ", cell, ", or repair the part where it intersects itself");
  throw Error(Status::InternalError, "CheckFailed", text);
}

}  // namespace swept
