// One invocation up to four voxels: those of few pixels are drawn here, larger ones queued.
layout(local_size_x = 256) in;

// Software renderers end a shader after 65535 turns of its loops, all together: a voxel here may take so many, and an
// invocation of observe_large.glsl as many for each of its parts, one for a group of invocations.
const float kMaxTurns = 8192;
const float kLargeGroupSize = 64;

// At most so many turns of loops for a part of a cell.
float turnsOf(Cell cell) {
  float nearest = max(cell.onAxis.z - abs(cell.r), kNearest);
  float slope = (length(cell.onAxis.xy) + abs(cell.r)) / nearest;
  float side = (2 * halfHeight / sliceSize.y + columnWidth() / cell.parts.x + abs(cell.r) * cell.arc.radians / cell.parts.y) *
               pixelsPerRadius(cell) * (1 + slope);
  vec2 pixels = min(vec2(side), vec2(imageSize)) + 2;
  return asPoints ? 1 : pixels.x * pixels.y;
}

void main() {
  for (uint i = gl_GlobalInvocationID.x; i < litCount; i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
    uvec2 range = arcsOf(lit[i]);
    float turns = 0;
    float maxTurns = 0;
    for (uint arc = range.x; arc < range.y; ++arc) {
      Cell cell = cellOf(lit[i], arc);
      float parts = float(cell.parts.x * cell.parts.y);
      turns += parts * turnsOf(cell);
      maxTurns += ceil(parts / kLargeGroupSize) * turnsOf(cell);
    }
    if (turns > kMaxTurns) {
      large[atomicAdd(largeCount, 1u)] = i;
      atomicMax(rowGroups, uint(maxTurns / kMaxTurns) + 1u);
      continue;
    }
    for (uint arc = range.x; arc < range.y; ++arc) {
      Cell cell = cellOf(lit[i], arc);
      for (int part = 0; part < cell.parts.x * cell.parts.y; ++part) {
        addPart(cell, part, ivec2(0, 1));
      }
    }
  }
}
