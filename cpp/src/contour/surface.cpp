// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/surface.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/parallel.h"
#include "contour/dual_surface.h"
#include "contour/polygon_split.h"

namespace swept {
namespace {

using Triangle = std::array<std::int32_t, 3>;

struct LayerPolygons {
  std::vector<Triangle> triangles;  // indices >= kExtra: extra vertices of this layer
  std::vector<std::uint32_t> crossingOf;
  std::vector<Eigen::Vector3d> extra;  // positions in grid coordinates
  std::vector<double> extraTime;
};

constexpr std::int32_t kExtra = 0x40000000;

std::uint64_t sideKey(std::uint32_t crossing, int side) {
  return static_cast<std::uint64_t>(crossing) << 2 | static_cast<std::uint64_t>(side);
}

/// Extra vertices on faces where two segments join the same two components.
struct FacePoints {
  std::unordered_map<std::uint64_t, std::int32_t> at;  // side of a quad -> index into points
  std::vector<bool> hasPoint;  // per crossing: whether its quad has a point; empty if none has
  std::vector<Eigen::Vector3d> points;  // grid coordinates
  std::vector<double> times;
};

FacePoints findFacePoints(const HermiteGrid& grid, const DualSurface& dual) {
  FacePoints out;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends(dual.ambiguous.size());
  parallelBlocks(ends.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const FaceSegment& s = dual.ambiguous[n];
      const CrossingEdge edge = edgeOfCrossing(grid, s.crossing[0]);
      ends[n] = std::minmax({dual.vertex(edge.axis, edge.i, s.crossing[0], s.side[0]),
                             dual.vertex(edge.axis, edge.i, s.crossing[0], (s.side[0] + 1) & 3)});
    }
  });
  for (std::size_t begin = 0; begin < dual.ambiguous.size();) {
    std::size_t end = begin + 1;
    while (end < dual.ambiguous.size() && !dual.ambiguous[end].firstOfFace) ++end;
    for (std::size_t s = begin + 1; s < end; ++s) {
      bool shared = false;
      for (std::size_t r = begin; r < s; ++r) shared |= ends[r] == ends[s];
      if (!shared) continue;
      const FaceSegment& segment = dual.ambiguous[s];
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      double time = 0;
      for (int e = 0; e < 2; ++e) {
        const CrossingEdge edge = edgeOfCrossing(grid, segment.crossing[e]);
        middle += positionOfCrossing(grid, edge, segment.crossing[e]) / 2;
        time = grid.crossings[segment.crossing[e]].timeSeconds;
        out.at[sideKey(segment.crossing[e], segment.side[e])] =
            static_cast<std::int32_t>(out.points.size());
        out.hasPoint.resize(grid.crossings.size());
        out.hasPoint[segment.crossing[e]] = true;
      }
      out.points.push_back(middle);
      out.times.push_back(time);
    }
    begin = end;
  }
  return out;
}

class LayerEmitter {
 public:
  LayerEmitter(const HermiteGrid& grid, const DualSurface& dual, const FacePoints& facePoints,
               std::int32_t firstFacePoint)
      : grid_(grid), dual_(dual), facePoints_(facePoints), firstFacePoint_(firstFacePoint) {}

  void emit(std::int32_t i, LayerPolygons& out) {
    const HermiteLayer& layer = grid_.layers[i];
    for (int axis = 0; axis < 3; ++axis) {
      for (std::int32_t j = 0; j < grid_.plan.points[1]; ++j) {
        for (std::uint32_t e = layer.columnStart[axis][j]; e < layer.columnStart[axis][j + 1];
             ++e) {
          emitEdge(axis, i, j, layer.edges[axis][e], out);
        }
      }
    }
  }

