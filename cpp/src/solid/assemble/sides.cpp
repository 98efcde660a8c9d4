// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/assemble/fine_triangles.h"
#include "solid/assemble/solid_of_faces.h"

namespace swept::step {
namespace {

/// Fraction of the size of the body: how finely its sweep is triangulated and measured.
constexpr double kDetail = 1.0 / 30000;
/// How far sample points lie from the face that they judge: at least this fraction of the size of
/// the body, as fitted surfaces are not exact, and at least this multiple of the distance that the
/// body's triangles may lie from the body.
constexpr double kMinDistance = 1e-6, kTimesAccuracy = 8.0 / 3;

SweptInterior interiorOf(const TopoDS_Shape& body, double size, const Trajectory& trajectory) {
  FineTriangles fine = fineTriangles(body, size);
  return {std::move(fine.mesh), trajectory, fine.accuracy};
}

}  // namespace

Sides::Sides(const TopoDS_Shape& body, const Trajectory& trajectory)
    : size_(sizeOf(body)), interior_(interiorOf(body, size_, trajectory)) {}

double Sides::distance() const {
  return std::max(kMinDistance * size_, kTimesAccuracy * accuracy());
}

double Sides::detail() const { return kDetail * size_; }

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

bool Sides::isInSector(const gp_Pnt& p, const gp_Vec& a, const gp_Vec& b, double distance) const {
  constexpr double kThinSector = 0.01;  // sine of half the angle
  const gp_Vec middle = a + b;
  const double sine = std::max(kThinSector, (a - b).Magnitude() / 2);
  return contains(p.Translated(middle * (distance / (sine * middle.Magnitude()))));
}

bool Sides::isEdge(const gp_Pnt& p, const gp_Vec& a, const gp_Vec& b) const {
  constexpr double kFlat = 0.01;  // a sector of nearly 180 degrees has no certain middle
  const double sizes = a.Magnitude() * b.Magnitude();
  if (sizes <= gp::Resolution()) return false;
  const gp_Vec u = a / a.Magnitude(), v = b / b.Magnitude();
  bool in = false, out = false;
  for (const auto& [from, to] :
       {std::pair(u, v), std::pair(-u, -v), std::pair(u, -v), std::pair(-u, v)}) {
    if ((from + to).Magnitude() < kFlat) continue;
    (isInSector(p, from, to, distance()) ? in : out) = true;
  }
  return in && out;
}

}  // namespace swept::step
