// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/element_probe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "sampling/culling/swept_elements.h"

namespace swept {
namespace {

/// After this many pieces (element_probe.h) in a cell, the search ends. It visits the nearest
/// pieces first, so the others seldom matter. Measured on a ring gear with teeth of half a cell,
/// along 3,413 poses of a robot arm that pauses and shakes. With limits of 200, 500 and 1,000, the
/// mean deviation from an envelope with cells a quarter as wide is 0.0528, 0.0529 and 0.0527 cells
/// (0.0526 with 20,000). The test ThinPlate, whose faces slide in their own planes, needs 500.
constexpr std::size_t kMaxPieces = 1000;
/// After this many pieces in a cell, the search leaves out pieces for which isCovered() is true.
/// On the same gear, limits of 0, 30, 100 and 300 give mean deviations of 0.0555, 0.0541, 0.0528
/// and 0.0526 cells, and contouring takes 0.7, 0.8, 1.3 and 1.8 s.
constexpr std::size_t kManyPieces = 100;
/// Pieces within this distance (cells) of the cell count as touching it, so that the search can
/// pass around the corners of the cell.
constexpr double kSearchMargin = 0.05;

/// Enlarges triangles slightly, so that a line through a common edge hits both triangles, not none.
constexpr double kEdgeSlack = 1e-7;

/// Where a line intersects a triangle: fraction along the line, and barycentric coordinates.
struct Hit {
  double along, u, v;
};

bool intersects(const ProbeLine& line, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c, Hit& out) {
  const Eigen::Vector3d d = line.to - line.from, ab = b - a, ac = c - a;
  const Eigen::Vector3d p = d.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-14) return false;
  const Eigen::Vector3d s = line.from - a;
  out.u = s.dot(p) / det;
  if (out.u < -kEdgeSlack || out.u > 1 + kEdgeSlack) return false;
  const Eigen::Vector3d q = s.cross(ab);
  out.v = d.dot(q) / det;
  if (out.v < -kEdgeSlack || out.u + out.v > 1 + kEdgeSlack) return false;
  out.along = ac.dot(q) / det;
  return out.along >= 0 && out.along <= 1;
}

/// Returns whether a point lies in the box about the origin with half sizes `half`.
bool inBox(const Eigen::Vector3d& p, const Eigen::Vector3d& half) {
  return std::abs(p[0]) <= half[0] && std::abs(p[1]) <= half[1] && std::abs(p[2]) <= half[2];
}

/// Returns whether a triangle intersects the box about the origin with half sizes `half`, by
/// separating axes (Akenine-Moeller 2001).
bool intersectsBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& half) {
  if (inBox(a, half) || inBox(b, half) || inBox(c, half)) return true;
  const auto beyond = [](double x, double y, double z, double reach) {
    return std::min({x, y, z}) > reach || std::max({x, y, z}) < -reach;
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (beyond(a[axis], b[axis], c[axis], half[axis])) return false;
  }
  const std::array<Eigen::Vector3d, 3> side{b - a, c - b, a - c};
  const Eigen::Vector3d n = side[0].cross(side[1]);
  if (beyond(n.dot(a), n.dot(b), n.dot(c), half.dot(n.cwiseAbs()))) return false;
  for (const Eigen::Vector3d& s : side) {
    for (int axis = 0; axis < 3; ++axis) {  // tests the cross product of `axis` and s
      const int p = (axis + 1) % 3, q = (axis + 2) % 3;
      const auto along = [&](const Eigen::Vector3d& x) { return s[p] * x[q] - s[q] * x[p]; };
      if (beyond(along(a), along(b), along(c),
                 half[q] * std::abs(s[p]) + half[p] * std::abs(s[q]))) {
        return false;
      }
    }
  }
  return true;
}

/// Returns whether a segment intersects the box about the origin with half sizes `half`.
bool intersectsBox(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                   const Eigen::Vector3d& half) {
  if (inBox(p, half) || inBox(q, half)) return true;
  const Eigen::Vector3d middle = (p + q) / 2, direction = (q - p) / 2;
  const Eigen::Vector3d reach = direction.cwiseAbs();
  if ((middle.cwiseAbs().array() > (half + reach).array()).any()) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double across = middle[u] * direction[v] - middle[v] * direction[u];
    if (std::abs(across) > half[u] * reach[v] + half[v] * reach[u]) return false;
  }
  return true;
}

}  // namespace

