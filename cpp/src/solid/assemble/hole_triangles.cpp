// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/hole_triangles.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/self_intersections.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/mesh/flip_needles.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Fractions of the tolerance: how far triangles may be off the mesh, and within which a vertex of
/// the mesh becomes a vertex of an edge.
constexpr double kFacetFraction = 0.8, kSnapFraction = 0.1;
/// Fraction of the tolerance: the halves of longer sides have ends that are far enough from each
/// other for vertices of the mesh between them.
constexpr double kMinSide = 4 * kSnapFraction;
constexpr double kMaxTurn = 0.9;     // rad, between points of a curved edge
constexpr double kMinHeight = 1e-5;  // mm, of a triangle

std::array<double, 3> placeOf(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

HoleTriangles::HoleTriangles(const std::vector<double>& areas, std::vector<OpenEdge> open,
                             const MorePoints& more, const HalfEdgeMesh& mesh, double tolerance)
    : area_(areas),
      open_(std::move(open)),
      more_(more),
      tolerance_(tolerance),
      imprint_(mesh, kSnapFraction * tolerance),
      points_(open_.size()),
      paths_(open_.size()) {}

void HoleTriangles::cut(std::vector<char>& isWrong) {
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (!isWrong[open_[i].face] && !insertPoints(i)) isWrong[open_[i].face] = 1;
  }
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (isWrong[open_[i].face] || connect(i)) continue;
    std::set<int> both{open_[i].face};
    if (imprint_.stoppedBy() >= 0) both.insert(open_[imprint_.stoppedBy()].face);
    isWrong[smallestOf(both)] = 1;
  }
  if (std::count(isWrong.begin(), isWrong.end(), 1) == 0) findHoles(isWrong);
}

bool HoleTriangles::insertPoints(std::size_t edge) {
  const BRepAdaptor_Curve curve(open_[edge].edge);
  const GCPnts_TangentialDeflection points(curve, kMaxTurn, kSagFraction * tolerance_);
  std::set<double> params;
  for (int i = 1; i <= points.NbPoints(); ++i) params.insert(points.Parameter(i));
  const auto more = more_.find(open_[edge].edge.TShape().get());
  if (more != more_.end()) params.insert(more->second.begin(), more->second.end());
  const auto insertEnd = [&](const TopoDS_Vertex& vertex) -> std::optional<std::int32_t> {
    const void* key = vertex.TShape().get();
    const auto known = ends_.find(key);
    if (known != ends_.end()) return known->second;
    const auto inserted = imprint_.insert(vectorOf(BRep_Tool::Pnt(vertex).XYZ()));
    if (inserted) ends_[key] = *inserted;
    return inserted;
  };
  for (const double t : params) {
    const auto vertex = t == *params.begin()    ? insertEnd(TopExp::FirstVertex(open_[edge].edge))
                        : t == *params.rbegin() ? insertEnd(TopExp::LastVertex(open_[edge].edge))
                                                : imprint_.insert(vectorOf(curve.Value(t).XYZ()));
    if (!vertex) return false;
    paths_[edge].params.push_back(t);
    points_[edge].push_back(*vertex);
  }
  return params.size() > 1;
}

bool HoleTriangles::connect(std::size_t edge) {
  const BRepAdaptor_Curve curve(open_[edge].edge);
  const std::vector<std::int32_t>& points = points_[edge];
  const std::vector<double> params = paths_[edge].params;
  EdgePath path{{points.front()}, {params.front()}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto part = imprint_.connect(points[i], points[i + 1], static_cast<int>(edge));
    if (part.empty()) return false;
    std::vector<double> lengths{0};
    for (std::size_t k = 1; k < part.size(); ++k)
      lengths.push_back(lengths.back() + imprint_.distance(part[k - 1], part[k]));
    for (std::size_t k = 1; k < part.size(); ++k) {
      const double fraction = lengths.back() > 0 ? lengths[k] / lengths.back() : 1;
      path.params.push_back(params[i] + fraction * (params[i + 1] - params[i]));
      path.vertices.push_back(part[k]);
      if (k + 1 < part.size())
        imprint_.move(part[k], vectorOf(curve.Value(path.params.back()).XYZ()));
    }
  }
  paths_[edge] = std::move(path);
  return true;
}

template <class Use>
void HoleTriangles::forSteps(const Use& use) const {
  for (std::size_t e = 0; e < open_.size(); ++e) {
    const std::vector<std::int32_t>& vertices = paths_[e].vertices;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const std::int32_t a = vertices[i], b = vertices[i + 1];
      const Side side{e, paths_[e].params[i], paths_[e].params[i + 1]};
      if (open_[e].isForward) {
        use(side, a, b);
      } else {
        use(side, b, a);
      }
    }
  }
}

