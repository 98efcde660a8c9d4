// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/cut_across.h"

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>

#include "solid/assemble/divide_faces.h"
#include "solid/carrier/bspline.h"

namespace swept::step {
namespace {

struct Extents {
  std::array<Range, 2> range;    // of the parameters u and v
  std::array<double, 2> length;  // mm, along the middle
  int longer() const { return length[1] > length[0] ? 1 : 0; }
};

Extents extentsOf(const TopoDS_Face& face) {
  constexpr int kChords = 16;
  Extents extents{};
  BRepTools::UVBounds(face, extents.range[0].from, extents.range[0].to, extents.range[1].from,
                      extents.range[1].to);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  for (const int along : {0, 1}) {
    const auto at = [&](int i) {
      std::array<double, 2> on{extents.range[0].at(0.5), extents.range[1].at(0.5)};
      on[along] = extents.range[along].at(static_cast<double>(i) / kChords);
      return surface->Value(on[0], on[1]);
    };
    for (int i = 0; i < kChords; ++i) extents.length[along] += at(i).Distance(at(i + 1));
  }
  return extents;
}

// Appends the parts of a line of constant u (0) or v (1) inside a face.
void appendLine(const TopoDS_Face& face, int f, int constant, double value, const Range& along,
                std::vector<SweptSection>& to) {
  constexpr double kShortestLine = 1e-4;  // mm
  const gp_Pnt2d start = constant == 0 ? gp_Pnt2d(value, 0) : gp_Pnt2d(0, value);
  const gp_Dir2d direction = constant == 0 ? gp_Dir2d(0, 1) : gp_Dir2d(1, 0);
  const Handle(Geom2d_Line) line = new Geom2d_Line(start, direction);
  const Range wide = along.grown(0.1);
  const Handle(Geom2d_TrimmedCurve) across = new Geom2d_TrimmedCurve(line, wide.from, wide.to);
  std::vector<double> crossings;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double from, end;
    const Handle(Geom2d_Curve) border =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, from, end);
    if (border.IsNull()) continue;
    const Geom2dAPI_InterCurveCurve crossing(across, new Geom2d_TrimmedCurve(border, from, end),
                                             Precision::PConfusion());
    for (int i = 1; i <= crossing.NbPoints(); ++i)
      crossings.push_back(crossing.Intersector().Point(i).ParamOnFirst());
  }
  std::sort(crossings.begin(), crossings.end());
  const BRepTopAdaptor_FClass2d inside(face, Precision::PConfusion());
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const Handle(Geom_Curve) curve = constant == 0 ? surface->UIso(value) : surface->VIso(value);
  const BRep_Builder builder;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const Range part{crossings[i], crossings[i + 1]};
    if (inside.Perform(line->Value(part.at(0.5))) != TopAbs_IN ||
        curve->Value(part.from).Distance(curve->Value(part.to)) < kShortestLine)
      continue;
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, Precision::Confusion());
    builder.Range(edge, part.from, part.to);
    builder.UpdateEdge(edge, line, face, Precision::Confusion());
    to.push_back({edge, {f}});
  }
}

}  // namespace

double lengthOf(const TopoDS_Face& face) {
  const Extents extents = extentsOf(face);
  return extents.length[extents.longer()];
}

std::vector<TopoDS_Face> cutAcross(const std::vector<TopoDS_Face>& faces,
                                   const std::vector<int>& counts) {
  constexpr double kNear = 1e-6;  // mm
  std::vector<SweptSection> lines;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (counts[f] < 2) continue;
    const Extents extents = extentsOf(faces[f]);
    const int longer = extents.longer();
    for (int i = 1; i < counts[f]; ++i) {
      const double value = extents.range[longer].at(static_cast<double>(i) / counts[f]);
      appendLine(faces[f], static_cast<int>(f), longer, value, extents.range[1 - longer], lines);
    }
  }
  std::vector<TopoDS_Face> parts;
  const TopoDS_Shape divided = divideFaces(faces, lines, kNear);
  for (TopExp_Explorer it(divided, TopAbs_FACE); it.More(); it.Next())
    parts.push_back(TopoDS::Face(it.Current()));
  return parts;
}

}  // namespace swept::step
