// Turns the counts of groups into how many come before each, and leaves the totals behind the last.
layout(local_size_x = 256) in;
layout(std430, binding = 3) buffer Groups { uvec4 groups[]; };
layout(location = 0) uniform uint count;

shared uvec4 sums[256];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uvec4 before = uvec4(0u);
  for (uint base = 0u; base < count; base += 256u) {
    uvec4 own = base + lane < count ? groups[base + lane] : uvec4(0u);
    sums[lane] = own;
    barrier();
    for (uint step = 1u; step < 256u; step *= 2u) {
      uvec4 lower = lane >= step ? sums[lane - step] : uvec4(0u);
      barrier();
      sums[lane] += lower;
      barrier();
    }
    if (base + lane < count) {
      groups[base + lane] = before + sums[lane] - own;
    }
    before += sums[255];
    barrier();
  }
  if (lane == 0u) {
    groups[count] = before;
  }
}
