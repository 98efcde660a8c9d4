// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/body_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/limits.h"
#include "base/number_text.h"
#include "geometry/mesh_numbers.h"
#include "input/body_orientation.h"
#include "input/body_weld.h"
#include "input/options_check.h"

namespace swept {
namespace {

std::string list(const std::vector<std::int64_t>& items) {
  std::string text;
  for (const std::int64_t item : items) text += (text.empty() ? "" : ", ") + std::to_string(item);
  return text;
}

void refuseBadFaces(const TriMesh& body) {
  const auto negative = std::find_if(body.faceOf.begin(), body.faceOf.end(),
                                     [](std::int32_t face) { return face < 0; });
  if (body.faceOf.size() == body.triangles.size() && negative == body.faceOf.end()) return;
  throw Error(Status::InvalidInput, "BadFaces",
              negative == body.faceOf.end()
                  ? std::to_string(body.faceOf.size()) + " face numbers are given for " +
                        std::to_string(body.triangles.size()) +
                        " triangles; give one face number for each triangle, or none at all"
                  : "triangle " + std::to_string(negative - body.faceOf.begin()) +
                        " has the face number " + std::to_string(*negative) +
                        " (triangles are counted from 0); face numbers begin at 0");
}

/// If `wanted`, keeps the given face of each triangle; without given faces, each triangle becomes a
/// separate face. If not `wanted`, removes the faces.
void setFaces(CheckedBody& result, bool wanted) {
  std::vector<std::int32_t>& faceOf = result.mesh.faceOf;
  result.namedFaces = wanted && !faceOf.empty();
  if (result.namedFaces) {
    refuseBadFaces(result.mesh);
    return;
  }
  faceOf.resize(wanted ? result.mesh.triangles.size() : 0);
  std::iota(faceOf.begin(), faceOf.end(), 0);
}

void refuseUnusable(const TriMesh& body) {
  if (body.vertices.empty() || body.triangles.empty()) {
    throw Error(Status::InvalidInput, "EmptyMesh",
                "the part has " + std::to_string(body.vertices.size()) + " vertices and " +
                    std::to_string(body.triangles.size()) +
                    " triangles; choose an object that has a surface");
  }
  const auto count = static_cast<std::int64_t>(body.vertices.size());
  if (count > 2147483647) {
    throw Error(Status::ResourceLimit, "TooManyVertices",
                "the part has " + std::to_string(count) +
                    " vertices, but the limit is 2147483647; use a coarser mesh");
  }
  if (const auto bad = findBadIndex(body)) {
    throw Error(Status::InvalidInput, "BadIndex",
                badIndexText(*bad, body) + "; the mesh is damaged: export it again");
  }
}

void refuseBadVertices(const TriMesh& body) {
  const Coordinates found = measureCoordinates(body);
  if (found.nonFinite > 0) {
    throw Error(Status::InvalidInput, "NonFiniteVertex",
                counted(found.nonFinite, "vertex has", "vertices have") +
                    " a coordinate that is not a finite number (the first ones, counted from 0: " +
                    list(found.firstNonFinite) + "); repair the mesh, or export it again");
  }
  if (found.largest > kMaxLength) {
    throw Error(Status::InvalidInput, "OutOfRange",
                "the part reaches " + numberText(found.largest) +
                    " mm from the origin, but the limit is 1e9 mm; check the unit of length, or "
                    "move the part closer to the origin");
  }
}

void add(CheckedBody& result, const char* code, std::int64_t count, std::string text,
         std::vector<std::int64_t> first = {}) {
  if (count > 0) result.findings.push_back({code, count, std::move(first), std::move(text)});
}

double boxDiagonal(const TriMesh& mesh) {
  Eigen::Vector3d low = mesh.vertices[0], high = mesh.vertices[0];
  for (const auto& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).norm();
}

/// Merges vertices on open edges within `tolerance` (mm). Keeps the result only if fewer edges are
/// open.
void weldOpenEdges(CheckedBody& result, EdgeTable& table, EdgeCounts& edges, CleanCounts& cleaned,
                   double tolerance, bool keepSheets) {
  if (edges.open == 0 || !(tolerance > 0)) return;
  TriMesh welded = result.mesh;
  CleanCounts counts = cleaned;
  const std::int64_t moved =
      applyMap(toleranceWeld(welded.vertices, edges.openVertices, tolerance), welded);
  if (moved == 0) return;
  EdgeTable weldedTable = cleanTriangles(welded, counts, keepSheets);
  if (welded.triangles.empty()) return;
  EdgeCounts after = countEdges(weldedTable);
  if (after.open >= edges.open) return;
  add(result, "WeldedWithinTolerance", moved,
      counted(moved, "vertex on an open edge was", "vertices on open edges were") +
          " joined with another vertex at a distance of at most " + numberText(tolerance) +
          " mm (number of open edges before: " + std::to_string(edges.open) +
          ", after: " + std::to_string(after.open) + ")");
  result.mesh = std::move(welded);
  table = std::move(weldedTable);
  edges = std::move(after);
  cleaned = counts;
}

void reportCleaning(CheckedBody& result, const CleanCounts& cleaned) {
  add(result, "DegenerateTriangles", cleaned.degenerate,
      counted(cleaned.degenerate, "triangle without area was", "triangles without area were") +
          " removed",
      cleaned.firstDegenerate);
  add(result, "DuplicateTriangles", cleaned.repeated,
      counted(cleaned.repeated, "triangle was", "triangles were") +
          " removed, which had the same corners as another triangle",
      cleaned.firstDuplicate);
  add(result, "OppositeTriangles", cleaned.opposite,
      std::to_string(cleaned.opposite) +
          " triangles were removed: they lie in pairs with the same corners, face opposite ways "
          "and enclose nothing",
      cleaned.firstDuplicate);
}

void reportOrientation(CheckedBody& result, const OrientationResult& oriented) {
  add(result, "MixedOrientation", oriented.mixed,
      counted(oriented.mixed,
              "triangle faced the opposite way to its adjacent triangles and was reversed",
              "triangles faced the opposite way to their adjacent triangles and were reversed"));
  add(result, "Flipped", oriented.inverted,
      std::to_string(oriented.inverted) + " of " + counted(oriented.shells, "shell") +
          " faced inwards and " + (oriented.inverted == 1 ? "was" : "were") + " reversed");
  add(result, "Cavities", oriented.cavities,
      counted(oriented.cavities, "shell is a cavity", "shells are cavities") + " inside the part");
  add(result, "NestedShells", oriented.nested,
      counted(oriented.nested,
              "shell lies completely inside another shell and faces outwards; it counts",
              "shells lie completely inside another shell and face outwards; they count") +
          " as material");
  add(result, "NotOrientable", oriented.inconsistent,
      counted(oriented.inconsistent, "shell") +
          " cannot be oriented consistently (like a Möbius strip), so no face can be left "
          "out, and the run takes longer; repair the mesh");
  add(result, "InsideOut", oriented.insideOut ? 1 : 0,
      "the surface intersects itself, and some regions are inside out, so no face can be "
      "left out, and the run takes longer; repair the mesh");
}

}  // namespace

CheckedBody checkBody(const TriMesh& body, const Options& options, RunContext& run) {
  run.checkpoint(Phase::Input);
  refuseUnusable(body);
  refuseBadVertices(body);

  CheckedBody result;
  result.mesh = body;
  setFaces(result, options.sources);
  const std::int64_t joined = applyMap(exactWeld(body.vertices), result.mesh);
  run.checkpoint(Phase::Input);
  CleanCounts cleaned;
  // A thin part may be modelled as a sheet with two coincident sides. The sheet has no volume, but
  // it belongs to the real part. A conservative envelope must contain the whole part, so the sheet
  // is kept for it.
  const bool keepSheets = options.conservative;
  EdgeTable table = cleanTriangles(result.mesh, cleaned, keepSheets);
  const std::string before = std::to_string(body.vertices.size());
  if (result.mesh.triangles.empty()) {
    throw Error(Status::InvalidInput, "NoVolume",
                "the part encloses no volume (number of triangles: " +
                    std::to_string(body.triangles.size()) + ", of these " +
                    std::to_string(cleaned.degenerate) + " without area and " +
                    std::to_string(cleaned.opposite) +
                    " in coincident opposite pairs); choose a solid or a closed mesh");
  }
  run.checkpoint(Phase::Input);
  EdgeCounts edges = countEdges(table);
  add(result, "Welded", joined,
      counted(joined, "vertex", "vertices") + " had the same coordinates as another vertex and " +
          (joined == 1 ? "was" : "were") + " joined with it (number of vertices before: " + before +
          ", after: " + std::to_string(result.mesh.vertices.size()) + ")");
  weldOpenEdges(result, table, edges, cleaned, weldTolerance(options, boxDiagonal(result.mesh)),
                keepSheets);
  reportCleaning(result, cleaned);
  run.checkpoint(Phase::Input);

  result.closed = edges.open == 0;
  result.manifold = edges.nonManifold == 0;
  add(result, "OpenEdges", edges.open,
      counted(edges.open, "edge belongs", "edges belong") +
          " to only one triangle: the surface is open there, and the envelope is closed only "
          "where the motion closes it",
      edges.firstOpen);
  add(result, "NonManifoldEdges", edges.nonManifold,
      counted(edges.nonManifold, "edge of the part is", "edges of the part are") +
          " shared by more than two triangles",
      edges.firstNonManifold);
  const OrientationResult oriented = orientShells(result.mesh, table, result.closed, run);
  result.orientable = oriented.orientable;
  reportOrientation(result, oriented);
  return result;
}

}  // namespace swept