 private:
  void emitEdge(int axis, std::int32_t i, std::int32_t j, const HermiteEdge& edge,
                LayerPolygons& out) {
    const int n = edge.sides == 3 ? 2 : 1;
    std::array<Split, 2> split{};
    for (int c = 0; c < n; ++c) {
      const std::uint32_t crossing = edge.first + static_cast<std::uint32_t>(c);
      if (!dual_.isComplete(crossing)) return;
      split[c] =
          hasFacePoint(crossing)
              ? Split::Fan
              : chooseSplit(dual_, axis, i,
                            positionOfCrossing(grid_, {axis, i, j, edge.k}, crossing), crossing);
    }
    if (n == 2 && split[0] == split[1] && split[0] != Split::Fan) {
      const int from = split[0] == Split::Diagonal02 ? 0 : 1;
      const auto &q = dual_.quads[edge.first], &r = dual_.quads[edge.first + 1];
      if (q[from] == r[from] && q[from + 2] == r[from + 2]) split = {Split::Fan, Split::Fan};
    }
    for (int c = 0; c < n; ++c) {
      const bool seenFromLow = (edge.sides & HermiteEdge::kLow) != 0 && c == 0;
      emitQuad(axis, i, j, edge, edge.first + static_cast<std::uint32_t>(c), split[c], seenFromLow,
               out);
    }
  }

  bool hasFacePoint(std::uint32_t crossing) const {
    return !facePoints_.hasPoint.empty() && facePoints_.hasPoint[crossing];
  }

  void emitQuad(int axis, std::int32_t i, std::int32_t j, const HermiteEdge& edge,
                std::uint32_t crossing, Split split, bool seenFromLow, LayerPolygons& out) {
    std::array<std::int32_t, 8> ring;
    int n = 0;
    for (int corner = 0; corner < 4; ++corner) {
      ring[n++] = static_cast<std::int32_t>(dual_.vertex(axis, i, crossing, corner));
      if (split != Split::Fan || !hasFacePoint(crossing)) continue;
      const auto point = facePoints_.at.find(sideKey(crossing, corner));
      if (point != facePoints_.at.end()) ring[n++] = firstFacePoint_ + point->second;
    }
    // The ring runs counter-clockwise about +axis, so its triangles face the high end of the
    // lattice edge. The polygon must face the end from which the crossing is seen.
    const auto triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
      if (seenFromLow) std::swap(b, c);
      out.triangles.push_back({a, b, c});
      out.crossingOf.push_back(crossing);
    };
    if (split == Split::Diagonal02) {
      triangle(ring[0], ring[1], ring[2]);
      triangle(ring[0], ring[2], ring[3]);
    } else if (split == Split::Diagonal13) {
      triangle(ring[1], ring[2], ring[3]);
      triangle(ring[1], ring[3], ring[0]);
    } else {
      const auto centre = kExtra + static_cast<std::int32_t>(out.extra.size());
      out.extra.push_back(positionOfCrossing(grid_, {axis, i, j, edge.k}, crossing));
      out.extraTime.push_back(grid_.crossings[crossing].timeSeconds);
      for (int p = 0; p < n; ++p) triangle(centre, ring[p], ring[(p + 1) % n]);
    }
  }

  const HermiteGrid& grid_;
  const DualSurface& dual_;
  const FacePoints& facePoints_;
  std::int32_t firstFacePoint_;
};

/// Adds the polygon between the two vertices of a split component and those of the neighbouring
/// cell. The polygon is a quad, or a triangle if the neighbouring cell has one vertex for both
/// parts. Along each shared edge it runs opposite to the adjacent polygon, so the surface stays
/// oriented.
void addRim(const RimSegment& rim, const HermiteGrid& grid, const DualSurface& dual,
            std::vector<Triangle>& triangles) {
  struct Corner {
    std::uint32_t vertex = 0;
    Eigen::Vector3d position;
  };
  std::array<Corner, 4> ring;
  for (int n = 0; n < 2; ++n) {
    const CrossingEdge edge = edgeOfCrossing(grid, rim.crossing[n]);
    for (int end = 0; end < 2; ++end) {
      // If the crossing is seen from the high end, the quad's side runs from its first corner to
      // its second; else the other way.
      const int corner = (rim.side[n] + end) & 3;
      Corner& to = ring[2 * n + ((end == 0) == rim.seenFromLow[n] ? 0 : 1)];
      to.vertex = dual.vertex(edge.axis, edge.i, rim.crossing[n], corner);
      const auto layer =
          std::upper_bound(dual.firstVertex.begin(), dual.firstVertex.end(), to.vertex) -
          dual.firstVertex.begin() - 1;
      to.position = dual.position(to.vertex, static_cast<std::int32_t>(layer));
    }
  }
  const auto triangle = [&](int a, int b, int c) {
    triangles.push_back({static_cast<std::int32_t>(ring[a].vertex),
                         static_cast<std::int32_t>(ring[b].vertex),
                         static_cast<std::int32_t>(ring[c].vertex)});
  };
  if (ring[1].vertex == ring[2].vertex) {
    if (ring[3].vertex != ring[0].vertex) triangle(0, 1, 3);
  } else if (ring[3].vertex == ring[0].vertex) {
    triangle(0, 1, 2);
  } else if ((ring[2].position - ring[0].position).squaredNorm() <=
             (ring[3].position - ring[1].position).squaredNorm()) {
    triangle(0, 1, 2);
    triangle(0, 2, 3);
  } else {
    triangle(1, 2, 3);
    triangle(1, 3, 0);
  }
}

