// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/facet_filling.h"

#include <BOPTools_AlgoTools.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/nearest_triangle.h"
#include "geometry/self_intersections.h"
#include "solid/assemble/exact_sections.h"
#include "solid/assemble/hole_facets.h"
#include "solid/assemble/hole_triangles.h"
#include "solid/assemble/open_edges.h"
#include "solid/assemble/shape_triangles.h"
#include "solid/assemble/solid_of_faces.h"
#include "solid/assemble/sweep_deviation.h"
#include "solid/mesh/decimate.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Limit of thinning before the mesh is cut, as a fraction of the tolerance.
constexpr double kThinFirst = 0.05;
/// If the faces have less of the area than this, the solid is not worth the time.
constexpr double kMinFraction = 0.4;

// Returns triangles of all faces, TriMesh::faceOf with their indices.
TriMesh trianglesOf(const std::vector<TopoDS_Face>& faces, double deflection) {
  constexpr double kAngle = 0.9;  // rad; the deflection demands more
  const TopoDS_Compound all = compoundOf(faces);
  return ShapeTriangles(all, deflection, kAngle).of(all);
}

void markInvalid(const std::vector<TopoDS_Face>& faces, std::vector<char>& isMarked) {
  constexpr double kMaxTolerance = 1e-4;  // mm
  const TopTools_IndexedMapOfShape none;
  BOPTools_AlgoTools::CorrectTolerances(compoundOf(faces), none, kMaxTolerance);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!BRepCheck_Analyzer(faces[f]).IsValid()) isMarked[f] = 1;
  }
}

// Marks faces whose triangles intersect those of another face, or of itself.
void markIntersecting(const TriMesh& apart, RunContext& run, std::vector<char>& isMarked) {
  // The triangles of adjacent faces have corners at the same places.
  TriMesh mesh;
  std::vector<std::int32_t> faceOf;
  std::map<std::array<double, 3>, std::int32_t> places;
  for (std::size_t t = 0; t < apart.triangles.size(); ++t) {
    std::array<std::int32_t, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const Vector3d& p = apart.vertices[apart.triangles[t][k]];
      const auto [place, isNew] =
          places.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::int32_t>(places.size()));
      if (isNew) mesh.vertices.push_back(p);
      corners[k] = place->second;
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    mesh.triangles.push_back(corners);
    faceOf.push_back(apart.faceOf[t]);
  }
  for (const auto& [a, b] : findSelfIntersections(mesh, {}, run).pairs)
    isMarked[faceOf[a]] = isMarked[faceOf[b]] = 1;
}

// Marks the faces that are nearest to some points.
void markAt(const std::vector<Vector3d>& points, const std::vector<TopoDS_Face>& faces,
            double deflection, std::vector<char>& isMarked) {
  if (points.empty() || faces.empty()) return;
  const TriMesh triangles = trianglesOf(faces, deflection);
  const NearestTriangle nearest(triangles.vertices, triangles.triangles);
  for (const Vector3d& p : points) {
    std::int32_t triangle = -1;
    nearest.query(p, HUGE_VAL, 0, triangle);
    isMarked[triangles.faceOf[triangle]] = 1;
  }
}

}  // namespace