/// Directions of faces during steps of the motion, as directionOf() returns them. Keeps the steps
/// and directions used last.
class ElementProbe::Directions {
 public:
  explicit Directions(const SamplerInput& input) : input_(input) {}
  int of(std::size_t face, std::size_t step) {
    if (cache_.empty()) cache_.resize(kCached);
    const std::uint64_t key = static_cast<std::uint64_t>(step) << 32 | face;
    Cached& known = cache_[(key * 0x9e3779b97f4a7c15u >> 32) & (kCached - 1)];
    if (known.key != key) known = {key, directionOf(input_, at(step), face)};
    return known.direction;
  }

 private:
  static constexpr std::size_t kCached = 1024;  // a power of two
  struct Cached {
    std::uint64_t key = ~std::uint64_t{0};
    int direction = 0;
  };
  const MotionStep& at(std::size_t step) {
    auto& [number, known] = slots_[step % slots_.size()];
    if (!known || number != step) {
      number = step;
      known.emplace(input_, step);
    }
    return *known;
  }

  const SamplerInput& input_;
  std::array<std::pair<std::size_t, std::optional<MotionStep>>, 64> slots_;
  std::vector<Cached> cache_;
};

namespace {

/// Calls use(crossing) for the crossings of the cells that the box touches, and of the cells around
/// them. Units: grid coordinates.
template <class Use>
void forCrossingsAround(const HermiteGrid& grid, const Eigen::AlignedBox3d& box, const Use& use) {
  const Eigen::Array3i low = box.min().array().floor().cast<int>() - 1;
  const Eigen::Array3i high = box.max().array().ceil().cast<int>() + 1;
  const int layers = static_cast<int>(grid.layers.size());
  for (int i = std::max(0, low[0]); i <= std::min(layers - 1, high[0]); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& edges = grid.layers[i].edges[axis];
      const auto& start = grid.layers[i].columnStart[axis];
      const int columns = static_cast<int>(start.size()) - 1;
      for (int j = std::max(0, low[1]); j <= std::min(columns - 1, high[1]); ++j) {
        const auto end = edges.begin() + start[j + 1];
        auto edge = std::lower_bound(edges.begin() + start[j], end, low[2],
                                     [](const HermiteEdge& e, int k) { return e.k < k; });
        for (; edge != end && edge->k <= high[2]; ++edge) {
          use(edge->first);
          if (edge->sides == (HermiteEdge::kLow | HermiteEdge::kHigh)) use(edge->first + 1);
        }
      }
    }
  }
}

/// A hash set of elements, sized for a few dozen.
class SeenElements {
 public:
  /// Adds the element. Returns false if the set has it already.
  bool insert(const SweptElement& element) {
    if (2 * count_ >= slots_.size()) grow();
    const auto key = static_cast<std::uint64_t>(element.code) << 32 | element.placement;
    return put(key);
  }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};  // no element has this key
  bool put(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (slots_[at] != kFree && slots_[at] != key) at = (at + 1) & mask;
    if (slots_[at] == key) return false;
    slots_[at] = key;
    ++count_;
    return true;
  }
  void grow() {
    std::vector<std::uint64_t> old(std::max<std::size_t>(128, 4 * slots_.size()), kFree);
    old.swap(slots_);
    count_ = 0;
    for (const std::uint64_t key : old) {
      if (key != kFree) put(key);
    }
  }

  std::vector<std::uint64_t> slots_;
  std::size_t count_ = 0;
};

}  // namespace

ElementProbe::ElementProbe(const SamplerInput& input, const std::vector<SweptElement>& elements,
                           const std::vector<std::uint32_t>& winner, const HermiteGrid& grid)
    : input_(input), elements_(elements), winner_(winner), grid_(grid) {
  placements_.reserve(input.motion.placements.size());
  for (const Placement& p : input.motion.placements) placements_.push_back(input.grid.toGrid(p));
  faceEdges_.assign(input.body.triangles.size(), {-1, -1, -1});
  const auto& edges = input.topology.edges;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const std::int32_t face : {edges[e].left, edges[e].right}) {
      if (face < 0) continue;
      for (std::int32_t& slot : faceEdges_[face]) {
        if (slot >= 0) continue;
        slot = static_cast<std::int32_t>(e);
        break;
      }
    }
  }
}

