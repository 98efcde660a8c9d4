// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/shape_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/sort_unique.h"
#include "geometry/nearest_triangle.h"
#include "solid/carrier/section.h"
#include "solid/mesh/decimate.h"
#include "solid/mesh/patches.h"
#include "solid/model/bent_arcs.h"
#include "solid/model/deviation.h"
#include "solid/model/gaps.h"
#include "solid/model/split_edges.h"
#include "solid/recognise/costly_patches.h"
#include "solid/recognise/recognise.h"

namespace swept::step {
namespace {

// Fractions of the tolerance that recognised surfaces and facets may use. The error of the facets
// plus that of the simplification before them may exceed the tolerance. If so, vertices are added
// to the mesh at the end.
constexpr double kSurfaceFraction = 0.83, kFaceFraction = 0.95;

Built describe(Model model, double deviation) {
  Built built{std::move(model), {}, deviation};
  for (const ModelFace& face : built.model.faces)
    ++built.facesByKind[surfaceKindName(face.surface.kind)];
  return built;
}

Partition partitionOf(const HalfEdgeMesh& mesh, const HalfEdgeMesh& whole,
                      const SolidOptions& options, RunContext& run) {
  Partition partition;
  partition.patchOf.assign(mesh.triangles.size(), -1);
  if (options.tolerance > 0 && options.recognise) {
    recogniseSurfaces(mesh, whole, kSurfaceFraction * options.tolerance, partition, run);
  }
  return partition;
}

// Turns patches into open ground. Vertices on their borders may have moved along the surfaces, so
// the new triangles must stay near the original vertices of these patches.
void forgetPatches(const std::vector<std::int32_t>& patches, const HalfEdgeMesh& dense,
                   const Partition& first, Decimated& now) {
  now.attached.resize(now.mesh.triangles.size());
  for (const std::int32_t p : patches) {
    std::vector<std::int32_t>& members = now.partition.patches[p].triangles;
    if (members.empty()) continue;
    NearestTriangle::Triangles open;
    for (const std::int32_t t : members) {
      now.partition.patchOf[t] = -1;
      open.push_back(now.mesh.triangles[t]);
    }
    std::vector<std::int32_t> vertices;
    for (const std::int32_t t : first.patches[p].triangles)
      vertices.insert(vertices.end(), dense.triangles[t].begin(), dense.triangles[t].end());
    sortUnique(vertices);
    const NearestTriangle nearest(now.mesh.points, open);
    std::int32_t closest = -1;
    for (const std::int32_t v : vertices) {
      nearest.query(dense.points[v], 1e300, 0, closest);
      now.attached[members[closest]].push_back(dense.points[v]);
    }
    members.clear();
  }
}

// Adds to `patches` the recognised patches around the start vertex of the half-edge `first`.
void addRecognisedAround(const Decimated& small, std::int32_t first, std::int32_t recognisedCount,
                         std::vector<std::int32_t>& patches) {
  std::int32_t h = first;
  do {
    const std::int32_t patch = small.partition.patchOf[h / 3];
    if (patch < recognisedCount) patches.push_back(patch);
    h = small.mesh.opposite[HalfEdgeMesh::previous(h)];
  } while (h != first);
}

// Withdraws faces that the kernel refuses. Recognised patches among them go into `refused`, to lose
// their surface. Plane regions are split into facets. Returns true if a plane region was split.
bool withdraw(const std::vector<std::int32_t>& bad, const Model& model,
              std::int32_t recognisedCount, Decimated& small, std::vector<std::int32_t>& refused) {
  bool again = false;
  for (const std::int32_t face : bad) {
    const std::int32_t patch = model.faces[face].patch;
    if (patch < recognisedCount) {
      refused.push_back(patch);
    } else if (small.partition.patches[patch].triangles.size() > 1) {
      dissolvePatch(small.mesh, patch, small.partition);
      again = true;
    } else {
      // The kernel may refuse a facet because a patch around it has moved one of its corners.
      const std::int32_t t = small.partition.patches[patch].triangles[0];
      for (int k = 0; k < 3; ++k) addRecognisedAround(small, 3 * t + k, recognisedCount, refused);
    }
  }
  sortUnique(refused);
  return again;
}

std::int64_t countFaces(const Partition& partition) {
  return std::count_if(partition.patches.begin(), partition.patches.end(),
                       [](const Patch& patch) { return !patch.triangles.empty(); });
}

bool hasFacets(const Model& model) {
  return std::any_of(model.faces.begin(), model.faces.end(),
                     [](const ModelFace& face) { return face.surface.kind == CarrierKind::Facet; });
}

std::vector<std::int32_t> curvedFacesOf(const std::vector<EdgeCut>& edges, const Model& model) {
  std::vector<char> isListed(model.edges.size(), 0);
  for (const EdgeCut& cut : edges) isListed[cut.edge] = 1;
  std::vector<std::int32_t> faces;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (model.faces[f].surface.isPlanar()) continue;
    for (const auto& loop : model.faces[f].loops) {
      for (const ModelUse& use : loop) {
        if (isListed[use.edge]) faces.push_back(static_cast<std::int32_t>(f));
      }
    }
  }
  sortUnique(faces);
  return faces;
}

class ShapeMaker {
 public:
  ShapeMaker(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense, const SolidOptions& options,
             const std::function<bool(std::int64_t)>& fits, Judge& judge, RunContext& run)
      : whole_(whole),
        dense_(dense),
        options_(options),
        fits_(fits),
        judge_(judge),
        run_(run),
        original_(dense.points, dense.triangles, NearestTriangle::Walks::Yes) {}

