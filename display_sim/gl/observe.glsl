// Adds the light of lit voxels to an image, as Collector of observer.cpp does.
//
// Light adds up in whole numbers, of kLightUnit to a voxel's light, so that their order does not matter. A pixel has four
// of 32 bits, and as many for what these carry: red, green, blue, and white, which is the colour of most voxels of most
// scenes and so takes one addition instead of three.
layout(std430, binding = 0) readonly buffer Voxels { uint voxels[]; };
layout(std430, binding = 1) readonly buffer Lit {
  uint litCount;
  uint lit[];
};
struct Arc {
  vec2 direction;  // cos and sin of its middle
  float radians;   // its length
  float swing;     // phase of the wobble in its middle
  float ahead;     // light of a voxel on it, for eyes on either side of the screen: ArcLight of emission.h
  float behind;
  uint channels;
  uint unused;
};
layout(std430, binding = 2) readonly buffer Arcs { Arc arcs[]; };
layout(std430, binding = 3) readonly buffer ArcsOfSlices { uint firstArcs[]; };  // and their end
layout(std430, binding = 4) buffer Low { uint low[]; };
layout(std430, binding = 5) buffer High { uint high[]; };
layout(std430, binding = 6) buffer Large {
  uint largeCount;
  uint rowGroups;  // among which the rows of a part are to be shared
  uint large[];    // places in the list of lit voxels
};

layout(location = 0) uniform ivec2 imageSize;
layout(location = 1) uniform ivec2 sliceSize;
layout(location = 2) uniform float halfHeight;
layout(location = 3) uniform vec3 axis;  // the display's centre, in eye coordinates: right, down, forward
layout(location = 4) uniform mat3 eyeFromWorld;
layout(location = 5) uniform float pixelsPerTangent;
layout(location = 6) uniform bool asPoints;
layout(location = 7) uniform uint firstGroup;
layout(location = 8) uniform bool fromScreen;  // else voxels emit evenly
layout(location = 9) uniform vec3 wobble;      // how far and where to the axis swings, in eye coordinates
layout(location = 10) uniform float wobbleFrequency;
layout(location = 11) uniform float deadZone;

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

// Spreads light evenly over a box; what falls outside of the image is lost. Of the box's rows every `rows.y`th is drawn,
// from `rows.x` on.
void addBox(vec2 center, vec2 size, float light, uint colorBits, ivec2 rows) {
  vec2 lo = center - size / 2;
  vec2 hi = center + size / 2;
  ivec2 first = ivec2(clamp(lo, vec2(0), vec2(imageSize)));
  ivec2 end = min(ivec2(clamp(hi, vec2(-1), vec2(imageSize))) + 1, imageSize);
  float density = light / (size.x * size.y);
  for (int row = first.y + rows.x; row < end.y; row += rows.y) {
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

// A cell on one arc, in parts no longer than a pixel, where that takes at most 32 along the arc and 16 outwards.
struct Cell {
  vec3 onAxis;
  float r;
  Arc arc;
  ivec2 parts;  // outwards, along
  uint colorBits;
};

float pixelsPerRadius(Cell cell) {
  return pixelsPerTangent / max(cell.onAxis.z - abs(cell.r), kNearest);
}

float columnWidth() {
  return 2.0 / sliceSize.x;
}

Cell cellOf(uint voxel, uint arc) {
  uint word = voxel / 8u;
  uint rowWords = uint(sliceSize.x + 7) / 8u;
  uint column = word % rowWords * 8u + voxel % 8u;
  uint row = word / rowWords % uint(sliceSize.y);
  Cell cell;
  cell.onAxis = axis + eyeFromWorld[1] * (halfHeight * (1 - (row + 0.5) * 2 / sliceSize.y));
  cell.r = (column + 0.5) * columnWidth() - 1;
  cell.arc = arcs[arc];
  float pixels = pixelsPerRadius(cell);
  int along = int(clamp(ceil(abs(cell.r) * cell.arc.radians * pixels), 1, 32));
  cell.parts = ivec2(clamp(columnWidth() * pixels + 0.5, 1, 16), along == 1 ? 1 : 2 << findMSB(along - 1));
  cell.colorBits = abs(cell.r) < deadZone ? 0u : voxels[word] >> voxel % 8u * 4u & cell.arc.channels;
  return cell;
}

// The arcs of a voxel's slice, from x to y - 1.
uvec2 arcsOf(uint voxel) {
  uint slice = voxel / 8u / (uint(sliceSize.x + 7) / 8u) / uint(sliceSize.y);
  return uvec2(firstArcs[slice], firstArcs[slice + 1u]);
}

// lightTowardsEye() of emission.h.
float towardsEye(Arc arc, vec3 alongUnit, vec3 p) {
  if (!fromScreen) {
    return arc.ahead;
  }
  float slope = dot(alongUnit, p) / p.z;
  return 1.57079633 * abs(slope) * (slope < 0 ? arc.ahead : arc.behind);
}

// Adds one part of a cell, as a box that has the same spread in both directions of the image, or as a point.
void addPart(Cell cell, int part, ivec2 rows) {
  if (cell.colorBits == 0u) {
    return;
  }
  float radians = cell.arc.radians / cell.parts.y;
  float width = columnWidth() / cell.parts.x;
  float angle = (part / cell.parts.x + 0.5) * radians - cell.arc.radians / 2;  // from the arc's middle
  vec2 direction = turned(cell.arc.direction, angle);
  float r = cell.r + (part % cell.parts.x - (cell.parts.x - 1) / 2.0) * width;
  vec3 p = cell.onAxis + eyeFromWorld * vec3(direction.x * r, 0, direction.y * r) +
           wobble * cos(cell.arc.swing + wobbleFrequency * angle);
  if (p.z < kNearest) {
    return;
  }
  float nearer = length(axis) / p.z;
  vec3 alongUnit = eyeFromWorld * vec3(-direction.y, 0, direction.x);
  float light = towardsEye(cell.arc, alongUnit, p) / (cell.parts.x * cell.parts.y) * nearer * nearer;
  vec2 center = imageSize / 2.0 + pixelsPerTangent * p.xy / p.z;
  if (asPoints) {
    if (rows.x == 0) {
      addPoint(center, light, cell.colorBits);
    }
    return;
  }
  vec2 outward = projected(eyeFromWorld * vec3(direction.x, 0, direction.y) * width, p);
  vec2 up = projected(eyeFromWorld[1] * (2 * halfHeight / sliceSize.y), p);
  vec2 along = projected(alongUnit * (abs(r) * radians), p);
  // Seen along its plane a part at the axis has no extent in one direction.
  vec2 size = max(sqrt(outward * outward + up * up + along * along), vec2(1e-3));
  addBox(center, size, light, cell.colorBits, rows);
}
