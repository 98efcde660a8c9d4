// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/sides.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/assemble/polyhedron.h"
#include "solid/assemble/shape_triangles.h"

namespace swept::step {
namespace {

/// Fractions of the size of the body: how far its triangles may lie from its faces, and how far
/// sample points lie from the face that they judge.
constexpr double kDeflection = 1.0 / 80000, kSampleDistance = 1.0 / 30000;
/// The same for polyhedra, whose triangles are exact, so that only chords of the motion deviate.
constexpr double kFineDeflection = 1e-7, kFineDistance = 1e-6;
constexpr double kAngle = 0.1;  // rad, between adjacent triangles of the body

TriMesh trianglesOf(const TopoDS_Shape& body, double deflection) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(body, Standard_False).Shape();
  return ShapeTriangles(copy, deflection, kAngle).of(copy);
}

double sizeOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

}  // namespace

Sides::Sides(const TopoDS_Shape& body, const Trajectory& trajectory)
    : size_(sizeOf(body)),
      isFine_(isPolyhedron(body)),
      interior_(trianglesOf(body, kDeflection * size_), trajectory,
                (isFine_ ? kFineDeflection : kDeflection) * size_) {}

double Sides::distance() const { return (isFine_ ? kFineDistance : kSampleDistance) * size_; }

double Sides::detail() const { return kSampleDistance * size_; }

void Sides::vote(const FaceSample& sample, Votes& votes) const {
  const gp_Vec off = gp_Vec(sample.normal) * distance();
  const bool before = contains(sample.point.Translated(off));
  const bool behind = contains(sample.point.Translated(-off));
  ++(before ? (behind ? votes.both : votes.before) : (behind ? votes.behind : votes.none));
}

bool Sides::isOnSurface(const TopoDS_Face& face) const {
  constexpr int kSamples = 200;
  const std::vector<FaceSample> samples = samplesOf(face, kSamples);
  return std::any_of(samples.begin(), samples.end(), [&](const FaceSample& sample) {
    Votes votes;
    vote(sample, votes);
    return votes.behind + votes.before > 0;
  });
}

bool Sides::isEdge(const gp_Pnt& p, const gp_Vec& a, const gp_Vec& b) const {
  constexpr double kMinHalfAngle = 0.01;  // of half the angle between both faces
  const double sizes = a.Magnitude() * b.Magnitude();
  if (sizes <= gp::Resolution()) return false;
  const gp_Vec u = a / a.Magnitude(), v = b / b.Magnitude();
  // Samples lie in the middle of each sector, so far from the edge that both faces are at the usual
  // distance.
  const gp_Vec sum = u + v, difference = u - v;
  bool in = false, out = false;
  for (const auto& [middle, across] : {std::pair(sum, difference), std::pair(difference, sum)}) {
    const double sine = std::max(kMinHalfAngle, across.Magnitude() / 2);
    if (middle.Magnitude() < kMinHalfAngle) continue;
    for (const double side : {1.0, -1.0}) {
      const gp_Vec to = middle * (side * distance() / (sine * middle.Magnitude()));
      (contains(p.Translated(to)) ? in : out) = true;
    }
  }
  return in && out;
}

}  // namespace swept::step
