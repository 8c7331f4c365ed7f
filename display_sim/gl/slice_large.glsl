// A group a queued triangle, or several where there are few: its invocations share the sectors and bands of rows.
layout(local_size_x = 64) in;

const int kBandRows = 16;

void main() {
  uint count = queuedCount;
  if (count == 0u) {
    return;
  }
  uint groups = max(gl_NumWorkGroups.x / count, 1u);  // for each triangle
  for (uint item = gl_WorkGroupID.x; item < count * groups; item += gl_NumWorkGroups.x) {
    uint index = queued[item / groups];
    ivec2 sectors = sectorsOf(index);
    Triangle triangle = loadTriangle(index);
    ivec2 rows = touchedRows(triangle);
    uint bands = uint(rows.y - rows.x) / kBandRows + 1u;
    uint parts = uint(sectors.y) * bands;
    uint stride = groups * gl_WorkGroupSize.x;
    for (uint part = item % groups * gl_WorkGroupSize.x + gl_LocalInvocationID.x; part < parts; part += stride) {
      int first = rows.x + int(part % bands) * kBandRows;
      lightSector(triangle, (sectors.x + int(part / bands)) % (2 * slices),
                  ivec2(first, min(first + kBandRows - 1, rows.y)));
    }
  }
}
