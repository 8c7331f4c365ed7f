// One group, or several, a queued voxel: invocations share its parts, groups their rows.
layout(local_size_x = 64) in;

void main() {
  uint voxel = lit[large[firstGroup + gl_WorkGroupID.x]];
  ivec2 rows = ivec2(gl_WorkGroupID.y, gl_NumWorkGroups.y);
  uvec2 range = arcsOf(voxel);
  for (uint arc = range.x; arc < range.y; ++arc) {
    Cell cell = cellOf(voxel, arc);
    for (int part = int(gl_LocalInvocationID.x); part < cell.parts.x * cell.parts.y; part += int(gl_WorkGroupSize.x)) {
      addPart(cell, part, rows);
    }
  }
}
