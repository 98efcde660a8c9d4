// Used by both passes: the fine lattice, the current brick, and 64-bit integers.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A vertex is three odd integers in units of 2^-17 cell; lattice lines lie at multiples of 2^17.
// A lattice line along axis W = 0, 1, 2 is identified by its coordinates along the other two axes,
// U and V, in ascending order of the axes; ordered(p, W) is (p.U, p.V, p.W).

const int kSubBits = 17;
const int kSubUnits = 1 << kSubBits;

layout(location = 0) uniform ivec3 brickLow;   // first lattice point of the brick
layout(location = 1) uniform ivec3 brickSize;  // number of lattice points along each axis

ivec3 ordered(ivec3 p, int axis) {
  return axis == 0 ? p.yzx : axis == 1 ? p.xzy : p.xyz;
}
ivec3 unordered(ivec3 p, int axis) {
  return axis == 0 ? p.zxy : axis == 1 ? p.xzy : p.xyz;
}

// 64-bit integers in two's complement, stored as (low, high).
uvec2 product(int x, int y) {
  int high, low;
  imulExtended(x, y, high, low);
  return uvec2(uint(low), uint(high));
}
uvec2 minus(uvec2 x, uvec2 y) {
  uint borrow;
  uint low = usubBorrow(x.x, y.x, borrow);
  return uvec2(low, x.y - y.y - borrow);
}
uvec2 plus(uvec2 x, uvec2 y) {
  uint carry;
  uint low = uaddCarry(x.x, y.x, carry);
  return uvec2(low, x.y + y.y + carry);
}
int signOf(uvec2 x) {
  return int(x.y) < 0 ? -1 : (x.x | x.y) == 0u ? 0 : 1;
}
// Returns a.x * b.y - a.y * b.x.
uvec2 crossOf(ivec2 a, ivec2 b) {
  return minus(product(a.x, b.y), product(a.y, b.x));
}