  std::optional<Built> make(std::int64_t& faces) {
    constexpr int kRounds = 5;
    const Partition first = partitionOf(dense_, whole_, options_, run_);
    recognisedCount_ = static_cast<std::int32_t>(first.patches.size());
    const double tolerance = kFaceFraction * options_.tolerance;
    Decimated start{dense_, first, {}, {}, 0};
    if (tolerance > 0 && isWorthTrial())
      start = thinOpenGround(std::move(start), kThinFraction * options_.tolerance, run_);
    if (recognisedCount_ > 0 && isWorthTrial()) start = trial(first, std::move(start), tolerance);
    for (int round = 0; round <= kRounds; ++round) {
      const Effort effort = round == 0 ? Effort::Thorough : Effort::Again;
      if (tolerance > 0) start = decimate(std::move(start), tolerance, original_, run_, effort);
      refused_.clear();
      if (auto built = tryMesh(start, faces)) return built;
      if (!fits_(faces)) return std::nullopt;
      if (refused_.empty()) break;
      forgetPatches(refused_, dense_, first, start);
    }
    throw Error(Status::ExportFailed, "InvalidFaces",
                "OpenCASCADE does not accept " + refusedText_ +
                    "; repair the mesh there, set another tolerance, or export a mesh file");
  }

 private:
  bool isWorthTrial() const { return dense_.triangles.size() > kMinTrialTriangles; }

  // A rough simplification finds the patches that are not worth their border, and those that the
  // kernel refuses. These patches become open ground before the real simplification starts.
  Decimated trial(const Partition& first, Decimated start, double tolerance) {
    Decimated left = decimate(std::move(start), tolerance, original_, run_, Effort::Rough);
    std::vector<std::int32_t> bad = findCostly(dense_, first, left, tolerance);
    Decimated rough = left;
    addFacets(rough.mesh, rough.partition);
    const Model model = buildModel(rough.mesh, rough.partition, options_.tolerance, run_);
    std::vector<std::int32_t> faces = judge_.setModel(model, run_);
    if (faces.empty()) faces = judge_.findBadFaces(run_, 0.05, 0.1);
    const std::vector<std::int32_t> unread = judge_.findUnreadable(model, options_, run_);
    faces.insert(faces.end(), unread.begin(), unread.end());
    const std::vector<std::int32_t> loose =
        findLooseFaces(model, recognisedCount_, options_.tolerance);
    faces.insert(faces.end(), loose.begin(), loose.end());
    for (const std::int32_t face : faces) {
      if (model.faces[face].patch < recognisedCount_) bad.push_back(model.faces[face].patch);
    }
    sortUnique(bad);
    forgetPatches(bad, dense_, first, left);
    return left;
  }

  // Gives the model to the judge. Cuts edges that are farther from a face than a reader of the file
  // would assume (findEdgesOffFaces()): an edge with a gap where the distance is largest, others in
  // the middle. `left` receives the edges that are still too far after kCuts rounds. Returns the
  // faces that cannot be made.
  std::vector<std::int32_t> setModelAndCutEdges(Model& model, std::vector<EdgeCut>& left) {
    constexpr int kCuts = 6;
    cutBentArcs(model);
    for (int round = 0;; ++round) {
      std::vector<std::int32_t> failed = judge_.setModel(model, run_);
      if (options_.tolerance <= 0 || !failed.empty()) return failed;
      left = judge_.findEdgesOffFaces(model);
      if (left.empty() || round == kCuts) return failed;
      for (EdgeCut& cut : left) {
        const ModelEdge& edge = model.edges[cut.edge];
        const double part = cut.at / edge.curve.last;
        if (edge.tolerance <= kOnCarrier || part < 0.1 || part > 0.9) cut.at = middleOf(edge.curve);
      }
      splitEdges(left, model);
    }
  }

