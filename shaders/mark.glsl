// Pass 1: marks crossed lattice edges, one bit per edge, 32 edges along z per word.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Edge (axis, i, j, k) has bit k % 32 of word k / 32 in the row (axis * brickSize.x + i) *
// brickSize.y + j.

layout(std430, binding = 6) coherent buffer Marks { uint marks[]; };

void keep(Crossing crossing, int axis, uint id) {
  ivec3 p = crossing.edge;
  uint words = uint(brickSize.z + 31) >> 5;
  uint row = uint(axis * brickSize.x + p.x) * uint(brickSize.y) + uint(p.y);
  uint word = row * words + uint(p.z >> 5), bit = 1u << uint(p.z & 31);
  if ((marks[word] & bit) == 0u) atomicOr(marks[word], bit);
}
