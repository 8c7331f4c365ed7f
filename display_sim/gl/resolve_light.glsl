// Turns the whole numbers of observe.glsl into an image, and leaves zeros behind.
layout(local_size_x = 256) in;

layout(std430, binding = 4) buffer Low { uint low[]; };
layout(std430, binding = 5) buffer High { uint high[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D light;

layout(location = 0) uniform ivec2 imageSize;
layout(location = 1) uniform float scale;  // of one unit

void main() {
  uint pixels = uint(imageSize.x * imageSize.y);
  for (uint i = gl_GlobalInvocationID.x; i < pixels; i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
    vec4 sums;
    for (uint channel = 0u; channel < 4u; ++channel) {
      uint at = 4u * i + channel;
      sums[channel] = (float(high[at]) * 4294967296.0 + float(low[at])) * scale;
      low[at] = 0u;
      high[at] = 0u;
    }
    imageStore(light, ivec2(i % uint(imageSize.x), i / uint(imageSize.x)), vec4(sums.rgb + sums.a, 1));
  }
}
