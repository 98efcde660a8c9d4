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
#include <set>
#include <utility>

#include "geometry/nearest_triangle.h"
#include "geometry/self_intersections.h"
#include "solid/assemble/exact_sections.h"
#include "solid/assemble/face_samples.h"
#include "solid/assemble/fine_triangles.h"
#include "solid/assemble/hole_facets.h"
#include "solid/assemble/hole_triangles.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/narrow_holes.h"
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
/// Width of a hole that few faces may fill, whatever its length, as a fraction of the tolerance.
constexpr double kMaxNarrow = 0.5;

// Returns copies that share no edges with the faces.
std::vector<TopoDS_Face> copyOf(const std::vector<TopoDS_Face>& faces) {
  return facesIn(BRepBuilderAPI_Copy(compoundOf(faces), Standard_False).Shape());
}

// Returns triangles that fit together at the edges of the faces, TriMesh::faceOf with their
// indices.
TriMesh joinedTriangles(const std::vector<TopoDS_Face>& faces, double deflection) {
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

// Returns the pairs of faces whose triangles intersect, and pairs of a face with itself.
std::set<std::pair<int, int>> intersecting(const TriMesh& apart, RunContext& run) {
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
  std::set<std::pair<int, int>> pairs;
  for (const auto& [a, b] : findSelfIntersections(mesh, {}, run).pairs)
    pairs.insert(std::minmax(faceOf[a], faceOf[b]));
  return pairs;
}

}  // namespace

// The faces, and what was learned about them.
class FacetFiller::State {
 public:
  State(const std::vector<TopoDS_Face>& given, const HalfEdgeMesh& mesh, const Sides& sides,
        double tolerance, RunContext& run)
      : mesh_(mesh),
        sides_(sides),
        tolerance_(tolerance),
        run_(run),
        thin_(thinOpenGround(asOpenGround(mesh), kThinFirst * tolerance, run).mesh),
        original_(mesh.points, mesh.triangles, NearestTriangle::Walks::Yes) {
    // Pieces of one face are not joined: the kernel (7.6) does not end if it joins some of those
    // with open edges.
    faces_ = copyOf(given);
    measure(0);
  }

  FilledSolid fill(const std::vector<Vector3d>& wrong) {
    isWrong_.assign(faces_.size(), 0);
    if (round_ == 0) {
      markBubbles();
      markInvalid(faces_, isWrong_);
    }
    markAt(wrong);
    leaveOut();
    while (!faces_.empty()) {
      run_.checkpoint(Phase::Export);
      ++round_;
      appendFillings();
      std::vector<OpenEdge> open = openEdgesOf(faces_);
      isWrong_.assign(faces_.size(), 0);
      std::vector<double> areas;
      for (const TopoDS_Face& face : faces_) areas.push_back(areaOf(face));
      const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
      if (sum < kMinFraction * mesh_.area) break;
      HoleTriangles triangles(areas, std::move(open), more_, thin_, tolerance_);
      triangles.cut(isWrong_);
      if (leaveOut()) continue;
      if (mend(triangles, triangles.simplify(original_, run_))) continue;
      const HoleFacets facets(faces_, triangles);
      if (!facets.failed().empty()) {
        mend(triangles, {facets.failed()});
        continue;
      }
      const Wrong wrongFacets = test(triangles, facets);
      if (mend(triangles, wrongFacets)) continue;
      if (!wrongFacets.empty()) break;
      const FilledSolid filled = solidOfAll(facets);
      if (!filled.shape.IsNull()) return filled;
      if (!leaveOut()) break;
    }
    return {};
  }

 private:
  using Wrong = std::vector<HoleTriangles::Sides>;  // for each wrong triangle

  // Fills narrow holes, and those with a plane border.
  void appendFillings() {
    const std::size_t first = faces_.size();
    for (const TopoDS_Face& filling : narrow_.fill(openEdgesOf(faces_), kMaxNarrow * tolerance_)) {
      faces_.push_back(filling);
      // If a filling and a face of the sweep do not fit together, the filling is left out.
      areas_[filling.TShape().get()] = 0;
      isFilling_.insert(filling.TShape().get());
    }
    if (first < faces_.size()) measure(first);
  }

