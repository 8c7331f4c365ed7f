// Adds the light of lit voxels to an image, as Collector of observer.cpp does: one invocation a voxel.
//
// Light adds up in whole numbers, of kLightUnit to a voxel's light, so that their order does not matter. A pixel has four
// of 32 bits, and as many for what these carry: red, green, blue, and white, which is the colour of most voxels of most
// scenes and so takes one addition instead of three.
layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer Voxels { uint voxels[]; };
layout(std430, binding = 1) readonly buffer Lit {
  uint litCount;
  uint lit[];
};
// x, y: cos and sin of an arc's middle; z: its length in radians; w: the light of a voxel on it.
layout(std430, binding = 2) readonly buffer Arcs { vec4 arcs[]; };
layout(std430, binding = 3) readonly buffer ArcsOfSlices { uint firstArcs[]; };  // and their end
layout(std430, binding = 4) buffer Low { uint low[]; };
layout(std430, binding = 5) buffer High { uint high[]; };

layout(location = 0) uniform ivec2 imageSize;
layout(location = 1) uniform ivec2 sliceSize;
layout(location = 2) uniform float halfHeight;
layout(location = 3) uniform vec3 axis;  // the display's centre, in eye coordinates: right, down, forward
layout(location = 4) uniform mat3 eyeFromWorld;
layout(location = 5) uniform float pixelsPerTangent;
layout(location = 6) uniform bool asPoints;

const float kNearest = 1e-4;
const float kLightUnit = 1048576;

void addToPixel(int column, int row, float light, uint colorBits) {
  uint share = uint(min(light * kLightUnit + 0.5, 4294967040.0));
  uint at = uint(row * imageSize.x + column) * 4u;
  for (uint bits = colorBits == 7u ? 8u : colorBits; bits != 0u; bits &= bits - 1u) {
    uint sum = at + uint(findLSB(bits));
    if (atomicAdd(low[sum], share) > ~share) {
      atomicAdd(high[sum], 1u);
    }
  }
}

// Spreads light evenly over a box; what falls outside of the image is lost.
void addBox(vec2 center, vec2 size, float light, uint colorBits) {
  vec2 lo = center - size / 2;
  vec2 hi = center + size / 2;
  ivec2 first = ivec2(clamp(lo, vec2(0), vec2(imageSize)));
  ivec2 end = min(ivec2(clamp(hi, vec2(-1), vec2(imageSize))) + 1, imageSize);
  float density = light / (size.x * size.y);
  for (int row = first.y; row < end.y; ++row) {
    float rowDensity = density * max(min(hi.y, row + 1) - max(lo.y, row), 0);
    for (int column = first.x; column < end.x; ++column) {
      addToPixel(column, row, rowDensity * max(min(hi.x, column + 1) - max(lo.x, column), 0), colorBits);
    }
  }
}

void addPoint(vec2 at, float light, uint colorBits) {
  if (all(greaterThanEqual(at, vec2(0))) && all(lessThan(at, vec2(imageSize)))) {
    addToPixel(int(at.x), int(at.y), light, colorBits);
  }
}

// How a side of a voxel at `p` appears in the image, in pixels.
vec2 projected(vec3 side, vec3 p) {
  return (side.xy - p.xy / p.z * side.z) * (pixelsPerTangent / p.z);
}

// A unit vector in the plane of the display, turned by up to an eighth of a turn.
vec2 turned(vec2 direction, float angle) {
  float square = angle * angle;
  float sine = angle * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
  float cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)));
  return vec2(direction.x * cosine - direction.y * sine, direction.x * sine + direction.y * cosine);
}

// A part of a cell, as a box that has the same spread in both directions of the image, or as a point.
void addPart(vec3 onAxis, vec2 direction, float radians, float r, float width, float light, uint colorBits) {
  vec3 p = onAxis + eyeFromWorld * vec3(direction.x * r, 0, direction.y * r);
  if (p.z < kNearest) {
    return;
  }
  float nearer = length(axis) / p.z;
  vec2 center = imageSize / 2.0 + pixelsPerTangent * p.xy / p.z;
  light *= nearer * nearer;
  if (asPoints) {
    addPoint(center, light, colorBits);
    return;
  }
  vec2 outward = projected(eyeFromWorld * vec3(direction.x, 0, direction.y) * width, p);
  vec2 up = projected(eyeFromWorld[1] * (2 * halfHeight / sliceSize.y), p);
  vec2 along = projected(eyeFromWorld * vec3(-direction.y, 0, direction.x) * (abs(r) * radians), p);
  addBox(center, sqrt(outward * outward + up * up + along * along), light, colorBits);
}

// The parts of a cell on one arc: no longer than a pixel, where that takes at most 32 along the arc and 16 outwards.
void addVoxel(int column, int row, vec4 arc, uint colorBits) {
  float columnWidth = 2.0 / sliceSize.x;
  float r = (column + 0.5) * columnWidth - 1;
  vec3 onAxis = axis + eyeFromWorld[1] * (halfHeight * (1 - (row + 0.5) * 2 / sliceSize.y));
  float pixelsPerRadius = pixelsPerTangent / max(onAxis.z - abs(r), kNearest);
  int parts = int(clamp(ceil(abs(r) * arc.z * pixelsPerRadius), 1, 32));
  parts = parts == 1 ? 1 : 2 << findMSB(parts - 1);
  int columnParts = int(clamp(columnWidth * pixelsPerRadius + 0.5, 1, 16));
  float radians = arc.z / parts;
  float width = columnWidth / columnParts;
  float light = arc.w / (parts * columnParts);
  for (int i = 0; i < parts; ++i) {
    vec2 direction = turned(arc.xy, (i + 0.5) * radians - arc.z / 2);
    for (int k = 0; k < columnParts; ++k) {
      addPart(onAxis, direction, radians, r + (k - (columnParts - 1) / 2.0) * width, width, light, colorBits);
    }
  }
}

void main() {
  for (uint i = gl_GlobalInvocationID.x; i < litCount; i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
    uint voxel = lit[i];
    uint word = voxel / 8u;
    uint colorBits = voxels[word] >> voxel % 8u * 4u & 7u;
    uint rowWords = uint(sliceSize.x + 7) / 8u;
    int column = int(word % rowWords * 8u + voxel % 8u);
    uint row = word / rowWords % uint(sliceSize.y);
    uint slice = word / rowWords / uint(sliceSize.y);
    for (uint arc = firstArcs[slice]; arc < firstArcs[slice + 1u]; ++arc) {
      addVoxel(column, int(row), arcs[arc], colorBits);
    }
  }
}