std::vector<Triangle> rimTriangles(const HermiteGrid& grid, const DualSurface& dual) {
  constexpr std::size_t kPerTask = 1024;
  return gather<Triangle>(dual.rims.size(), kPerTask, [&](std::size_t n, auto& part) {
    addRim(dual.rims[n], grid, dual, part);
  });
}

/// Resizes the list, with spare capacity for elements that mending adds.
template <class T>
void resizeWithRoom(std::vector<T>& list, std::size_t size, const T& value) {
  list.reserve(size + size / 32);
  list.resize(size, value);
}

/// Joins the vertices and polygons of all layers into one surface, in three passes: count, reserve,
/// fill.
class SurfaceAssembler {
 public:
  SurfaceAssembler(const HermiteGrid& grid, const DualSurface& dual,
                   std::vector<LayerPolygons>& parts)
      : grid_(grid), dual_(dual), parts_(parts) {}

  Surface assemble(const FacePoints& facePoints, const std::vector<Triangle>& rim) {
    const std::size_t dualVertices = dual_.firstVertex.back();
    surface_.dualVertices = dualVertices;
    count(dualVertices + facePoints.points.size());
    allocate(triangleCount_ + rim.size());
    std::copy(rim.begin(), rim.end(),
              surface_.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangleCount_));
    for (std::size_t f = 0; f < facePoints.points.size(); ++f) {
      setVertex(dualVertices + f, facePoints.points[f], facePoints.times[f]);
    }
    parallelFor(parts_.size(), [&](std::size_t i) {
      if (i + 1 < parts_.size()) fillDualVertices(i);
      fillPolygons(i);
    });
    return std::move(surface_);
  }

 private:
  void count(std::size_t firstExtra) {
    vertexCount_ = firstExtra;
    extraBase_.resize(parts_.size());
    triangleBase_.resize(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      extraBase_[i] = vertexCount_;
      triangleBase_[i] = triangleCount_;
      vertexCount_ += parts_[i].extra.size();
      triangleCount_ += parts_[i].triangles.size();
    }
    if (vertexCount_ >= static_cast<std::size_t>(kExtra)) {
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  "the envelope has " + std::to_string(vertexCount_) +
                      " vertices, but the limit is 1073741824; use a larger cell");
    }
  }

  /// Allocates the lists in parallel, because the operating system clears new memory at its first
  /// use.
  void allocate(std::size_t triangles) {
    parallelActions(
        [&] {
          resizeWithRoom(surface_.mesh.vertices, vertexCount_, {0, 0, 0});
        },
        [&] { resizeWithRoom(surface_.mesh.triangles, triangles, {}); },
        [&] { resizeWithRoom(surface_.crossingOf, triangles, Surface::kNoCrossing); },
        [&] { resizeWithRoom(surface_.contactTime, vertexCount_, 0.0); },
        [&] { surface_.cellFlags.resize(surface_.dualVertices); });
  }

  void setVertex(std::size_t at, const Eigen::Vector3d& g, double time) {
    surface_.mesh.vertices[at] = grid_.plan.origin + grid_.plan.cell * g;
    surface_.contactTime[at] = time;
  }

  void fillDualVertices(std::size_t i) {
    // A tenth of kCellMargin; only vertices that left their cell are nearer to a wall.
    constexpr float kInsideMargin = 1e-5f;
    const auto& layer = dual_.vertices[i];
    const auto sameCell = [&](std::size_t v, std::size_t w) {
      return layer[v].k == layer[w].k && layer[v].j == layer[w].j;
    };
    for (std::size_t v = 0; v < layer.size(); ++v) {
      const DualVertex& d = layer[v];
      const bool inside =
          d.local.minCoeff() > kInsideMargin && d.local.maxCoeff() < 1 - kInsideMargin;
      surface_.cellFlags[dual_.firstVertex[i] + v] = static_cast<std::uint8_t>(
          (inside ? Surface::kInsideCell : 0) |
          (v > 0 && sameCell(v - 1, v) ? Surface::kSharedWithPrevious : 0) |
          (v + 1 < layer.size() && sameCell(v, v + 1) ? Surface::kSharedWithNext : 0));
      setVertex(dual_.firstVertex[i] + v, d.local.cast<double>() + Eigen::Vector3d(d.i, d.j, d.k),
                d.timeSeconds);
    }
  }

  /// Writes the extra vertices and the triangles of a layer, then frees the layer.
  void fillPolygons(std::size_t i) {
    LayerPolygons& part = parts_[i];
    for (std::size_t e = 0; e < part.extra.size(); ++e) {
      setVertex(extraBase_[i] + e, part.extra[e], part.extraTime[e]);
    }
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      Triangle triangle = part.triangles[t];
      for (auto& v : triangle) {
        if (v >= kExtra) v = v - kExtra + static_cast<std::int32_t>(extraBase_[i]);
      }
      surface_.mesh.triangles[triangleBase_[i] + t] = triangle;
    }
    std::copy(part.crossingOf.begin(), part.crossingOf.end(),
              surface_.crossingOf.begin() + static_cast<std::ptrdiff_t>(triangleBase_[i]));
    part = LayerPolygons{};
  }

  const HermiteGrid& grid_;
  const DualSurface& dual_;
  std::vector<LayerPolygons>& parts_;
  std::vector<std::size_t> extraBase_, triangleBase_;  // by layer
  std::size_t vertexCount_ = 0, triangleCount_ = 0;
  Surface surface_;
};

}  // namespace

