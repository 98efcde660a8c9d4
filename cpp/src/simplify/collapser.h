// One worker of the edge collapse (collapse.h). It processes one slab of the mesh, or the whole
// mesh.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "simplify/collapse.h"
#include "simplify/collapse_log.h"
#include "simplify/moving_boxes.h"

namespace swept {

/// The part of the mesh that one worker processes. The worker may only change vertices whose entry
/// in partOf is its number. The coordinate of these vertices along the axis stays within [low,
/// high).
struct WorkPart {
  /// For each vertex, the number of its worker. Null: all vertices belong to this worker.
  const std::vector<std::int32_t>* partOf = nullptr;
  std::int32_t number = 0;
  int axis = 0;
  double low = -1e300, high = 1e300;
  std::vector<std::int32_t> vertices;  ///< start vertices, in ascending order
  /// The triangles of the worker, and all others that may intersect them.
  std::vector<std::int32_t> triangles;
};

class Collapser {
 public:
  /// `log`, unless null, receives each step.
  Collapser(CollapseState& state, const WorkPart& part, RunContext& run, CollapseLog* log)
      : state_(state), part_(part), run_(run), log_(log), boxes_(state.mesh, part.triangles) {}
  /// Collapses edges, starting at the edges of part.vertices, until no collapse is possible.
  void work();

 private:
  struct Entry {
    double cost;
    std::int32_t from, to;  // vertex `from` is merged into `to`
    std::uint32_t stampFrom, stampTo;
    bool operator<(const Entry& o) const {
      if (cost != o.cost) return cost > o.cost;
      return std::tie(from, to) > std::tie(o.from, o.to);
    }
  };
  using Corners = std::array<std::int32_t, 3>;
  using Point = Eigen::Vector3d;

  const Point& at(std::int32_t v) const { return state_.mesh.vertices[v]; }
  bool isMine(std::int32_t v) const {
    return part_.partOf == nullptr || (*part_.partOf)[v] == part_.number;
  }
  bool isFree(std::int32_t v) const { return state_.kind[v] == VertexKind::Free; }
  void neighbours(std::int32_t v, std::vector<std::int32_t>& result) const;
  bool isBorderEdge(std::int32_t a, std::int32_t b) const;
  bool mayMerge(std::int32_t from, std::int32_t to) const;
  Point bestPosition(std::int32_t from, std::int32_t to) const;
  void push(std::int32_t a, std::int32_t b);
  void pushAround(std::int32_t v, bool once);
  bool borderStaysNear(std::int32_t from, std::int32_t to);
  bool turnsOver(const std::array<Point, 3>& next, const LabelSurface& surface) const;
  bool linkIsSimple(std::int32_t from, std::int32_t to);
  void collapse(std::int32_t from, std::int32_t to);
  bool tryCollapse(std::int32_t from, std::int32_t to, const Point& position);
  bool hasGoodShapes(std::int32_t from, std::int32_t to, const Point& position);
  bool reattachAll(std::int32_t from, std::int32_t to);
  bool reattachPoints(std::int32_t triangle, std::int32_t before);
  bool reattach(const Point& p, std::int32_t before);
  bool isNearOriginal(const Point& p);
  double spacingFor(Care care) const;
  bool staysNearOriginal(std::int32_t from, std::int32_t to, const Point& position);
  bool intersectsOthers();
  bool intersectedBefore(std::int32_t other) const;
  bool intersect(std::int32_t triangle, std::int32_t other) const;
  void moveCorners(std::int32_t from, std::int32_t to, const Point& position);
  void apply(std::int32_t from, std::int32_t to);

  CollapseState& state_;
  const WorkPart& part_;
  RunContext& run_;
  CollapseLog* log_;
  MovingBoxes boxes_;
  std::priority_queue<Entry> queue_;
  // Buffers. They are members so that their memory is reused.
  std::vector<std::int32_t> ring_, otherRing_, common_;
  std::vector<std::int32_t> remaining_, removed_;  // triangles
  std::vector<Corners> before_;  // vertices of the remaining triangles before the step
  std::vector<std::array<Point, 3>> corners_;  // vertices of these triangles after the step
  // Attached points, each with the index in remaining_ of its new triangle.
  std::vector<std::pair<Point, std::int32_t>> reattached_;
  std::vector<std::int32_t> hits_;
  // Triangles near the remaining ones, with their boxes.
  std::vector<std::pair<std::int32_t, MovingBoxes::Box>> around_;
  std::int32_t nearest_ = -1;  // triangle of the original near the last point tested
  // Triangle of the original near the new position of vertex `to`.
  std::int32_t nearPosition_ = -1;
};

}  // namespace swept
