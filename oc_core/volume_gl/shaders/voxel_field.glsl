// The field of a volume at index coordinates, as ScalarVolume::fieldAt() has it: voxel centres are at whole numbers, it
// is linear between them along each axis, and that of the nearest place among the centres beyond the outermost ones.
layout(binding = 0) uniform sampler3D voxels;

float voxelAt(ivec3 at) {
  return texelFetch(voxels, at, 0).r;
}

#if HARDWARE_FILTER
// By the units of the GPU, whose weights may have 8 bits.
float texelField(vec3 index) {
  return textureLod(voxels, (index + 0.5) / vec3(textureSize(voxels, 0)), 0.0).r;
}
#else
float texelField(vec3 index) {
  ivec3 last = textureSize(voxels, 0) - 1;
  vec3 inside = clamp(index, vec3(0), vec3(last));
  vec3 lower = floor(inside);
  vec3 share = inside - lower;
  ivec3 a = ivec3(lower);
  ivec3 b = min(a + 1, last);
  float v00 = mix(voxelAt(a), voxelAt(ivec3(b.x, a.yz)), share.x);
  float v10 = mix(voxelAt(ivec3(a.x, b.y, a.z)), voxelAt(ivec3(b.xy, a.z)), share.x);
  float v01 = mix(voxelAt(ivec3(a.xy, b.z)), voxelAt(ivec3(b.x, a.y, b.z)), share.x);
  float v11 = mix(voxelAt(ivec3(a.x, b.yz)), voxelAt(b), share.x);
  return mix(mix(v00, v10, share.y), mix(v01, v11, share.y), share.z);
}
#endif
