// One invocation a triangle: small ones are sliced here, the parts of large ones queued.
layout(local_size_x = 64) in;

// What an invocation does alone: at most so many sectors times rows, and these times columns.
const int kMaxRowsAlone = 64;
const int kMaxVoxelsAlone = 1024;

// No part of it is wider, in columns.
Real widthOf(Triangle t) {
  Real2 ab = t.b.xz - t.a.xz;
  Real2 bc = t.c.xz - t.b.xz;
  Real2 ca = t.a.xz - t.c.xz;
  return sqrt(max(dot(ab, ab), max(dot(bc, bc), dot(ca, ca))));
}

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
  int work = sectors.y * (rows.y - rows.x + 1);
  if (work <= kMaxRowsAlone && work * (widthOf(triangle) + 2) <= kMaxVoxelsAlone) {
    for (int i = 0; i < sectors.y; ++i) {
      lightSector(triangle, (sectors.x + i) % (2 * slices), rows);
    }
    return;
  }
  uint groups = (uint(sectors.y) * bandsOf(rows) + kGroupParts - 1u) / kGroupParts;
  uint at = atomicAdd(queuedCount, groups);
  for (uint i = 0u; i < groups && at + i < room; ++i) {
    queued[at + i] = uvec2(index, i);
  }
}