ElementProbe::Piece ElementProbe::pieceOf(const SweptElement& element) const {
  Piece piece;
  piece.isSidePatch = element.isSidePatch();
  const Placement& p = placements_[element.placement];
  piece.start = piece.end = p.timeSeconds;
  const auto& x = input_.body.vertices;
  if (piece.isSidePatch) {
    const Placement& q = placements_[element.placement + 1];
    const BodyEdge& e = input_.topology.edges[element.index()];
    piece.corner = {p.apply(x[e.a]), p.apply(x[e.b]), q.apply(x[e.b]), q.apply(x[e.a])};
    piece.end = q.timeSeconds;
  } else {
    const auto& t = input_.body.triangles[element.index()];
    piece.corner = {p.apply(x[t[0]]), p.apply(x[t[1]]), p.apply(x[t[2]]), p.apply(x[t[2]])};
  }
  return piece;
}

// Neighbouring pieces share an edge, the path of a vertex, or a face. inside() tests whether a
// shared edge or path passes through the searched cell.
template <class Inside, class Use>
void ElementProbe::forNeighbours(const SweptElement& element, const Piece& piece,
                                 const Inside& inside, const Use& use) const {
  const std::uint32_t k = element.placement;
  const std::size_t steps = input_.motion.steps();
  const auto sidePatch = [&](std::int32_t edge, std::uint32_t step) {
    use(SweptElement{static_cast<std::uint32_t>(edge) | SweptElement::kSidePatchBit, step});
  };
  const auto face = [&](std::int32_t f, std::uint32_t placement) {
    if (f >= 0) use(SweptElement{static_cast<std::uint32_t>(f), placement});
  };
  if (!element.isSidePatch()) {
    const auto& t = input_.body.triangles[element.index()];
    const auto cornerOf = [&](std::int32_t v) -> const Eigen::Vector3d& {
      return piece.corner[v == t[0] ? 0 : v == t[1] ? 1 : 2];
    };
    for (const std::int32_t e : faceEdges_[element.index()]) {
      if (e < 0) continue;
      const BodyEdge& edge = input_.topology.edges[e];
      if (!inside(cornerOf(edge.a), cornerOf(edge.b))) continue;
      if (k < steps) sidePatch(e, k);
      if (k > 0 && k - 1 < steps) sidePatch(e, k - 1);
      face(edge.left, k);
      face(edge.right, k);
    }
    const auto f = static_cast<std::int32_t>(element.index());
    if (k < steps) face(f, k + 1);
    if (k > 0 && k - 1 < steps) face(f, k - 1);
    return;
  }
  const auto e = static_cast<std::int32_t>(element.index());
  const BodyEdge& edge = input_.topology.edges[e];
  const auto& [a, b, c, d] = piece.corner;
  const bool atStart = inside(a, b), atEnd = inside(c, d), pathA = inside(a, d),
             pathB = inside(b, c);
  if (atStart && k > 0) sidePatch(e, k - 1);
  if (atEnd && k + 1 < steps) sidePatch(e, k + 1);
  for (const std::int32_t f : {edge.left, edge.right}) {
    if (f < 0) continue;
    if (atStart) face(f, k);
    if (atEnd) face(f, k + 1);
    if (!pathA && !pathB) continue;
    for (const std::int32_t other : faceEdges_[f]) {
      if (other < 0 || other == e) continue;
      const BodyEdge& beside = input_.topology.edges[other];
      const bool sharesA = beside.a == edge.a || beside.b == edge.a;
      if (sharesA ? pathA : pathB) sidePatch(other, k);
    }
  }
}

/// Returns whether the pieces before and after this one in the motion cover it, so that it does not
/// lie on the envelope (sampling/culling/swept_elements.h).
bool ElementProbe::isCovered(const SweptElement& element, Directions& directions) const {
  const std::size_t k = element.placement;
  const auto directionIn = [&](std::size_t step, std::int32_t face) {
    return directions.of(static_cast<std::size_t>(face), step);
  };
  if (!element.isSidePatch()) {
    const auto face = static_cast<std::int32_t>(element.index());
    const bool hasBefore = k > 0, hasAfter = k < input_.motion.steps();
    return faceIsEnclosed(hasBefore ? directionIn(k - 1, face) : 0,
                          hasAfter ? directionIn(k, face) : 0, hasBefore, hasAfter,
                          input_.orientable);
  }
  const BodyEdge& edge = input_.topology.edges[element.index()];
  if (edge.right < 0) return false;
  const int left = directionIn(k, edge.left);
  if (left == 0) return false;
  const int right = directionIn(k, edge.right);
  return left == (edge.opposed ? -right : right);
}

