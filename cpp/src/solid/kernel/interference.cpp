// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/interference.h"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BOPAlgo_CheckResult.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Edge.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <unordered_map>

#include "base/sort_unique.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

/// Distance in mm; faces nearer than this may touch.
constexpr double kNear = 1e-5;

// Returns points along the borders of a face. The interior of a curved face may lie outside the box
// of these points, but by less than the size of the box. The callers add a margin for that.
std::vector<Vector3d> pointsOf(const Model& model, const ModelFace& face) {
  constexpr int kSteps = 8;
  std::vector<Vector3d> points;
  for (const auto& loop : face.loops) {
    for (const ModelUse& use : loop) {
      const Curve& curve = model.edges[use.edge].curve;
      const int steps = curve.kind == CurveKind::Line ? 1 : kSteps;
      for (int i = 0; i <= steps; ++i) points.push_back(curve.at(curve.last * i / steps));
    }
  }
  return points;
}

struct Recognised {
  const Carrier* surface;
  Box box;
};

// Returns whether a face with these points may meet a recognised face. It cannot if their boxes do
// not intersect, or if all its points lie on one side of the recognised surface.
bool mayMeet(const std::vector<Vector3d>& points, const Box& box, const Recognised& recognised) {
  if (!box.intersects(recognised.box)) return false;
  const double size = box.diagonal().norm();
  double low = 1e300, high = -1e300;
  for (const Vector3d& p : points) {
    const double d = recognised.surface->distance(p);
    low = std::min(low, d);
    high = std::max(high, d);
  }
  const double slack = recognised.surface->isPlanar() ? kNear : 0.5 * size + kNear;
  return low <= slack && high >= -slack;
}

std::vector<std::int32_t> facesNearPatches(const Model& model) {
  std::vector<std::vector<Vector3d>> points;
  std::vector<Box> boxes;
  std::vector<Recognised> all;
  for (const ModelFace& face : model.faces) {
    points.push_back(pointsOf(model, face));
    Box box;
    for (const Vector3d& p : points.back()) box.extend(p);
    const double slack = face.surface.isPlanar() ? kNear : 0.3 * box.diagonal().norm() + kNear;
    box.min().array() -= slack;
    box.max().array() += slack;
    boxes.push_back(box);
    if (face.surface.kind != CarrierKind::Facet) all.push_back({&face.surface, box});
  }
  std::vector<std::int32_t> near;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const bool isNear = std::any_of(all.begin(), all.end(), [&](const Recognised& other) {
      return mayMeet(points[f], boxes[f], other);
    });
    if (isNear) near.push_back(static_cast<std::int32_t>(f));
  }
  return near;
}

}  // namespace

std::vector<std::int32_t> findInterfering(const Model& model, const Brep& brep, RunContext& run) {
  const std::vector<std::int32_t> near = facesNearPatches(model);
  if (near.empty()) return {};
  run.checkpoint(Phase::Export);
  TopoDS_Compound faces;
  const BRep_Builder builder;
  builder.MakeCompound(faces);
  std::unordered_map<const TopoDS_TShape*, std::vector<std::int32_t>> owners;
  for (const std::int32_t f : near) {
    builder.Add(faces, brep.faces[f]);
    owners[brep.faces[f].TShape().get()].push_back(f);
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX}) {
      for (TopExp_Explorer it(brep.faces[f], kind); it.More(); it.Next())
        owners[it.Current().TShape().get()].push_back(f);
    }
  }
  BOPAlgo_ArgumentAnalyzer analyzer;
  analyzer.SetShape1(faces);
  analyzer.SelfInterMode() = true;
  analyzer.SetRunParallel(true);
  analyzer.Perform();
  std::vector<std::int32_t> found;
  for (const BOPAlgo_CheckResult& result : analyzer.GetCheckResult()) {
    for (const TopoDS_Shape& part : result.GetFaultyShapes1()) {
      const auto it = owners.find(part.TShape().get());
      if (it != owners.end()) found.insert(found.end(), it->second.begin(), it->second.end());
    }
  }
  sortUnique(found);
  return found;
}

bool doesIntersectItself(const TopoDS_Shape& shape, const Message_ProgressRange& progress) {
  BOPAlgo_ArgumentAnalyzer analyzer;
  analyzer.SetShape1(shape);
  analyzer.SelfInterMode() = true;
  analyzer.StopOnFirstFaulty() = true;
  analyzer.SetRunParallel(true);
  analyzer.Perform(progress);
  return analyzer.HasFaulty();
}

std::vector<EdgeCut> findEdgesOffFaces(const Model& model, const Brep& brep) {
  std::vector<std::vector<std::int32_t>> faces(model.edges.size());
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (model.faces[f].surface.isPlanar()) continue;
    for (const auto& loop : model.faces[f].loops) {
      for (const ModelUse& use : loop) faces[use.edge].push_back(static_cast<std::int32_t>(f));
    }
  }
  std::vector<EdgeCut> found;
  for (std::size_t e = 0; e < faces.size(); ++e) {
    if (faces[e].empty() || brep.edges[e].IsNull()) continue;
    const TopoDS_Edge& edge = brep.edges[e];
    double seen = 0, largest = 0, at = 0;
    ShapeAnalysis_Edge().CheckSameParameter(edge, seen);
    for (const std::int32_t f : faces[e]) {
      double distance = 0, where = 0;
      if (!BOPTools_AlgoTools::ComputeTolerance(TopoDS::Face(brep.faces[f]), edge, distance,
                                                where) ||
          distance <= largest)
        continue;
      largest = distance;
      at = where;
    }
    if (largest > std::max(seen, Precision::Confusion()))
      found.push_back({static_cast<std::int32_t>(e), at});
  }
  return found;
}

}  // namespace swept::step
