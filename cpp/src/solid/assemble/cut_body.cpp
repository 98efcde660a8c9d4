// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/cut_body.h"

#include <BOPAlgo_Builder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "solid/assemble/face_samples.h"

namespace swept::step {
namespace {

// Returns the parts of the edges that divide the face, without its border.
void appendInner(const TopoDS_Face& face, const std::vector<TopoDS_Edge>& edges,
                 TopTools_ListOfShape& inner) {
  BOPAlgo_Builder cutter;
  TopTools_ListOfShape all;
  all.Append(face);
  for (const TopoDS_Edge& edge : edges) all.Append(edge);
  cutter.SetArguments(all);
  cutter.SetNonDestructive(Standard_True);
  cutter.Perform();
  if (cutter.HasErrors()) return;
  TopTools_IndexedMapOfShape dividing;
  for (const TopoDS_Shape& part : cutter.Modified(face))
    TopExp::MapShapes(part, TopAbs_EDGE, dividing);
  TopTools_MapOfShape border;
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(face, TopAbs_EDGE, own);
  for (int i = 1; i <= own.Extent(); ++i) {
    for (const TopoDS_Shape& part : cutter.Modified(own(i))) border.Add(part);
  }
  const auto take = [&](const TopoDS_Shape& part) {
    if (dividing.Contains(part) && !border.Contains(part)) inner.Append(part);
  };
  for (const TopoDS_Edge& edge : edges) {
    const TopTools_ListOfShape& parts = cutter.Modified(edge);
    if (parts.IsEmpty()) take(edge);
    for (const TopoDS_Shape& part : parts) take(part);
  }
}

}  // namespace

TopoDS_Compound cutAtContact(const TopoDS_Shape& shape, const Velocity& velocity,
                             const Message_ProgressRange& progress) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopTools_ListOfShape arguments;
  arguments.Append(shape);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face& face = TopoDS::Face(faces(i));
    const std::vector<TopoDS_Edge> edges = contactEdges(face, velocity);
    if (!edges.empty()) appendInner(face, edges, arguments);
  }
  const BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  if (arguments.Size() == 1) {
    for (int i = 1; i <= faces.Extent(); ++i) builder.Add(result, faces(i));
    return result;
  }
  BOPAlgo_Builder cutter;
  cutter.SetArguments(arguments);
  cutter.SetNonDestructive(Standard_True);
  cutter.SetRunParallel(Standard_True);
  cutter.Perform(progress);
  if (cutter.HasErrors()) return {};
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopTools_ListOfShape& parts = cutter.Modified(faces(i));
    if (parts.IsEmpty()) builder.Add(result, faces(i));
    for (const TopoDS_Shape& part : parts)
      builder.Add(result, part.Oriented(faces(i).Orientation()));
  }
  return result;
}

int sideOf(const TopoDS_Face& face, const Velocity& velocity) {
  constexpr int kSamples = 100;
  double sum = 0, largest = 0;
  for (const FaceSample& sample : samplesOf(face, kSamples)) {
    const gp_Vec v = velocity(sample.point);
    if (v.Magnitude() <= gp::Resolution()) continue;
    const double sine = gp_Vec(sample.normal).Dot(v) / v.Magnitude();
    sum += sine;
    largest = std::max(largest, std::abs(sine));
  }
  if (largest < 10 * kSliding) return 0;
  return sum > 0 ? 1 : -1;
}

}  // namespace swept::step
