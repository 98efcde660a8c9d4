// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/ring_sides.h"

#include <algorithm>

namespace swept {

RingSides::RingSides(const Cell& cell, const Crossing* crossings,
                     const std::vector<CellRing>& rings)
    : cell_(cell), crossings_(crossings), rings_(rings) {
  for (const CellRing& ring : rings) cuts_.push_back(cut(ring));
}

RingSides::Cut RingSides::cut(const CellRing& ring) const {
  Cut out;
  out.corners.fill(Side::Unknown);
  for (int face = 0; face < kFaces; ++face) cutFace(ring, face, out);
  // A face without chords lies wholly on one side of the ring: the side of any of its corners.
  // Faces with chords determine the side of their corners first; the loop then passes the sides on
  // from face to face.
  const auto firstCorner = static_cast<std::int32_t>(2 * ring.slots.size());
  for (int round = 0; round < kFaces; ++round) {
    for (std::size_t p = 0; p < out.pieces.size(); ++p) {
      for (const std::int32_t c : out.pieces[p].corners) {
        if (c < firstCorner) continue;
        Side& corner = out.corners[c - firstCorner];
        if (out.sides[p] == Side::Unknown) out.sides[p] = corner;
        if (corner == Side::Unknown) corner = out.sides[p];
      }
    }
  }
  return out;
}

void RingSides::cutFace(const CellRing& ring, int face, Cut& out) const {
  const auto count = static_cast<std::int32_t>(ring.slots.size());
  // The points on a walk round the face, as indices of wallPoints().
  Loop walk;
  for (const FaceStep& step : kFaceWalks[face]) {
    walk.push_back(2 * count + cornerOf(step.edge, step.backward ? 1 : 0));
    for (int side = 0; side < 2; ++side) {
      const int slot = 2 * step.edge + (step.backward ? 1 - side : side);
      const auto at = std::find(ring.slots.begin(), ring.slots.end(), slot);
      if (at != ring.slots.end())
        walk.push_back(2 * static_cast<std::int32_t>(at - ring.slots.begin()));
    }
  }
  const std::size_t n = walk.size();
  const auto isCrossing = [&](std::size_t k) { return walk[k] < 2 * count; };
  const auto walkIndexOf = [&](std::int32_t number) {
    return static_cast<std::size_t>(std::find(walk.begin(), walk.end(), number) - walk.begin());
  };
  std::vector<bool> visited(n);
  for (std::size_t start = 0; start < n; ++start) {
    if (visited[start]) continue;
    Piece piece{face, {}};
    Side side = Side::Unknown;
    std::size_t at = start;
    do {
      visited[at] = true;
      piece.corners.push_back(walk[at]);
      const std::size_t next = (at + 1) % n;
      at = next;
      if (!isCrossing(next)) continue;
      // Follow the chord to the crossing at its other end.
      const std::int32_t k = walk[next] / 2;
      const bool forward = ring.faces[k] == face;
      const std::int32_t chord = forward ? k : (k + count - 1) % count;
      piece.corners.push_back(walk[next]);
      piece.corners.push_back(2 * chord + 1);
      at = walkIndexOf(2 * (forward ? (k + 1) % count : chord));
      side = forward ? Side::Left : Side::Right;
    } while (at != start);
    if ((face & 1) == 0) {  // the walk round this face is clockwise seen from outside
      std::reverse(piece.corners.begin(), piece.corners.end());
      if (side != Side::Unknown) side = side == Side::Left ? Side::Right : Side::Left;
    }
    out.pieces.push_back(std::move(piece));
    out.sides.push_back(side);
  }
}

std::vector<Eigen::Vector3d> RingSides::wallPoints(std::size_t ring) const {
  const CellRing& r = rings_[ring];
  std::vector<Eigen::Vector3d> points;
  for (std::size_t n = 0; n < r.slots.size(); ++n) {
    const int next = r.slots[(n + 1) % r.slots.size()];
    points.push_back(apartPosition(cell_, r.slots[n], crossings_));
    points.push_back(chordPoint(cell_, r.faces[n], r.slots[n], next, crossings_));
  }
  for (int c = 0; c < 8; ++c) points.emplace_back(c & 1, c >> 1 & 1, c >> 2 & 1);
  return points;
}

bool RingSides::isLeft(std::size_t of, std::size_t other) const {
  const int slot = rings_[other].slots.front(), edge = slot >> 1;
  const double fraction = apartFraction(cell_, slot, crossings_);
  bool left = cuts_[of].corners[cornerOf(edge, 0)] == Side::Left;
  for (const std::int8_t s : rings_[of].slots) {
    if (s >> 1 == edge && apartFraction(cell_, s, crossings_) < fraction) left = !left;
  }
  return left;
}

Nesting RingSides::nesting() const {
  const std::size_t count = rings_.size();
  Nesting best;
  int fewest = 0;
  // The rings divide the walls of the cell into regions. Any allowed choice of sides leaves exactly
  // one region outside all chosen sides. Try each region beside ring `root`: on its right if
  // `left`, otherwise on its left. Each other ring then gets the side without `root`. Take the
  // choice whose sides contain the fewest corners of the cell.
  for (std::size_t root = 0; root < count; ++root) {
    for (const bool left : {true, false}) {
      Nesting nesting{std::vector<bool>(count), std::vector<int>(count, 1)};
      int corners = 0;
      for (std::size_t r = 0; r < count; ++r) {
        nesting.left[r] = r == root ? left : !isLeft(r, root);
        const Side side = nesting.left[r] ? Side::Left : Side::Right;
        corners +=
            static_cast<int>(std::count(cuts_[r].corners.begin(), cuts_[r].corners.end(), side));
      }
      if (!best.left.empty() && corners >= fewest) continue;
      fewest = corners;
      best = nesting;
    }
  }
  for (std::size_t round = 1; round < count; ++round) {
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t other = 0; other < count; ++other) {
        if (other != r && isLeft(r, other) == best.left[r])
          best.height[r] = std::max(best.height[r], best.height[other] + 1);
      }
    }
  }
  return best;
}

std::vector<RingSides::Piece> RingSides::pieces(std::size_t ring, bool left) const {
  std::vector<Piece> out;
  const Cut& cut = cuts_[ring];
  for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
    if (cut.sides[p] == (left ? Side::Left : Side::Right)) out.push_back(cut.pieces[p]);
  }
  return out;
}

}  // namespace swept
