// One invocation a triangle: small ones are sliced here, large ones queued.
layout(local_size_x = 64) in;

// What an invocation does alone: at most so many sectors times rows.
const int kMostAlone = 64;

void main() {
  // Two dimensions of groups, as one may be limited to 65535 of them.
  uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  if (index >= triangleCount) {
    return;
  }
  ivec2 sectors = sectorsOf(index);
  Triangle triangle = loadTriangle(index);
  ivec2 rows = touchedRows(triangle);
  if (rows.x > rows.y) {
    return;
  }
  if (sectors.y * (rows.y - rows.x + 1) > kMostAlone) {
    queued[atomicAdd(queuedCount, 1u)] = index;
    return;
  }
  for (int i = 0; i < sectors.y; ++i) {
    lightSector(triangle, (sectors.x + i) % (2 * slices), rows);
  }
}
