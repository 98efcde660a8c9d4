// Snaps a corner of a swept element to the fine lattice, exactly as grid/snap.h does.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Each element has four corners. Those of a face are its three vertices at its placement (the
// fourth is not used). Those of the side patch of an edge (a, b) are a and b at the start of its
// step, then b and a at the end of the step.
// If `listed` is set, the elements come from a buffer. Otherwise ("instanced"), each instance is a
// placement and draws all faces and then, for a continuous motion, all edges.

layout(std430, binding = 0) readonly buffer Vertices { double vertices[]; };     // x, y, z each
layout(std430, binding = 1) readonly buffer Faces { int faces[]; };              // 3 per face
layout(std430, binding = 2) readonly buffer Edges { int edges[]; };              // 2 per edge
layout(std430, binding = 3) readonly buffer Placements { double placements[]; }; // 3 rows of 4
layout(std430, binding = 4) readonly buffer Elements { uvec2 elements[]; };      // code, placement

layout(location = 2) uniform uint listed;
// Index of the first element of this draw: in the buffer if listed, else among the elements of a
// placement.
layout(location = 3) uniform uint firstElement;
layout(location = 4) uniform uint firstPlacement;  // first placement of this draw (instanced)
layout(location = 5) uniform uint placementBase;   // first placement in the buffer
layout(location = 6) uniform uint placementCount;  // number of placements of the whole motion
layout(location = 7) uniform uint faceCount;
layout(location = 8) uniform uint elementCount;    // elements of one placement (instanced)
// Listed: number of the first element in the buffer. Instanced: the placement whose first element
// has number 0.
layout(location = 9) uniform uint idBase;

const uint kPatchBit = 0x80000000u;

out VertexData {
  flat ivec3 point;
  flat uint id;
  flat uint elementKind;  // 0: nothing, 1: face, 2: side patch
} corner;

int snapped(uint placement, uint row, precise double x, precise double y, precise double z) {
  uint at = 12u * (placement - placementBase) + 4u * row;
  precise double g = ((placements[at] * x + placements[at + 1u] * y) + placements[at + 2u] * z) +
                     placements[at + 3u];
  precise double fine = g * 65536.0LF;
  return 2 * int(fine) + 1;
}

void main() {
  uint which = uint(gl_VertexID) >> 2, side = uint(gl_VertexID) & 3u;
  uint code, placement;
  if (listed != 0u) {
    uvec2 element = elements[firstElement + which];
    code = element.x;
    placement = element.y;
    corner.id = idBase + firstElement + which;
  } else {
    uint local = firstElement + which;
    placement = firstPlacement + uint(gl_InstanceID);
    code = local < faceCount ? local : (local - faceCount) | kPatchBit;
    corner.id = (placement - idBase) * elementCount + local;
  }
  bool isSidePatch = (code & kPatchBit) != 0u;
  corner.elementKind = isSidePatch ? (placement + 1u < placementCount ? 2u : 0u) : 1u;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
  corner.point = ivec3(0);
  if (corner.elementKind == 0u) return;

  uint vertex;
  if (isSidePatch) {
    uint edge = code & ~kPatchBit;
    vertex = uint(edges[2u * edge + ((side == 1u || side == 2u) ? 1u : 0u)]);
    placement += side >> 1;
  } else {
    vertex = uint(faces[3u * code + min(side, 2u)]);
  }
  double x = vertices[3u * vertex], y = vertices[3u * vertex + 1u], z = vertices[3u * vertex + 2u];
  corner.point = ivec3(snapped(placement, 0u, x, y, z), snapped(placement, 1u, x, y, z),
                       snapped(placement, 2u, x, y, z));
}
