// Decides whether a lattice line intersects a triangle, and where. The decision is the same exact
// one as in grid/rasterise.h, in 32-bit integers (products in 64 and 96 bits), with the same rule for
// ties. So GPU and CPU find the same lattice edge for every triangle and line.
// SPDX-License-Identifier: LGPL-2.1-or-later

struct Triangle {
  ivec3 a, b, c;  // counter-clockwise in (U, V), third coordinate along the axis
  int axis;
};

struct Crossing {
  ivec3 edge;     // first lattice point of the edge, relative to brickLow
  uint fraction;  // in units of 1 / (2^23 - 1)
};

// Ties are decided as if the lattice were shifted by (e, e^2, e^3) with an infinitely small e, so that
// no lattice line meets an edge of a triangle. For a line exactly on an edge with the direction d,
// returns whether the edge function is positive at the shifted line.
bool tieIsInside(ivec2 d) {
  return d.y < 0 || (d.y == 0 && d.x > 0);
}
bool isInside(uvec2 e, ivec2 d) {
  int s = signOf(e);
  return s > 0 || (s == 0 && tieIsInside(d));
}

// Product and sum of 96-bit integers, which must not be negative. All corners lie inside the grid, so
// all coordinates are positive.
uvec3 times(uvec2 x, uint y) {
  uint h0, l0, h1, l1, carry;
  umulExtended(x.x, y, h0, l0);
  umulExtended(x.y, y, h1, l1);
  uint middle = uaddCarry(h0, l1, carry);
  return uvec3(l0, middle, h1 + carry);
}
uvec3 sum(uvec3 x, uvec3 y) {
  uint c0, c1, c2;
  uint low = uaddCarry(x.x, y.x, c0);
  uint middle = uaddCarry(x.y, y.y, c1);
  middle = uaddCarry(middle, c0, c2);
  return uvec3(low, middle, x.z + y.z + c1 + c2);
}

int normalSign(ivec3 p, ivec3 q, int axis) {
  int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return signOf(crossOf(ivec2(p[i], p[j]), ivec2(q[i], q[j])));
}

// Returns whether the crossing lies above the shifted lattice point k of the line.
bool isAbove(Triangle t, uvec2 e0, uvec2 e1, uvec2 e2, uvec2 area2, int k) {
  int axis = t.axis;
  uvec3 numerator = sum(sum(times(e0, uint(t.a.z)), times(e1, uint(t.b.z))), times(e2, uint(t.c.z)));
  uvec3 point = times(area2, uint(k) << kSubBits);
  for (int i = 2; i >= 0; --i) {
    if (numerator[i] != point[i]) return numerator[i] > point[i];
  }
  // The lattice point lies on the plane. The first axis along which a shift leaves the plane
  // decides.
  ivec3 p = unordered(t.b - t.a, axis), q = unordered(t.c - t.a, axis);
  int along = normalSign(p, q, axis);
  for (int i = 0; i < 3; ++i) {
    if (i == axis) return false;
    int n = normalSign(p, q, i);
    if (n != 0) return (n > 0) != (along > 0);
  }
  return false;
}

double asDouble(uvec2 x) {
  precise double value = double(x.y) * 4294967296.0LF + double(x.x);
  return value;
}

bool findCrossing(Triangle t, ivec2 line, out Crossing crossing) {
  ivec3 a = t.a, b = t.b, c = t.c;
  ivec3 low = ordered(brickLow, t.axis), size = ordered(brickSize, t.axis);
  ivec2 at = line << kSubBits;
  ivec2 d0 = c.xy - b.xy, d1 = a.xy - c.xy, d2 = b.xy - a.xy;
  uvec2 e0 = crossOf(d0, at - b.xy), e1 = crossOf(d1, at - c.xy), e2 = crossOf(d2, at - a.xy);
  if (!(isInside(e0, d0) && isInside(e1, d1) && isInside(e2, d2))) return false;

  uvec2 area2 = plus(plus(e0, e1), e2);
  precise double scale = 1.0LF / (asDouble(area2) * double(kSubUnits));
  precise double g = (asDouble(e0) * double(a.z) + asDouble(e1) * double(b.z) +
                      asDouble(e2) * double(c.z)) * scale;
  int k = int(g);
  precise double fraction = g - double(k);
  const double kNear = 1e-6LF;  // far above the rounding of g
  if (fraction < kNear) {
    if (!isAbove(t, e0, e1, e2, area2, k)) {
      --k;
      fraction = 1.0LF;
    }
  } else if (fraction > 1.0LF - kNear) {
    if (isAbove(t, e0, e1, e2, area2, k + 1)) {
      ++k;
      fraction = 0.0LF;
    }
  }
  ivec3 edge = ivec3(line, k) - low;
  if (any(lessThan(edge, ivec3(0))) || any(greaterThanEqual(edge, size))) return false;
  crossing.edge = unordered(edge, t.axis);
  crossing.fraction = uint(fraction * 8388607.0LF);
  return true;
}