  // Returns the faces that are loose or that the judge refuses. If no face is loose, the judge has
  // received the model.
  std::vector<std::int32_t> findUnsound(Model& model) {
    if (options_.tolerance > 0) {
      std::vector<std::int32_t> loose = findLooseFaces(model, recognisedCount_, options_.tolerance);
      if (!loose.empty()) return loose;
    }
    std::vector<EdgeCut> offFaces;
    const std::vector<std::int32_t> failed = setModelAndCutEdges(model, offFaces);
    if (!failed.empty()) return failed;
    // If there are facets anyway, the curved faces at these edges may become facets, too. A solid
    // without facets keeps its curved faces, because they would become hundreds of facets.
    if (!offFaces.empty() && hasFacets(model)) return curvedFacesOf(offFaces, model);
    std::vector<std::int32_t> bad = judge_.findBadFaces(run_, 0.1, 0.3);
    return bad.empty() ? judge_.findUnreadable(model, options_, run_) : bad;
  }

  // Splits plane regions into facets if the kernel does not accept their faces, does not read them
  // back, or finds that they intersect others. Returns false if a face stays unsound, or if a
  // recognised patch has to lose its surface. In the second case the caller starts again.
  bool acceptFaces(Decimated& small, double tolerance, Model& model) {
    constexpr int kTrials = 4;
    for (int trial = 0; trial < kTrials; ++trial) {
      if (trial > 0) model = buildModel(small.mesh, small.partition, tolerance, run_);
      std::vector<std::int32_t> bad = findUnsound(model);
      const bool sound = bad.empty();
      if (sound && options_.tolerance > 0) bad = judge_.findInterfering(model, run_);
      if (bad.empty()) return true;
      refusedText_ = facesText(bad, model);
      const bool changed = withdraw(bad, model, recognisedCount_, small, refused_);
      if (!refused_.empty()) return false;
      // If only facets intersect and no recognised surface is left to withdraw, they are kept,
      // because each facet is valid.
      if (!changed || trial + 1 == kTrials) return sound;
    }
    return false;
  }

  // Builds the solid, adds vertices where it is too far from the mesh, and tests the faces with the
  // kernel. Returns nothing if there are too many faces or if faces are not accepted.
  std::optional<Built> tryMesh(Decimated base, std::int64_t& faces) {
    const double tolerance = std::max(options_.planarTolerance, options_.tolerance);
    const bool exact = options_.tolerance <= 0;
    // Mesh vertices whose distance from the solid the last repair may have changed.
    std::vector<Eigen::Vector3d> affected;
    for (int repairs = 0;; ++repairs) {
      Decimated small{base.mesh, base.partition, {}, {}, base.deviation};
      if (options_.mergeCoplanar)
        growPlanes(small.mesh, options_.planarTolerance, small.partition, run_);
      addFacets(small.mesh, small.partition);
      faces = countFaces(small.partition);
      if (!fits_(faces)) return std::nullopt;
      Model model = buildModel(small.mesh, small.partition, tolerance, run_);
      Deviation deviation;
      const auto repair = [&](const std::vector<Eigen::Vector3d>& points) {
        deviation = measureDeviation(points, small, model.positions, tolerance);
        if (exact || deviation.beyond.empty() || repairs == kRepairs) return false;
        affected = pointsAbout(deviation.beyond, small, tolerance, whole_.points);
        return putCorners(deviation.beyond, base, run_);
      };
      if (repairs > 0 && repair(affected)) continue;
      if (repair(whole_.points)) continue;
      if (!acceptFaces(small, tolerance, model)) return std::nullopt;
      if (countFaces(small.partition) != faces && repair(whole_.points)) continue;
      return describe(std::move(model), deviation.largest);
    }
  }

  static constexpr int kRepairs = 16;
  /// Number of triangles. For a smaller mesh, a trial costs more time than it saves.
  static constexpr std::size_t kMinTrialTriangles = 20000;
  const HalfEdgeMesh& whole_;
  const HalfEdgeMesh& dense_;
  const SolidOptions& options_;
  const std::function<bool(std::int64_t)>& fits_;
  Judge& judge_;
  RunContext& run_;
  const NearestTriangle original_;
  std::int32_t recognisedCount_ = 0;   // patches below this number were recognised
  std::vector<std::int32_t> refused_;  // patches that lose their surface
  std::string refusedText_;            // number and position of the faces refused last
};

}  // namespace

std::optional<Built> makeShape(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense,
                               const SolidOptions& options,
                               const std::function<bool(std::int64_t)>& fits, Judge& judge,
                               std::int64_t& faces, RunContext& run) {
  return ShapeMaker(whole, dense, options, fits, judge, run).make(faces);
}

}  // namespace swept::step