FilledSolid fillWithFacets(std::vector<TopoDS_Face> faces, const HalfEdgeMesh& mesh,
                           const Sides& sides, double tolerance, const std::vector<Vector3d>& wrong,
                           RunContext& run) {
  if (faces.empty()) return {};
  const HalfEdgeMesh thin = thinOpenGround(asOpenGround(mesh), kThinFirst * tolerance, run).mesh;
  const NearestTriangle original(mesh.points, mesh.triangles, NearestTriangle::Walks::Yes);
  const double deflection = kSagFraction * tolerance;
  // The caller's faces stay as they are: sections become exact in place. Pieces of one face are not
  // joined: the kernel (7.6) does not end if it joins some of those with open edges.
  const TopoDS_Shape own = BRepBuilderAPI_Copy(compoundOf(faces), Standard_False).Shape();
  faces.clear();
  for (TopExp_Explorer it(own, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  std::map<const void*, int> finer;  // by face
  std::map<const void*, double> areas;
  const auto areaOf = [&](const TopoDS_Face& face) {
    const auto [at, isNew] = areas.try_emplace(face.TShape().get(), 0);
    if (isNew) {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(face, properties);
      at->second = std::abs(properties.Mass());
    }
    return at->second;
  };
  const auto finerOf = [&](const TopoDS_Face& face) -> int& { return finer[face.TShape().get()]; };
  // Returns whether faces were left out.
  const auto leaveOut = [&](std::vector<char> isWrong) {
    for (char& mark : isWrong) mark = mark == 0;
    return keepMarked(faces, isWrong);
  };
  // Does so only if more vertices on their edges have not helped.
  const auto refineOrLeaveOut = [&](std::vector<char> isWrong) {
    constexpr int kMaxFiner = 2;
    bool isChanged = false;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!isWrong[f] || finerOf(faces[f]) == kMaxFiner) continue;
      ++finerOf(faces[f]);
      isWrong[f] = 0;
      isChanged = true;
    }
    return leaveOut(isWrong) || isChanged;
  };
  std::vector<char> isWrong(faces.size(), 0);
  markInvalid(faces, isWrong);
  markAt(wrong, faces, deflection, isWrong);
  leaveOut(isWrong);
  while (!faces.empty()) {
    run.checkpoint(Phase::Export);
    std::vector<OpenEdge> open = openEdgesOf(faces);
    std::vector<int> finerByFace;
    std::vector<double> areaByFace;
    for (const TopoDS_Face& face : faces) {
      finerByFace.push_back(finerOf(face));
      areaByFace.push_back(areaOf(face));
    }
    if (std::accumulate(areaByFace.begin(), areaByFace.end(), 0.0) < kMinFraction * mesh.area)
      break;
    HoleTriangles triangles(areaByFace, finerByFace, std::move(open), thin, tolerance);
    isWrong.assign(faces.size(), 0);
    triangles.cut(isWrong);
    if (leaveOut(isWrong)) continue;
    triangles.simplify(original, run, isWrong);
    if (refineOrLeaveOut(isWrong)) continue;
    const HoleFacets facets(faces, triangles);
    if (facets.failed()) {
      isWrong[*facets.failed()] = 1;
      refineOrLeaveOut(isWrong);
      continue;
    }
    const std::vector<TopoDS_Face> all = facets.all();
    const TriMesh fine = trianglesOf(all, deflection);
    std::vector<char> isMarked(all.size(), 0);
    for (const FarFoot& foot :
         feetBeyond(fine, mesh.points, sides.interior(), sides.detail(), tolerance))
      isMarked[foot.face] = 1;
    markIntersecting(fine, run, isMarked);
    markInvalid(all, isMarked);
    for (std::size_t f = 0; f < all.size(); ++f) {
      if (!isMarked[f]) continue;
      if (f < faces.size()) {
        isWrong[f] = 1;
      } else {
        triangles.markAround(facets.triangleOf(f - faces.size()), isWrong);
      }
    }
    if (leaveOut(isWrong)) continue;
    if (std::find(isMarked.begin(), isMarked.end(), 1) != isMarked.end()) return {};
    const std::vector<TopoDS_Face> closed = facets.joinedAll();
    FilledSolid result;
    for (std::size_t f = faces.size(); f < closed.size(); ++f) {
      const auto kind = BRepAdaptor_Surface(closed[f], Standard_False).GetType();
      ++(kind == GeomAbs_Plane ? result.planes : result.cones);
    }
    result.shape = solidOf(closed, mesh.volume, mesh.area * tolerance, true);
    // Facets are exact already.
    makeSectionsExact(
        compoundOf({closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(faces.size())}));
    return result;
  }
  return {};
}

}  // namespace swept::step
