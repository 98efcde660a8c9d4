// Points inside a face, with the normal of the face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace swept::step {

struct FaceSample {
  gp_Pnt point;
  gp_Dir normal;  ///< with the orientation of the face
  gp_Pnt2d on;    ///< parameters
};

/// Returns points inside the face: those of a grid of about `count` points over its parameters, and
/// one that the kernel finds. May be empty for a face that is as narrow as the kernel's tolerance.
std::vector<FaceSample> samplesOf(const TopoDS_Face& face, int count);

}  // namespace swept::step
