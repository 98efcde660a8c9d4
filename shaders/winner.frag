// Pass 2: finds for every contributing edge the first and last crossing, and their elements.
// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Round 0 finds the lowest and the highest fraction; round 1 finds, for each of the two, the lowest
// number of an element that crosses the edge there. The edges come as a sorted list of codes. A
// code is the index of the edge's bit in the image of pass 1.

layout(std430, binding = 5) readonly buffer Codes { uint codes[]; };
layout(std430, binding = 6) coherent buffer Extremes { uint extremes[]; };  // low, high
layout(std430, binding = 7) coherent buffer Winners { uint winners[]; };    // low, high

layout(location = 10) uniform uint codeCount;
layout(location = 11) uniform uint secondRound;

void main() {
  Crossing crossing;
  if (!findCrossing(crossing)) return;
  ivec3 p = crossing.edge;
  uint words = uint(brickSize.z + 31) >> 5;
  uint row = uint(int(idAndAxis.y) * brickSize.x + p.x) * uint(brickSize.y) + uint(p.y);
  uint code = row * (words << 5) + uint(p.z);

  uint first = 0u, last = codeCount;
  while (first < last) {
    uint middle = (first + last) >> 1;
    if (codes[middle] < code) first = middle + 1u;
    else last = middle;
  }
  if (first >= codeCount || codes[first] != code) return;

  uint low = 2u * first, high = low + 1u, f = crossing.fraction;
  if (secondRound == 0u) {
    if (f < extremes[low]) atomicMin(extremes[low], f);
    if (f > extremes[high]) atomicMax(extremes[high], f);
  } else {
    if (f == extremes[low]) atomicMin(winners[low], idAndAxis.x);
    if (f == extremes[high]) atomicMin(winners[high], idAndAxis.x);
  }
}
