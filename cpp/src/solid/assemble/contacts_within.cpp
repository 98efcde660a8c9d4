// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/contacts_within.h"

#include <BOPTools_AlgoTools2D.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>

namespace swept::step {

std::vector<TopoDS_Edge> contactsWithin(const TopoDS_Face& face, const Velocity& velocity,
                                        const std::vector<gp_Pnt>& atBorder) {
  constexpr double kOnCurve = 1e-3;  // mm: faces of files may be less exact than their borders
  std::vector<TopoDS_Edge> within;
  for (const TopoDS_Edge& edge : contactEdges(face, velocity)) {
    double from, to;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    std::vector<double> cuts{from, to};
    for (const gp_Pnt& p : atBorder) {
      const GeomAPI_ProjectPointOnCurve foot(p, curve, from, to);
      if (foot.NbPoints() > 0 && foot.LowerDistance() < kOnCurve)
        cuts.push_back(foot.LowerDistanceParameter());
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const gp_Pnt middle = curve->Value((cuts[i] + cuts[i + 1]) / 2);
      if (curve->Value(cuts[i]).Distance(middle) < Precision::Confusion()) continue;
      const BRepClass_FaceClassifier place(face, middle, Precision::Confusion());
      if (place.State() != TopAbs_IN) continue;
      TopoDS_Edge part = TopoDS::Edge(edge.EmptyCopied());
      BRep_Builder().Range(part, cuts[i], cuts[i + 1]);
      try {
        BOPTools_AlgoTools2D::BuildPCurveForEdgeOnFace(part, face);
        within.push_back(part);
      } catch (const Standard_Failure&) {
        // The kernel cannot project the curve onto the face. Then it does not divide the face.
      }
    }
  }
  return within;
}

}  // namespace swept::step
