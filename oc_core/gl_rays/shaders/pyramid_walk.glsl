// The first triangle that a ray meets, through a pyramid of bounds: oc_core/depth_rays/sample_pyramid.h. Nodes are opened
// from near to far, and boxes are grown by more than single precision rounds.
//
// MAX_WAITING is at least what the depth of the tree bounds (SamplePyramid::maxWaiting), so nothing is ever put behind
// the end of the arrays. Each node and cell waits once, so the walk ends.
struct PyramidNode {
  vec4 lower[12];  // 16 children: four an entry, axis by axis
  vec4 upper[12];
  uvec4 child[4];  // kNoChild behind the last
};
layout(std430, binding = 3) readonly buffer Nodes { PyramidNode nodes[]; };
// Of each cell, and one behind the last.
layout(std430, binding = 4) readonly buffer FirstTriangles { uint firstTriangle[]; };

layout(location = 0) uniform uint root;  // kNoChild where there is nothing to hit
layout(location = 1) uniform uint maxIterations;

const uint kNoChild = 0xffffffffu;
const uint kCellBit = 0x80000000u;
// What an entry into a box is moved by, as a share: more than its roundings, among them that of a quotient, which is no
// more than 2.5 units in the last place.
const float kRounding = 1e-6;

vec3 inverseOf(vec3 step) {
  float longest = max(abs(step.x), max(abs(step.y), abs(step.z)));
  vec3 inverse = 1.0 / max(abs(step), vec3(max(1e-20 * longest, 1e-30)));
  return uintBitsToFloat(floatBitsToUint(inverse) | (floatBitsToUint(step) & uvec3(0x80000000u)));
}

// What waits, the nearest of the last opened node last.
float waitingEntry[MAX_WAITING];
uint waiting[MAX_WAITING];

// Where a ray enters four children, moved towards it by rounding; -1 for those that it passes by.
vec4 entriesOf(uint node, int group, StraightRay ray, vec3 inverse, float reach) {
  vec4 enter = vec4(0);
  vec4 leave = vec4(reach);
  for (int axis = 0; axis < 3; ++axis) {
    vec4 a = (nodes[node].lower[4 * axis + group] - ray.origin[axis]) * inverse[axis];
    vec4 b = (nodes[node].upper[4 * axis + group] - ray.origin[axis]) * inverse[axis];
    enter = max(enter, min(a, b));
    leave = min(leave, max(a, b));
  }
  bvec4 isMet = lessThanEqual(enter * (1.0 - kRounding), leave * (1.0 + kRounding));
  bvec4 isChild = notEqual(nodes[node].child[group], uvec4(kNoChild));
  enter *= 1.0 - kRounding;
  return vec4(isMet.x && isChild.x ? enter.x : -1.0, isMet.y && isChild.y ? enter.y : -1.0,
              isMet.z && isChild.z ? enter.z : -1.0, isMet.w && isChild.w ? enter.w : -1.0);
}
float largestOf(vec4 v) {
  return max(max(v.x, v.y), max(v.z, v.w));
}
// Takes the first of four entries that is `entry`, and says which child it is of.
uint taken(inout vec4 entries, float entry, uvec4 child) {
  if (entries.x == entry) {
    entries.x = -1.0;
    return child.x;
  }
  if (entries.y == entry) {
    entries.y = -1.0;
    return child.y;
  }
  if (entries.z == entry) {
    entries.z = -1.0;
    return child.z;
  }
  entries.w = -1.0;
  return child.w;
}

uint countOf(uint node) {
  uvec4 count = uvec4(0);
  for (int group = 0; group < 4; ++group) {
    count += uvec4(notEqual(nodes[node].child[group], uvec4(kNoChild)));
  }
  return count.x + count.y + count.z + count.w;
}

// Whether the walk came to its end: it is given up after `maxIterations` iterations of its loop. `cost` grows by nodes, cells,
// boxes and triangles.
bool walkPyramid(StraightRay ray, inout Meeting best, inout uvec4 cost) {
  if (root == kNoChild) {
    return true;
  }
  vec3 inverse = inverseOf(ray.step);
  float reach = ray.reach * (1.0 + kRounding);
  int count = 1;
  waitingEntry[0] = 0.0;
  waiting[0] = root;
  for (uint iteration = 0u; count > 0; ++iteration) {
    if (iteration == maxIterations) {
      return false;
    }
    --count;
    uint reference = waiting[count];
    if (waitingEntry[count] > reach) {
      continue;
    }
    if ((reference & kCellBit) != 0u) {
      uint cell = reference & ~kCellBit;
      uint end = firstTriangle[cell + 1u];
      ++cost.y;
      for (uint t = firstTriangle[cell]; t < end; ++t) {
        uvec3 v = triangleVertices(t);
        Meeting meeting = meetTriangle(ray, position(v.x), position(v.y), position(v.z), t);
        ++cost.w;
        if (meeting.triangle != kNoTriangle && comesBefore(meeting, best)) {
          best = meeting;
          reach = float(meeting.share) * (1.0 + kRounding);
        }
      }
      continue;
    }
    ++cost.x;
    cost.z += countOf(reference);
    vec4 e0 = entriesOf(reference, 0, ray, inverse, reach);
    vec4 e1 = entriesOf(reference, 1, ray, inverse, reach);
    vec4 e2 = entriesOf(reference, 2, ray, inverse, reach);
    vec4 e3 = entriesOf(reference, 3, ray, inverse, reach);
    // The farthest child first, so that the nearest is the next one.
    for (int put = 0; put < 16; ++put) {
      float entry = largestOf(max(max(e0, e1), max(e2, e3)));
      if (entry < 0.0) {
        break;
      }
      waitingEntry[count] = entry;
      if (any(equal(e0, vec4(entry)))) {
        waiting[count] = taken(e0, entry, nodes[reference].child[0]);
      } else if (any(equal(e1, vec4(entry)))) {
        waiting[count] = taken(e1, entry, nodes[reference].child[1]);
      } else if (any(equal(e2, vec4(entry)))) {
        waiting[count] = taken(e2, entry, nodes[reference].child[2]);
      } else {
        waiting[count] = taken(e3, entry, nodes[reference].child[3]);
      }
      ++count;
    }
  }
  return true;
}
