// One invocation a part of a queued triangle.
layout(local_size_x = 64) in;  // kGroupParts

void main() {
  uint item = firstGroup + gl_WorkGroupID.x;
  uvec2 group = queued[item];
  ivec2 sectors = sectorsOf(group.x);
  Triangle triangle = loadTriangle(group.x);
  ivec2 rows = touchedRows(triangle);
  uint bands = bandsOf(rows);
  uint part = group.y * kGroupParts + gl_LocalInvocationID.x;
  if (part >= uint(sectors.y) * bands) {
    return;
  }
  int first = rows.x + int(part % bands) * bandRows();
  lightSector(triangle, (sectors.x + int(part / bands)) % (2 * slices), ivec2(first, min(first + bandRows() - 1, rows.y)));
}