void HoleTriangles::findHoles(std::vector<char>& isWrong) {
  const std::vector<std::int32_t> region = imprint_.regions();
  std::vector<double> votes(1 + *std::max_element(region.begin(), region.end()), 0.0);
  forSteps([&](const Side&, std::int32_t from, std::int32_t to) {
    const double length = imprint_.distance(from, to);
    votes[region[imprint_.triangleBeside(from, to)]] -= length;
    votes[region[imprint_.triangleBeside(to, from)]] += length;
  });
  isHole_.clear();
  for (const std::int32_t r : region) isHole_.push_back(votes[r] > 0);
  // Faces that do not fit to a region. Without the smallest one, the others may.
  std::map<std::int32_t, std::set<int>> misfits;
  forSteps([&](const Side& side, std::int32_t from, std::int32_t to) {
    const std::int32_t left = imprint_.triangleBeside(from, to),
                       right = imprint_.triangleBeside(to, from);
    if (isHole_[left]) misfits[region[left]].insert(faceAt(side));
    if (!isHole_[right]) misfits[region[right]].insert(faceAt(side));
  });
  for (const auto& [of, faces] : misfits) isWrong[smallestOf(faces)] = 1;
}

std::vector<HoleTriangles::Sides> HoleTriangles::simplify(const NearestTriangle& original,
                                                          RunContext& run) {
  const std::vector<Vector3d> before = imprint_.points();
  Decimated start = asOpenGround(buildHalfEdges({before, imprint_.triangles()}, run));
  Patch covered;
  covered.surface.axis.setZero();  // without directions: nothing is demanded of its triangles
  start.partition.patches.push_back(covered);
  for (std::size_t t = 0; t < isHole_.size(); ++t) {
    if (!isHole_[t]) start.partition.patchOf[t] = 0;
  }
  start.fixed.assign(before.size(), 0);
  for (const std::vector<std::int32_t>& points : points_) {
    for (const std::int32_t v : points) start.fixed[v] = 1;
  }
  takeSimplified(decimate(std::move(start), kFacetFraction * tolerance_, original, run), before);
  std::vector<Sides> wrong;
  TriMesh triangles{mesh_.points, {}};
  for (const std::int32_t t : inHoles_) {
    triangles.triangles.push_back(mesh_.triangles[t]);
    if (heightOf(mesh_, t) < kMinHeight) wrong.push_back(sidesAround(t));
  }
  for (const auto& [a, b] : findSelfIntersections(triangles, {}, run).pairs) {
    wrong.push_back(sidesAround(inHoles_[a]));
    wrong.push_back(sidesAround(inHoles_[b]));
  }
  return wrong;
}

void HoleTriangles::takeSimplified(const Decimated& simple, const std::vector<Vector3d>& before) {
  mesh_ = simple.mesh;
  std::map<std::array<double, 3>, std::int32_t> left;
  for (std::size_t v = 0; v < mesh_.points.size(); ++v)
    left[placeOf(mesh_.points[v])] = static_cast<std::int32_t>(v);
  for (std::size_t e = 0; e < open_.size(); ++e) {
    EdgePath path;
    for (std::size_t i = 0; i < paths_[e].vertices.size(); ++i) {
      const auto at = left.find(placeOf(before[paths_[e].vertices[i]]));
      if (at == left.end()) continue;
      path.vertices.push_back(at->second);
      path.params.push_back(paths_[e].params[i]);
    }
    paths_[e] = std::move(path);
  }
  forSteps([&](const Side& side, std::int32_t from, std::int32_t to) {
    sideAt_[std::minmax(from, to)] = side;
  });
  const std::vector<std::int32_t>& patchOf = simple.partition.patchOf;
  flipNeedles(mesh_, 2 * kSagFraction * tolerance_, [&](std::int32_t h) {
    return patchOf[h / 3] < 0 && patchOf[mesh_.opposite[h] / 3] < 0;
  });
  for (std::size_t t = 0; t < patchOf.size(); ++t) {
    if (patchOf[t] < 0) inHoles_.push_back(static_cast<std::int32_t>(t));
  }
}

HoleTriangles::Sides HoleTriangles::sidesAround(std::int32_t t) const {
  Sides around;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t first = 3 * t + k;
    std::int32_t h = first;
    do {
      const auto found = sideAt_.find(std::minmax(mesh_.origin(h), mesh_.target(h)));
      if (found != sideAt_.end()) around.insert(found->second);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
  }
  return around;
}

bool HoleTriangles::canHalve(const Side& side) const {
  const BRepAdaptor_Curve curve(open_[side.edge].edge);
  return curve.Value(side.from).Distance(curve.Value(side.to)) > kMinSide * tolerance_;
}

int HoleTriangles::smallestFaceAt(const Sides& sides) const {
  std::set<int> faces;
  for (const Side& side : sides) faces.insert(faceAt(side));
  return smallestOf(faces);
}

int HoleTriangles::smallestOf(const std::set<int>& faces) const {
  return *std::min_element(faces.begin(), faces.end(),
                           [&](int a, int b) { return area_[a] < area_[b]; });
}

}  // namespace swept::step
