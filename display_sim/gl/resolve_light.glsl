// Turns the whole numbers of observe.glsl into an image, and leaves zeros behind.
layout(local_size_x = 256) in;

layout(std430, binding = 4) buffer Low { uvec4 low[]; };
layout(std430, binding = 5) buffer High { uvec4 high[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D light;

layout(location = 0) uniform ivec2 imageSize;
layout(location = 1) uniform float scale;  // of one unit

void main() {
  uint pixels = uint(imageSize.x * imageSize.y);
  for (uint i = gl_GlobalInvocationID.x; i < pixels; i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
    uvec4 units = low[i];
    uvec4 carried = high[i];
    vec4 sums = vec4(0);
    if ((units.x | units.y | units.z | units.w | carried.x | carried.y | carried.z | carried.w) != 0u) {
      sums = (vec4(carried) * 4294967296.0 + vec4(units)) * scale;
      low[i] = uvec4(0);
      high[i] = uvec4(0);
    }
    imageStore(light, ivec2(i % uint(imageSize.x), i / uint(imageSize.x)), vec4(sums.rgb + sums.a, 1));
  }
}
