// Pass 1: marks crossed lattice edges, one bit per edge, 32 edges along z per texel.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Image: x = k / 32, y = j, z = axis * (layers of the brick) + i.

layout(r32ui, binding = 0) uniform coherent uimage3D marks;

void main() {
  Crossing crossing;
  if (!findCrossing(crossing)) return;
  ivec3 p = crossing.edge;
  ivec3 texel = ivec3(p.z >> 5, p.y, int(idAndAxis.y) * brickSize.x + p.x);
  uint bit = 1u << uint(p.z & 31);
  if ((imageLoad(marks, texel).x & bit) == 0u) imageAtomicOr(marks, texel, bit);
}
