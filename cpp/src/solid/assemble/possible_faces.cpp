// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/possible_faces.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "solid/assemble/face_samples.h"
#include "solid/assemble/solid_of_faces.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;

/// Of a condition.
constexpr double kRounding = 1e-7;

// `dividers`: curves on the face.
bool isPossible(const SweptFace& face, const std::vector<TopoDS_Edge>& dividers) {
  constexpr int kSamples = 400, kBorderSamples = 64, kDividerSamples = 16;
  std::vector<Vector2d> points;
  for (const FaceSample& sample : samplesOf(face.face, kSamples))
    points.emplace_back(sample.on.X(), sample.on.Y());
  // The part that may be on the envelope is often a small corner of the face.
  for (TopExp_Explorer it(face.face, TopAbs_EDGE); it.More(); it.Next()) {
    double from, to;
    const Handle(Geom2d_Curve) border =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face.face, from, to);
    if (border.IsNull()) return true;
    for (int i = 0; i <= kBorderSamples; ++i) {
      const gp_Pnt2d p = border->Value(from + (to - from) * i / kBorderSamples);
      points.emplace_back(p.X(), p.Y());
    }
  }
  if (std::any_of(points.begin(), points.end(),
                  [&](const Vector2d& p) { return face.isPossible(p, 0); }))
    return true;
  // It may be a narrow strip between two dividers.
  points.clear();
  for (const TopoDS_Edge& divider : dividers) {
    double from, to;
    const Handle(Geom2d_Curve) on = BRep_Tool::CurveOnSurface(divider, face.face, from, to);
    for (int i = 0; i <= kDividerSamples && !on.IsNull(); ++i) {
      const gp_Pnt2d p = on->Value(from + (to - from) * i / kDividerSamples);
      points.emplace_back(p.X(), p.Y());
    }
  }
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector2d& p) { return face.isPossible(p, kRounding); });
}

// Returns by how much a piece fails to meet its worst condition. Each condition has one sign on the
// whole piece, except for errors of its border.
double violationOf(const TopoDS_Face& piece, const std::vector<Condition>& conditions) {
  constexpr int kSamples = 25;
  const std::vector<FaceSample> samples = samplesOf(piece, kSamples);
  if (samples.empty()) return 0;
  double worst = 0;
  for (const Condition& condition : conditions) {
    double sum = 0;
    for (const FaceSample& sample : samples) sum += condition({sample.on.X(), sample.on.Y()});
    worst = std::max(worst, -sum / static_cast<double>(samples.size()));
  }
  return worst;
}

// Keeps the curves on faces that have a number, and replaces the indices of the faces by these.
void renumber(std::vector<SweptSection>& curves, const std::vector<int>& numbers) {
  for (SweptSection& curve : curves) {
    std::vector<int> faces;
    for (const int f : curve.faces) {
      if (numbers[f] >= 0) faces.push_back(numbers[f]);
    }
    curve.faces = std::move(faces);
  }
  curves.erase(std::remove_if(curves.begin(), curves.end(),
                              [](const SweptSection& curve) { return curve.faces.empty(); }),
               curves.end());
}

}  // namespace

void dropImpossible(TurningFaces& made) {
  const std::size_t count = made.faces.size();
  std::vector<std::vector<TopoDS_Edge>> dividers(count);
  for (const SweptSection& divider : made.dividers) {
    for (const int f : divider.faces) dividers[f].push_back(divider.edge);
  }
  std::vector<char> isKept(count, 0);
  parallelBlocks(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) isKept[i] = isPossible(made.faces[i], dividers[i]);
  });
  std::vector<int> numbers(count, -1);
  std::vector<SweptFace> kept;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isKept[i]) continue;
    numbers[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(made.faces[i]));
  }
  made.faces = std::move(kept);
  renumber(made.dividers, numbers);
  renumber(made.folds, numbers);
}

PossiblePieces possiblePieces(const TopoDS_Shape& pieces, const std::vector<SweptFace>& faces) {
  constexpr double kUnlikely = 1e-3;
  // Pieces have the surface of their face.
  std::map<const Geom_Surface*, const std::vector<Condition>*> conditions;
  for (const SweptFace& face : faces)
    conditions[BRep_Tool::Surface(face.face).get()] = &face.conditions;
  PossiblePieces result;
  std::vector<TopoDS_Face> kept;
  for (TopExp_Explorer it(pieces, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& piece = TopoDS::Face(it.Current());
    const auto found = conditions.find(BRep_Tool::Surface(piece).get());
    const double violation = found == conditions.end() ? 0 : violationOf(piece, *found->second);
    if (violation > kUnlikely) continue;
    if (violation > kRounding) result.unlikely.Add(piece);
    kept.push_back(piece);
  }
  result.shape = compoundOf(kept);
  return result;
}

}  // namespace swept::step
