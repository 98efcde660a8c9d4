// Decides which elements of the swept surface are culled, and computes the snapped corners of elements.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Elements are numbered placement by placement: at each placement all faces and then, for a
// continuous motion, the side patches of all edges in the step that starts there. Each element has
// four corners. The corners of a face are its three vertices at its placement (the fourth is not
// used). The corners of the side patch of an edge (a, b) are a and b at the start of the step, then
// b and a at the end of the step.

layout(std430, binding = 0) readonly buffer Vertices { double vertices[]; };      // x, y, z each
// 3 vertices per face, then 4 numbers per edge: the two vertices, the left face, and 2 * right face
// + (1 if the directions of the faces are opposed), or -1 if the side patch is never enclosed.
layout(std430, binding = 1) readonly buffer Topology { int topology[]; };
layout(std430, binding = 2) readonly buffer Placements { double placements[]; };  // 3 rows of 4
// 6 rows per step, as in MotionStep of sampling/culling/swept_elements.h. Seen from the body at the
// start of the step, a point p moves by bend * p + shift: rows 0 to 2 are bend, with shift in w. Rows 3
// to 5 are turnBack (the turn of the step, transposed). Their w are the angle (rad), the effect of
// snapping (mm) and the rounding in single precision (mm). The first step ends at the first placement.
layout(std430, binding = 3) readonly buffer Steps { vec4 steps[]; };
layout(std430, binding = 4) readonly buffer ExactSteps { dvec4 exactSteps[]; };  // the same in double precision
// 2 rows per face: centre and radius of a ball around it; normal, and the angle by which snapping may turn it.
layout(std430, binding = 5) readonly buffer Balls { vec4 balls[]; };

layout(location = 2) uniform uint placementBase;   // first placement in the buffer
layout(location = 3) uniform uint placementCount;  // number of placements of the whole motion
layout(location = 4) uniform uint faceCount;
layout(location = 5) uniform uint elementCount;    // elements of one placement
layout(location = 6) uniform uint culling;         // 0: none, 1: open body, 2: closed body

struct Element {
  uint kind;      // 0: nothing, 1: face, 2: side patch
  uint which;     // face or edge
  uint placement;
};

dvec3 vertexAt(uint vertex) {
  return dvec3(vertices[3u * vertex], vertices[3u * vertex + 1u], vertices[3u * vertex + 2u]);
}

// The functions below decide like directionOf() in sampling/culling/swept_elements.cpp: +1 if all
// points of the face move outward during the step, -1 if all move inward, else 0. decideBall()
// decides most faces in single precision; where it returns 0, the corners decide.
int decideBall(uint face, uint s) {
  vec4 ball = balls[2u * face], normal = balls[2u * face + 1u];
  vec4 centre = vec4(ball.xyz, 1.0);
  vec3 d = vec3(dot(steps[s], centre), dot(steps[s + 1u], centre), dot(steps[s + 2u], centre));
  vec4 x = steps[s + 3u], y = steps[s + 4u], z = steps[s + 5u];
  float angle = x.w, snap = y.w, rounding = z.w;
  float first = dot(normal.xyz, d);
  float second = dot(normal.xyz, vec3(dot(x.xyz, d), dot(y.xyz, d), dot(z.xyz, d)));
  float reach = angle * ball.w;
  float travel = abs(d.x) + abs(d.y) + abs(d.z) + reach;
  float margin = reach + travel * (angle * angle + 1e-5 + normal.w) + snap + rounding;
  return min(first, second) > margin ? 1 : max(first, second) < -margin ? -1 : 0;
}
int decideCorners(uint face, uint s) {
  dvec3 n = dvec3(balls[2u * face + 1u].xyz);
  dvec4 x = exactSteps[s + 3u], y = exactSteps[s + 4u], z = exactSteps[s + 5u];
  dvec3 turned = x.xyz * n.x + y.xyz * n.y + z.xyz * n.z;
  double least = 1e300LF, most = -1e300LF, travel2 = 0.0LF;
  for (uint corner = 0u; corner < 3u; ++corner) {
    dvec4 at = dvec4(vertexAt(uint(topology[3u * face + corner])), 1.0LF);
    dvec3 d = dvec3(dot(exactSteps[s], at), dot(exactSteps[s + 1u], at), dot(exactSteps[s + 2u], at));
    double first = dot(n, d), second = dot(turned, d);
    least = min(least, min(first, second));
    most = max(most, max(first, second));
    travel2 = max(travel2, dot(d, d));
  }
  double angle = x.w, snap = y.w;
  double margin =
      sqrt(travel2) * (double(balls[2u * face + 1u].w) + angle * angle + 1e-6LF) + snap;
  return least > margin ? 1 : most < -margin ? -1 : 0;
}
int directionOf(uint face, uint placement) {
  uint s = 6u * (placement + 1u - placementBase);
  int direction = decideBall(face, s);
  return direction != 0 ? direction : decideCorners(face, s);
}

bool faceIsEnclosed(uint face, uint placement) {
  bool hasBefore = placement > 0u, hasAfter = placement + 1u < placementCount;
  int before = hasBefore ? directionOf(face, placement - 1u) : 0;
  int after = hasAfter ? directionOf(face, placement) : 0;
  if (culling == 2u && (after > 0 || before < 0)) return true;
  return before != 0 && before == after;
}

bool patchIsEnclosed(uint edge, uint placement) {
  uint at = 3u * faceCount + 4u * edge;
  int right = topology[at + 3u];
  if (right < 0) return false;
  int left = directionOf(uint(topology[at + 2u]), placement);
  if (left == 0) return false;
  int other = directionOf(uint(right >> 1), placement);
  return left == ((right & 1) != 0 ? -other : other);
}

// Returns the element with this number; the first one of `placementBase` has number 0.
Element elementOf(uint number) {
  Element e;
  e.placement = placementBase + number / elementCount;
  uint local = number % elementCount;
  bool isFace = local < faceCount;
  e.which = isFace ? local : local - faceCount;
  e.kind = isFace ? 1u : e.placement + 1u < placementCount ? 2u : 0u;
  if (culling == 0u || e.kind == 0u) return e;
  if (isFace ? faceIsEnclosed(e.which, e.placement) : patchIsEnclosed(e.which, e.placement)) {
    e.kind = 0u;
  }
  return e;
}

// Snaps to the fine lattice by the operations of grid/snap.h, in the same order.
int snapped(uint placement, uint row, precise double x, precise double y, precise double z) {
  uint at = 12u * (placement - placementBase) + 4u * row;
  precise double g = ((placements[at] * x + placements[at + 1u] * y) + placements[at + 2u] * z) +
                     placements[at + 3u];
  precise double fine = g * 65536.0LF;
  return 2 * int(fine) + 1;
}

ivec3 cornerOf(Element e, uint side) {
  uint vertex, placement = e.placement;
  if (e.kind == 2u) {
    vertex = uint(topology[3u * faceCount + 4u * e.which + ((side == 1u || side == 2u) ? 1u : 0u)]);
    placement += side >> 1;
  } else {
    vertex = uint(topology[3u * e.which + min(side, 2u)]);
  }
  dvec3 p = vertexAt(vertex);
  return ivec3(snapped(placement, 0u, p.x, p.y, p.z), snapped(placement, 1u, p.x, p.y, p.z),
               snapped(placement, 2u, p.x, p.y, p.z));
}
