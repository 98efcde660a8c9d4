// Projects the faces and side patches of swept prisms along the three axes.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One invocation per axis draws into the viewport of its axis. Pixel centres are lattice lines. The
// rasteriser gets a polygon slightly larger than the triangle: its Minkowski sum with a square of
// half side kGrow. So every lattice line through the triangle becomes a fragment, however the
// rasteriser rounds corners (to 1/256 pixel), and the fragment stage decides exactly (conservative
// rasterisation, Hasselgren, Akenine-Moeller and Ohlsson 2005).

layout(lines_adjacency, invocations = 3) in;
layout(triangle_strip, max_vertices = 18) out;

in VertexData {
  flat ivec3 point;
  flat uint id;
  flat uint elementKind;
} corner[];

flat out ivec3 a;  // counter-clockwise in (U, V), third coordinate along the axis
flat out ivec3 b;
flat out ivec3 c;
flat out uvec2 idAndAxis;

const float kGrow = 1.0 / 16.0;
const int kFewLines = 6;  // a triangle whose box has at most this many lines is drawn as the box

ivec3 low, size;  // of the brick, ordered for this axis

void put(vec2 pixel, ivec3 p, ivec3 q, ivec3 r) {
  a = p;
  b = q;
  c = r;
  idAndAxis = uvec2(corner[0].id, uint(gl_InvocationID));
  gl_ViewportIndex = gl_InvocationID;
  gl_Position = vec4(pixel / vec2(size.xy) * 2.0 - 1.0, 0.0, 1.0);
  EmitVertex();
}

// Returns the quadrant of a direction. Quadrants are half open. Between the outward normals of two
// successive sides lie 0, 1 or 2 borders of quadrants.
int quadrantOf(ivec2 n) {
  return n.x > 0 && n.y >= 0 ? 0 : n.x <= 0 && n.y > 0 ? 1 : n.x < 0 ? 2 : 3;
}
vec2 squareCorner(int quadrant) {
  int q = quadrant & 3;
  return kGrow * vec2(q == 0 || q == 3 ? 1.0 : -1.0, q < 2 ? 1.0 : -1.0);
}

void triangle(ivec3 p, ivec3 q, ivec3 r) {
  ivec3 least = min(p, min(q, r)), most = max(p, max(q, r));
  ivec2 first = max((least.xy + (kSubUnits - 1)) >> kSubBits, low.xy);
  ivec2 last = min(most.xy >> kSubBits, low.xy + size.xy - 1);
  if (any(greaterThan(first, last))) return;
  if ((most.z >> kSubBits) + 1 < low.z || (least.z >> kSubBits) - 1 >= low.z + size.z) return;
  int turn = signOf(crossOf(q.xy - p.xy, r.xy - p.xy));
  if (turn == 0) return;
  if (turn < 0) {
    ivec3 swap = q;
    q = r;
    r = swap;
  }
  ivec2 lines = last - first + 1;
  if (lines.x <= kFewLines && lines.y <= kFewLines && lines.x * lines.y <= kFewLines) {
    vec2 from = vec2(first - low.xy) + 0.25, to = vec2(last - low.xy) + 0.75;
    put(from, p, q, r);
    put(vec2(to.x, from.y), p, q, r);
    put(vec2(from.x, to.y), p, q, r);
    put(to, p, q, r);
    EndPrimitive();
    return;
  }
  ivec2 corners[3] = ivec2[3](p.xy, q.xy, r.xy);
  int side[3];  // quadrant of the outward normal of the edge that leaves corner i
  for (int i = 0; i < 3; ++i) {
    ivec2 d = corners[(i + 1) % 3] - corners[i];
    side[i] = quadrantOf(ivec2(d.y, -d.x));
  }
  vec2 hull[9];
  for (int i = 0; i < 3; ++i) {
    vec2 at = vec2(corners[i] - (low.xy << kSubBits)) / float(kSubUnits) + 0.5;
    int before = side[(i + 2) % 3], after = side[i];
    int between = ((after - before) & 3) == 2 ? before + 1 : before;
    hull[3 * i] = at + squareCorner(before);
    hull[3 * i + 1] = at + squareCorner(between);
    hull[3 * i + 2] = at + squareCorner(after);
  }
  const int zigzag[9] = int[9](0, 1, 8, 2, 7, 3, 6, 4, 5);
  for (int i = 0; i < 9; ++i) put(hull[zigzag[i]], p, q, r);
  EndPrimitive();
}

void main() {
  if (corner[0].elementKind == 0u) return;
  int axis = gl_InvocationID;
  low = ordered(brickLow, axis);
  size = ordered(brickSize, axis);
  ivec3 p0 = ordered(corner[0].point, axis), p1 = ordered(corner[1].point, axis),
        p2 = ordered(corner[2].point, axis), p3 = ordered(corner[3].point, axis);
  triangle(p0, p1, p2);
  if (corner[0].elementKind == 2u) triangle(p0, p2, p3);
}