  // Adds triangles of the faces from an index on.
  void measure(std::size_t first) {
    const std::vector<TopoDS_Face> added(faces_.begin() + static_cast<std::ptrdiff_t>(first),
                                         faces_.end());
    const TriMesh of = trianglesWithin(compoundOf(added), deflection());
    const auto firstFace = static_cast<std::int32_t>(measured_.size());
    const auto firstVertex = static_cast<std::int32_t>(triangles_.vertices.size());
    for (const TopoDS_Face& face : added) measured_.push_back(face.TShape().get());
    triangles_.vertices.insert(triangles_.vertices.end(), of.vertices.begin(), of.vertices.end());
    for (const auto& [a, b, c] : of.triangles)
      triangles_.triangles.push_back({firstVertex + a, firstVertex + b, firstVertex + c});
    for (const std::int32_t face : of.faceOf) triangles_.faceOf.push_back(firstFace + face);
  }

  double deflection() const { return kSagFraction * tolerance_; }

  double areaOf(const TopoDS_Face& face) {
    const auto [at, isNew] = areas_.try_emplace(face.TShape().get(), 0);
    if (isNew) {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(face, properties);
      at->second = std::abs(properties.Mass());
    }
    return at->second;
  }

  // Returns triangles that lie near the faces, TriMesh::faceOf with their indices.
  TriMesh trianglesOfFaces() const {
    std::map<const void*, std::int32_t> indices;
    for (const TopoDS_Face& face : faces_)
      indices.emplace(face.TShape().get(), static_cast<std::int32_t>(indices.size()));
    TriMesh mesh{triangles_.vertices, {}};
    for (std::size_t t = 0; t < triangles_.triangles.size(); ++t) {
      const auto at = indices.find(measured_[triangles_.faceOf[t]]);
      if (at == indices.end()) continue;
      mesh.triangles.push_back(triangles_.triangles[t]);
      mesh.faceOf.push_back(at->second);
    }
    return mesh;
  }

  // Marks the faces that are nearest to some points.
  void markAt(const std::vector<Vector3d>& points) {
    if (points.empty() || faces_.empty()) return;
    const TriMesh triangles = trianglesOfFaces();
    const NearestTriangle nearest(triangles.vertices, triangles.triangles);
    for (const Vector3d& p : points) {
      std::int32_t triangle = -1;
      nearest.query(p, HUGE_VAL, 0, triangle);
      isWrong_[triangles.faceOf[triangle]] = 1;
    }
  }

  // Marks closed surfaces of faces that are far from the mesh: they bound cavities that the
  // envelope does not have.
  void markBubbles() {
    constexpr int kSamples = 9;
    std::vector<char> isOpen(faces_.size(), 0);
    std::vector<TopoDS_Face> fit = faces_;
    TopTools_IndexedMapOfShape numbers;
    for (const TopoDS_Face& face : faces_) numbers.Add(face);
    for (const OpenEdge& open : openEdgesOf(fit)) isOpen[numbers.FindIndex(fit[open.face]) - 1] = 1;
    TopTools_ListOfShape blocks;
    BOPTools_AlgoTools::MakeConnexityBlocks(compoundOf(fit), TopAbs_EDGE, TopAbs_FACE, blocks);
    for (const TopoDS_Shape& block : blocks) {
      std::vector<int> faces;
      for (TopExp_Explorer it(block, TopAbs_FACE); it.More(); it.Next())
        faces.push_back(numbers.FindIndex(it.Current()) - 1);
      const bool isBubble = std::none_of(faces.begin(), faces.end(), [&](int f) {
        if (isOpen[f]) return true;
        const std::vector<FaceSample> samples = samplesOf(faces_[f], kSamples);
        return std::any_of(samples.begin(), samples.end(), [&](const FaceSample& sample) {
          std::int32_t hint = -1;
          return original_.query(vectorOf(sample.point.XYZ()), HUGE_VAL, 0, hint) <=
                 tolerance_ * tolerance_;
        });
      });
      for (const int f : faces) isWrong_[f] = isWrong_[f] || isBubble;
    }
  }

  // Leaves out the faces that are wrong. Returns whether there were any.
  bool leaveOut() {
    std::vector<char> isKept;
    for (const char isWrong : isWrong_) isKept.push_back(isWrong == 0);
    return keepMarked(faces_, isKept);
  }

  // Halves the sides of wrong triangles that are parts of open edges. Where they are too short, or
  // after many rounds, the smallest of the faces there is left out. Also leaves out faces that are
  // wrong. Returns whether anything was changed.
  bool mend(const HoleTriangles& triangles, const Wrong& wrong) {
    constexpr int kHalvingRounds = 30;
    bool isHalved = false;
    for (const HoleTriangles::Sides& sides : wrong) {
      bool canHalve = false;
      for (const HoleTriangles::Side& side : sides) {
        if (round_ > kHalvingRounds || !triangles.canHalve(side)) continue;
        more_[triangles.open()[side.edge].edge.TShape().get()].insert((side.from + side.to) / 2);
        canHalve = isHalved = true;
      }
      if (!canHalve && !sides.empty()) isWrong_[triangles.smallestFaceAt(sides)] = 1;
    }
    return leaveOut() || isHalved;
  }

