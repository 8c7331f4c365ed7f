// Keeps what decideItem() says of each item, and counts it.
layout(std430, binding = 6) writeonly buffer Codes { uint codes[]; };

void main() {
  uint code = kDrop;
  if (gl_GlobalInvocationID.x < count) {
    code = decideItem(first + gl_GlobalInvocationID.x);
  }
  uint own = countsOf(code);
  uint sum = sumInGroup(own);
  if (gl_GlobalInvocationID.x < count) {
    codes[gl_GlobalInvocationID.x] = withPlace(code, sum - own);
  }
  if (gl_LocalInvocationID.x == kGroup - 1u) {
    groups[gl_WorkGroupID.x] = unpackCounts(sum);
  }
}
