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

// Counts within a group fit into one word, nine bits each.
uint packCounts(uint leaves, uint children, uint clips) {
  return leaves | children << 9 | clips << 18;
}
uvec4 unpackCounts(uint packed_) {
  return uvec4(packed_ & 511u, packed_ >> 9 & 511u, packed_ >> 18 & 511u, 0u);
}

const uint kRun = 8u;
shared uint sums[kGroup];
shared uint sumsOfRuns[kGroup / kRun];

// The sum of `own` over this and the lower lanes of the group. In two steps, as each barrier costs more than some
// additions: on a software renderer a dozen of them took longer than all else.
uint sumInGroup(uint own) {
  uint lane = gl_LocalInvocationID.x;
  uint run = lane / kRun;
  sums[lane] = own;
  barrier();
  uint sum = 0u;
  for (uint i = run * kRun; i <= lane; ++i) {
    sum += sums[i];
  }
  if (lane % kRun == kRun - 1u) {
    sumsOfRuns[run] = sum;
  }
  barrier();
  for (uint i = 0u; i < run; ++i) {
    sum += sumsOfRuns[i];
  }
  return sum;
}