std::vector<ElementProbe::Piece> ElementProbe::gather(
    const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings) const {
  const Eigen::Vector3d centre = region.center();
  const Eigen::Vector3d half = region.sizes().array() / 2 + kSearchMargin;
  std::vector<SweptElement> found;  // the elements of `pieces`
  SeenElements seen;
  Directions directions(input_);
  std::vector<Piece> pieces;
  const auto visit = [&](const SweptElement& element) {
    if (!seen.insert(element)) return;
    const Piece piece = pieceOf(element);
    const auto& [a, b, c, d] = piece.corner;
    if (!intersectsBox(a - centre, b - centre, c - centre, half) &&
        (!piece.isSidePatch || !intersectsBox(a - centre, c - centre, d - centre, half))) {
      return;
    }
    if (pieces.size() >= kManyPieces && skipsCovered() && isCovered(element, directions)) return;
    found.push_back(element);
    pieces.push_back(piece);
  };
  const auto visitCrossing = [&](std::uint32_t crossing) { visit(elements_[winner_[crossing]]); };
  std::for_each(crossings.begin(), crossings.end(), visitCrossing);
  forCrossingsAround(grid_, region, visitCrossing);
  const auto inside = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return intersectsBox(p - centre, q - centre, half);
  };
  for (std::size_t at = 0; at < found.size() && pieces.size() < kMaxPieces; ++at) {
    const SweptElement element = found[at];
    const Piece piece = pieces[at];
    forNeighbours(element, piece, inside, visit);
  }
  return pieces;
}

void ElementProbe::castOne(const Piece& piece, ProbeLine& line, double& first) {
  const auto &a = piece.corner[0], &b = piece.corner[1], &c = piece.corner[2],
             &d = piece.corner[3];  // older compilers cannot capture structured bindings
  const auto take = [&](const Hit& at, double r, double s) {
    if (at.along >= first) return;
    first = at.along;
    line.hit = true;
    // The side patch is bilinear, so its normal depends on the position.
    const Eigen::Vector3d n =
        piece.isSidePatch ? ((1 - s) * (b - a) + s * (c - d)).cross((1 - r) * (d - a) + r * (c - b))
                          : (b - a).cross(c - a);
    line.normal = n.normalized();
    line.timeSeconds = piece.start + s * (piece.end - piece.start);
  };
  Hit at{};
  if (intersects(line, a, b, c, at)) take(at, at.u + at.v, at.v);
  if (piece.isSidePatch && intersects(line, a, c, d, at)) take(at, at.u, at.u + at.v);
}

void ElementProbe::cast(const Eigen::AlignedBox3d& region,
                        const std::vector<std::uint32_t>& crossings,
                        std::vector<ProbeLine>& lines) const {
  std::vector<double> first(lines.size(), 2);  // fraction along each line; 2: no hit
  for (const Piece& piece : gather(region, crossings)) {
    const auto& [a, b, c, d] = piece.corner;
    const Eigen::Vector3d n = (b - a).cross(c - a);
    // A line wholly above or below the piece cannot hit it. Heights are measured from the plane of
    // the first triangle. The fourth corner of a side patch need not lie in this plane.
    const double fourth = n.dot(d - a);
    const double low = std::min(0.0, fourth), high = std::max(0.0, fourth);
    const double slack = kEdgeSlack * n.norm();
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const double from = n.dot(lines[l].from - a), to = n.dot(lines[l].to - a);
      if (std::min(from, to) > high + slack || std::max(from, to) < low - slack) continue;
      castOne(piece, lines[l], first[l]);
    }
  }
  for (std::size_t l = 0; l < lines.size(); ++l) {
    ProbeLine& line = lines[l];
    if (!line.hit) continue;
    const Eigen::Vector3d d = line.to - line.from;
    line.point = line.from + first[l] * d;
    if (line.normal.dot(d) > 0) line.normal = -line.normal;
  }
}

}  // namespace swept
