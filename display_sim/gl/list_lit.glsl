// Lists the lit voxels of a volume, in any order: voxel 8 k + i is the i-th of word k.
layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer Voxels { uint voxels[]; };
layout(std430, binding = 1) buffer Lit {
  uint litCount;  // goes on counting where the list is full
  uint lit[];
};

layout(location = 0) uniform uint wordCount;
layout(location = 1) uniform uint room;

void main() {
  for (uint word = gl_GlobalInvocationID.x; word < wordCount; word += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
    uint bits = voxels[word];
    if (bits != 0u) {
      bits = (bits | bits >> 1 | bits >> 2) & 0x11111111u;
      for (uint at = atomicAdd(litCount, uint(bitCount(bits))); bits != 0u && at < room; ++at) {
        lit[at] = word * 8u + uint(findLSB(bits)) / 4u;
        bits &= bits - 1u;
      }
    }
  }
}
