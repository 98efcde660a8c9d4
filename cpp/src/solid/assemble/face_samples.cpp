// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/face_samples.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Vec.hxx>

namespace swept::step {

std::vector<FaceSample> samplesOf(const TopoDS_Face& face, int count) {
  std::vector<FaceSample> samples;
  const BRepAdaptor_Surface surface(face, Standard_False);
  const auto add = [&](double u, double v) {
    gp_Pnt point;
    gp_Vec alongU, alongV;
    surface.D1(u, v, point, alongU, alongV);
    gp_Vec normal = alongU.Crossed(alongV);
    if (normal.Magnitude() <= gp::Resolution()) return;
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    samples.push_back({point, gp_Dir(normal), {u, v}});
  };
  const Handle(IntTools_Context) context = new IntTools_Context;
  gp_Pnt point;
  gp_Pnt2d inside;
  if (BOPTools_AlgoTools3D::PointInFace(face, point, inside, context) == 0)
    add(inside.X(), inside.Y());
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const BRepTopAdaptor_FClass2d border(face, Precision::PConfusion());
  const int side = std::max(2, static_cast<int>(std::sqrt(count)));
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const gp_Pnt2d at(u0 + (u1 - u0) * (i + 0.5) / side, v0 + (v1 - v0) * (j + 0.5) / side);
      if (border.Perform(at) == TopAbs_IN) add(at.X(), at.Y());
    }
  }
  return samples;
}

}  // namespace swept::step
