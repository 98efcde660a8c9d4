// Finds the crossings of the swept surface with the lattice lines along all three axes.
// Compiled as one text: common.glsl, element.glsl, exact.glsl, then mark.glsl or winner.glsl, each of
// which defines keep(), then this file (sampling/gl/gl_program.cpp).
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Each invocation of a group takes one element. Its triangle (two for a side patch), seen along the
// three axes, gives up to six tasks. A task has one row of lattice lines for each coordinate V in the
// box of the triangle. Then the invocations share the rows of all elements of the group evenly, even
// if some triangles are much larger than others. On each row, the range of U that the triangle can
// reach is computed in single precision with a margin. findCrossing() decides exactly for each line
// in this range.

const uint kGroup = 64u, kTasks = 6u;
layout(local_size_x = 64) in;

layout(location = 7) uniform uint firstElement;  // first element of this dispatch, counted from placementBase
layout(location = 8) uniform uint dispatchCount;  // elements of this dispatch
layout(location = 9) uniform uint idBase;        // number of the first element of placementBase

shared ivec3 corners[4u * kGroup];
shared uint taskRows[kTasks * kGroup];
shared uint rowsBefore[kGroup + 1u];  // rows of all elements before this one

// A triangle seen along an axis, counter-clockwise, and the range of its lattice lines.
struct View {
  Triangle t;
  ivec2 first, last;
};

View viewOf(uint element, uint task) {
  int axis = int(task % 3u);
  uint at = 4u * element, second = task < 3u ? 1u : 2u;
  View v;
  v.t.axis = axis;
  v.t.a = ordered(corners[at], axis);
  v.t.b = ordered(corners[at + second], axis);
  v.t.c = ordered(corners[at + second + 1u], axis);
  ivec3 low = ordered(brickLow, axis), size = ordered(brickSize, axis);
  ivec3 least = min(v.t.a, min(v.t.b, v.t.c)), most = max(v.t.a, max(v.t.b, v.t.c));
  v.first = max((least.xy + (kSubUnits - 1)) >> kSubBits, low.xy);
  v.last = min(most.xy >> kSubBits, low.xy + size.xy - 1);
  if ((most.z >> kSubBits) + 1 < low.z || (least.z >> kSubBits) - 1 >= low.z + size.z) {
    v.last = v.first - 1;
  }
  return v;
}

uint rowsOf(uint element, uint task) {
  View v = viewOf(element, task);
  if (any(greaterThan(v.first, v.last))) return 0u;
  if (signOf(crossOf(v.t.b.xy - v.t.a.xy, v.t.c.xy - v.t.a.xy)) == 0) return 0u;
  return uint(v.last.y - v.first.y + 1);
}

void takeRow(uint element, uint task, uint row, uint id) {
  View v = viewOf(element, task);
  if (signOf(crossOf(v.t.b.xy - v.t.a.xy, v.t.c.xy - v.t.a.xy)) < 0) {
    ivec3 swap = v.t.b;
    v.t.b = v.t.c;
    v.t.c = swap;
  }
  ivec2 line = ivec2(v.first.x, v.first.y + int(row));
  ivec2 at = line << kSubBits;
  // Where the sides of the triangle cross the row, relative to the first line. Sides are at most 2^30
  // units long, so single precision is off by less than 400 units. Corners are odd, so none lies on
  // the row.
  const float kMargin = float(kSubUnits / 64);
  float least = 1e30, most = -1e30;
  ivec3 corner[3] = ivec3[3](v.t.a, v.t.b, v.t.c);
  for (int i = 0; i < 3; ++i) {
    ivec2 from = corner[i].xy, to = corner[(i + 1) % 3].xy;
    if ((from.y > at.y) == (to.y > at.y)) continue;
    float part = float(at.y - from.y) / float(to.y - from.y);
    float u = float(from.x - at.x) + part * float(to.x - from.x);
    least = min(least, u);
    most = max(most, u);
  }
  if (least > most) return;
  int count = v.last.x - v.first.x;
  int begin = int(clamp(ceil((least - kMargin) / float(kSubUnits)), 0.0, float(count + 1)));
  int end = int(clamp(floor((most + kMargin) / float(kSubUnits)), -1.0, float(count)));
  for (int u = begin; u <= end; ++u) {
    Crossing crossing;
    if (findCrossing(v.t, line + ivec2(u, 0), crossing)) keep(crossing, v.t.axis, id);
  }
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint local = group * kGroup + thread;
  Element element;
  element.kind = 0u;
  if (local < dispatchCount) element = elementOf(firstElement + local);
  if (element.kind != 0u) {
    for (uint side = 0u; side < 4u; ++side) {
      corners[4u * thread + side] = cornerOf(element, side);
    }
  }
  uint rows = 0u;
  for (uint task = 0u; task < kTasks; ++task) {
    uint n = 3u * element.kind > task ? rowsOf(thread, task) : 0u;
    taskRows[kTasks * thread + task] = n;
    rows += n;
  }
  rowsBefore[thread + 1u] = rows;
  if (thread == 0u) rowsBefore[0] = 0u;
  barrier();
  for (uint step = 1u; step < kGroup; step *= 2u) {  // prefix sums (Hillis and Steele 1986)
    uint sum = rowsBefore[thread + 1u];
    if (thread + 1u > step) sum += rowsBefore[thread + 1u - step];
    barrier();
    rowsBefore[thread + 1u] = sum;
    barrier();
  }
  uint total = rowsBefore[kGroup];
  for (uint r = thread; r < total; r += kGroup) {
    uint first = 0u, last = kGroup - 1u;  // the element with rowsBefore[e] <= r < rowsBefore[e + 1]
    while (first < last) {
      uint middle = (first + last) >> 1;
      if (rowsBefore[middle + 1u] <= r) first = middle + 1u;
      else last = middle;
    }
    uint row = r - rowsBefore[first], task = 0u;
    while (row >= taskRows[kTasks * first + task]) {
      row -= taskRows[kTasks * first + task];
      ++task;
    }
    takeRow(first, task, row, idBase + firstElement + group * kGroup + first);
  }
}
