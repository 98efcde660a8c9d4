// Cuts long faces into parts, along lines on which one of their parameters is constant.
// In:      faces that share their edges.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

namespace swept::step {

/// Returns copies of the faces, each cut into as many parts as `counts` says. They share their
/// edges. A face that the kernel cannot cut stays in one part.
std::vector<TopoDS_Face> cutAcross(const std::vector<TopoDS_Face>& faces,
                                   const std::vector<int>& counts);

/// Returns the length of a face along its longer parameter.
double lengthOf(const TopoDS_Face& face);

}  // namespace swept::step
