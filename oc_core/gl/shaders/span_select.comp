// Which triangles, or pieces of clipped ones, have to be cut into spans, each with the blocks of rows that it reaches.
// Triangles that leave the frustum go to a list to be clipped. Lists are in no order, nor is whatever takes them.
layout(local_size_x = 64) in;
layout(std430, binding = 2) writeonly buffer Items { uvec2 items[]; };  // source and block
layout(std430, binding = 3) buffer Counters {
  uint itemCount;
  uint clipCount;
};
layout(location = 0) uniform uint first;
layout(location = 1) uniform uint count;
layout(location = 2) uniform uint capacity;
// Greatest 1/z of the disocclusions over each cell of each row. The base image has no such bound: everything is drawn.
layout(binding = 1) uniform sampler2D tops;
#if SOURCE == TRIANGLES
layout(std430, binding = 5) writeonly buffer Clips { uint clips[]; };
#endif

const int kMaxCells = 64;  // larger triangles are few: take them

// Positions that a triangle may reach on a row.
vec2 positionsOf(LineTriangle t, int row) {
  vec2 a = t.corners[0].q;
  vec2 b = t.corners[1].q;
  vec2 c = t.corners[2].q;
  if (isParallel != 0) {
    return vec2(min(a.x, min(b.x, c.x)), max(a.x, max(b.x, c.x)));
  }
  vec2 e = vec2(epipole);
  vec3 radii = vec3(distance(a, e), distance(b, e), distance(c, e));
  float longestSide = max(distance(a, b), max(distance(b, c), distance(c, a)));
  float nearest = min(radii.x, min(radii.y, radii.z)) - longestSide / 2.0 - 0.5;
  float farthest = max(radii.x, max(radii.y, radii.z)) + 0.5;
  float p = float(positionAtRadius(row, double(max(nearest, 0.0))));
  float q = float(positionAtRadius(row, double(farthest)));
  return vec2(min(p, q), max(p, q));
}

bool touches(LineTriangle t, ivec2 range) {
  float farthest = min(t.corners[0].inverseZ, min(t.corners[1].inverseZ, t.corners[2].inverseZ));
  int cells = 0;
  for (int i = range.x; i <= range.y; ++i) {
    int row = wrappedRow(i);
    vec2 positions = positionsOf(t, row);
    if (positions.y < 0.0 || positions.x >= float(rows[row].length)) {
      continue;
    }
    int cell = cellOf(double(max(positions.x, 0.0)));
    int last = cellOf(double(min(positions.y, float(rows[row].length))));
    cells += last - cell + 1;
    if (cells > kMaxCells) {
      return true;
    }
    for (; cell <= last; ++cell) {
      if (farthest < texelFetch(tops, ivec2(cell, row), 0).x) {
        return true;
      }
    }
  }
  return false;
}

void main() {
  uint item = gl_GlobalInvocationID.x;
  if (item >= count) {
    return;
  }
#if SOURCE == TRIANGLES
  uint source = first + item;
  uvec3 vertices = triangleVertices(source);
  uint outsideAll = 63u;
  uint outsideAny = 0u;
  for (int i = 0; i < 3; ++i) {
    vec3 p = cameraFromWorld(position(vertices[i]));
    vec2 q = imageFromCamera(p);
    uint sides = (p.z >= zNear ? 0u : 1u) | (p.z <= zFar ? 0u : 2u);
    if (p.z > 0.0) {
      sides |= (q.x > -clipMargin ? 0u : 4u) | (q.y > -clipMargin ? 0u : 8u) |
               (q.x < pinholeSize.x + clipMargin ? 0u : 16u) | (q.y < pinholeSize.y + clipMargin ? 0u : 32u);
    }
    outsideAll &= sides;
    outsideAny |= sides;
  }
  if (outsideAny != 0u) {
    if (outsideAll == 0u) {
      uint at = atomicAdd(clipCount, 1u);
      if (at < capacity) {
        clips[at] = source;
      }
    }
    return;
  }
#else
  uint source = (first + item) | kIsPiece;
#endif
  LineTriangle t = lineTriangle(source);
  ivec2 range = rowsOf(t);
  if (range.x > range.y) {
    return;
  }
#if TARGET == DISOCCLUSIONS
  if (!touches(t, range)) {
    return;
  }
#endif
  // The blocks that the rows fall in; a range may run over the end of a ring to its beginning.
  int beside = blocksPerRow();
  for (int i = range.x; i <= range.y;) {
    int row = wrappedRow(i);
    int band = row / blockRows();
    uint at = atomicAdd(itemCount, uint(beside));
    for (int k = 0; k < beside && at + uint(k) < capacity; ++k) {
      items[at + uint(k)] = uvec2(source, uint(band * beside + k));
    }
    i += min(blockRows() * (band + 1), rowCount) - row;
  }
}
