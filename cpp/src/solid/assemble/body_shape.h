// The faces and edges of a moving body, as the kernel read them from a STEP or BREP file. Other
// rooms hold a BodyShape by pointer (swept/solid.h) and cannot look inside.
// Units:   mm, in coordinates of the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace swept {

struct BodyShape {
  TopoDS_Shape shape;
};

}  // namespace swept
