// How many leaves, children and triangles to be clipped the items of each group have, and then how many come before
// them: pieces are counted first and written then, at places that follow from those counts. So their order, and with it
// the image, does not depend on which is done first.
#ifndef GROUP
#define GROUP 64
#endif
const uint kGroup = GROUP;
layout(local_size_x = GROUP) in;
layout(std430, binding = 3) buffer Groups { uvec4 groups[]; };
layout(location = 0) uniform uint first;  // of the source
layout(location = 1) uniform uint count;

shared uvec4 sums[kGroup];

// The sum of `own` over this and the lower lanes of the group.
uvec4 sumInGroup(uvec4 own) {
  uint lane = gl_LocalInvocationID.x;
  sums[lane] = own;
  barrier();
  for (uint step = 1u; step < kGroup; step *= 2u) {
    uvec4 lower = lane >= step ? sums[lane - step] : uvec4(0u);
    barrier();
    sums[lane] += lower;
    barrier();
  }
  return sums[lane];
}
