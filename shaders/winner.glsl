// Pass 2: finds for every contributing edge (a marked edge with at least one end outside) the first
// and last crossing, and their elements.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Round 0 finds the lowest and the highest fraction of each edge. Round 1 finds, for each of the two
// fractions, the lowest number of an element that crosses the edge there. The edges are listed row by
// row, as in the marks of pass 1.

// First, for each row, the index of its first edge; then the number of edges; then the k of each edge.
layout(std430, binding = 6) readonly buffer Targets { uint targets[]; };
// Per edge: lowest fraction, highest fraction, and the numbers of the elements there.
layout(std430, binding = 7) coherent buffer Winners { uint winners[]; };

layout(location = 10) uniform uint secondRound;

void keep(Crossing crossing, int axis, uint id) {
  ivec3 p = crossing.edge;
  uint row = uint(axis * brickSize.x + p.x) * uint(brickSize.y) + uint(p.y);
  uint rows = 3u * uint(brickSize.x) * uint(brickSize.y);
  uint first = targets[row], end = targets[row + 1u], last = end;
  while (first < last) {
    uint middle = (first + last) >> 1;
    if (targets[rows + 1u + middle] < uint(p.z)) first = middle + 1u;
    else last = middle;
  }
  if (first >= end || targets[rows + 1u + first] != uint(p.z)) return;

  uint at = 4u * first, f = crossing.fraction;
  if (secondRound == 0u) {
    if (f < winners[at]) atomicMin(winners[at], f);
    if (f > winners[at + 1u]) atomicMax(winners[at + 1u], f);
  } else {
    if (f == winners[at]) atomicMin(winners[at + 2u], id);
    if (f == winners[at + 1u]) atomicMin(winners[at + 3u], id);
  }
}