  // Appends the triangles that do not belong to faces.
  void appendFacets(const TriMesh& from, TriMesh& to) const {
    const auto first = static_cast<std::int32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
      if (from.faceOf[t] < static_cast<int>(faces_.size())) continue;
      const auto& [a, b, c] = from.triangles[t];
      to.triangles.push_back({first + a, first + b, first + c});
      to.faceOf.push_back(from.faceOf[t]);
    }
  }

  // Marks wrong faces, and returns the wrong facets.
  Wrong test(const HoleTriangles& triangles, const HoleFacets& facets) {
    const std::vector<TopoDS_Face> all = facets.all();
    std::vector<char> isMarked(all.size(), 0);
    const TriMesh joined = joinedTriangles(all, deflection());
    // The kernel's triangles of curved faces may be less accurate than demanded.
    TriMesh accurate = trianglesOfFaces();
    appendFacets(joined, accurate);
    for (const FarFoot& foot :
         feetBeyond(accurate, mesh_.points, sides_.interior(), sides_.detail(), tolerance_))
      isMarked[foot.face] = 1;
    markInvalid(all, isMarked);
    for (const auto& [a, b] : intersecting(joined, run_)) {
      // Facets are less exact than faces.
      const bool isOfFaces = b < static_cast<int>(faces_.size());
      isMarked[isOfFaces && areaOf(faces_[a]) < areaOf(faces_[b]) ? a : b] = 1;
    }
    Wrong wrong;
    for (std::size_t f = 0; f < all.size(); ++f) {
      if (!isMarked[f]) continue;
      if (f < faces_.size()) {
        isWrong_[f] = 1;
      } else {
        wrong.push_back(triangles.sidesAround(facets.triangleOf(f - faces_.size())));
      }
    }
    return wrong;
  }

  // If it cannot be made valid, marks the faces that are not.
  FilledSolid solidOfAll(const HoleFacets& facets) {
    // Repairs change the faces in place, and so do exact sections.
    const std::vector<TopoDS_Face> closed = copyOf(facets.joinedAll());
    FilledSolid result;
    std::vector<TopoDS_Face> ofSweep;
    for (std::size_t f = 0; f < closed.size(); ++f) {
      if (f < faces_.size() && isFilling_.count(faces_[f].TShape().get()) == 0) {
        ofSweep.push_back(closed[f]);
        continue;
      }
      const auto kind = BRepAdaptor_Surface(closed[f], Standard_False).GetType();
      ++(kind == GeomAbs_Plane ? result.planes : result.cones);
    }
    result.shape = solidOf(closed, mesh_.volume, mesh_.area * tolerance_, true);
    if (result.shape.IsNull()) {
      for (std::size_t f = 0; f < faces_.size(); ++f)
        isWrong_[f] = BRepCheck_Analyzer(closed[f]).IsValid() ? 0 : 1;
      return result;
    }
    // Facets are exact already.
    makeSectionsExact(compoundOf(ofSweep));
    return result;
  }

  const HalfEdgeMesh& mesh_;
  const Sides& sides_;
  const double tolerance_;
  RunContext& run_;
  const HalfEdgeMesh thin_;
  const NearestTriangle original_;
  std::vector<const void*> measured_;  // the faces at first
  TriMesh triangles_;                  // of these, within deflection()
  std::vector<TopoDS_Face> faces_;
  std::vector<char> isWrong_;  // by face
  HoleTriangles::MorePoints more_;
  std::map<const void*, double> areas_;
  NarrowHoles narrow_;
  std::set<const void*> isFilling_;  // of faces_
  int round_ = 0;
};

FacetFiller::FacetFiller(const std::vector<TopoDS_Face>& faces, const HalfEdgeMesh& mesh,
                         const Sides& sides, double tolerance, RunContext& run)
    : state_(std::make_unique<State>(faces, mesh, sides, tolerance, run)) {}
FacetFiller::~FacetFiller() = default;

FilledSolid FacetFiller::fill(const std::vector<Vector3d>& wrong) { return state_->fill(wrong); }

}  // namespace swept::step