CrossingEdge edgeOfCrossing(const HermiteGrid& grid, std::uint32_t index) {
  auto layer =
      std::upper_bound(grid.layers.begin(), grid.layers.end(), index,
                       [](std::uint32_t x, const HermiteLayer& l) { return x < l.firstCrossing; }) -
      1;
  for (int axis = 2; axis >= 0; --axis) {
    const auto& edges = layer->edges[axis];
    if (edges.empty() || edges.front().first > index) continue;
    const auto edge =
        std::upper_bound(edges.begin(), edges.end(), index,
                         [](std::uint32_t x, const HermiteEdge& e) { return x < e.first; }) -
        1;
    const auto& start = layer->columnStart[axis];
    const auto column = std::upper_bound(start.begin(), start.end(),
                                         static_cast<std::uint32_t>(edge - edges.begin())) -
                        1;
    return {axis, static_cast<std::int32_t>(layer - grid.layers.begin()),
            static_cast<std::int32_t>(column - start.begin()), edge->k};
  }
  throw Error(Status::InternalError, "InternalError", "a crossing without an edge");
}

Eigen::Vector3d positionOfCrossing(const HermiteGrid& grid, const CrossingEdge& edge,
                                   std::uint32_t index) {
  Eigen::Vector3d p(edge.i, edge.j, edge.k);
  p[edge.axis] += grid.crossings[index].fraction;
  return p;
}

Surface contourUniform(const HermiteGrid& grid, const Options& options, RunContext& run,
                       const SurfaceProbe* probe) {
  DualSurface dual = buildDualSurface(grid, options.components, probe, run);
  const FacePoints facePoints = findFacePoints(grid, dual);

  const auto layers = static_cast<std::size_t>(grid.plan.points[0]);
  const auto firstFacePoint = static_cast<std::int32_t>(dual.firstVertex.back());
  std::vector<LayerPolygons> parts(layers);
  parallelBlocks(layers, 4, [&](std::size_t begin, std::size_t end) {
    LayerEmitter emitter(grid, dual, facePoints, firstFacePoint);
    run.checkpoint(Phase::Contour, layers + begin, 2 * layers);
    for (std::size_t i = begin; i < end; ++i) emitter.emit(static_cast<std::int32_t>(i), parts[i]);
  });
  const std::vector<Triangle> rim = rimTriangles(grid, dual);
  std::vector<std::array<std::uint32_t, 4>>().swap(dual.quads);
  return SurfaceAssembler(grid, dual, parts).assemble(facePoints, rim);
}

}  // namespace swept
