// Divides faces along edges that are known to lie on them. Unlike the general fuse of the kernel,
// it computes no intersections, so nearly tangent faces are no problem.
// In:      faces that share their edges; sections with the faces on which they lie. Sections may
//          end on edges and vertices of faces, and at each other, but do not cross.
// Out:     the pieces of the faces. They share their edges. Sections that do not divide a face are
//          left out.
// Units:   mm.
// Cost:    O(edges times ends of sections), about 1 ms for each piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace swept::step {

struct SweptSection {
  TopoDS_Edge edge;
  /// Indices of the faces on which it lies. Its curves in the parameters of these faces are used,
  /// if it has any.
  std::vector<int> faces;
};

/// mm: bodies from files may be less exact than their caller says. In the leg of a robot, with
/// edges up to 7e-4 mm off their faces, ends that belong together are up to 3.5e-4 mm apart. So the
/// distance within which they are one follows the worst vertex of the body, up to this value.
constexpr double kMaxNear = 5e-4;

/// Returns the distance (mm) within which divideFaces() joins ends: `near`, or more if the faces
/// are less exact.
double joiningDistance(const std::vector<TopoDS_Face>& faces, double near);

/// Returns a compound of the pieces; the given faces stay as they are. A face that the kernel
/// cannot divide stays in one piece. `near`: mm, the end of a section is moved to a vertex or an
/// edge that is nearer than this, or nearer than twice the tolerance of the vertex or edge. May
/// throw Standard_Failure.
TopoDS_Shape divideFaces(const std::vector<TopoDS_Face>& faces,
                         const std::vector<SweptSection>& sections, double near);

}  // namespace swept::step
