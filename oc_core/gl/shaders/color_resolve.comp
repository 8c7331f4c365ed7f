// The colours of fragments: those of the corners, by weight. ENCODED: as sRGB bytes.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D fragments;
#ifdef ENCODED
layout(binding = 0, rgba8) writeonly uniform image2D image;
#else
layout(binding = 0, rgba32f) writeonly uniform image2D image;
#endif
layout(std430, binding = 2) readonly buffer Colors { float colors[]; };
layout(location = 0) uniform vec3 background;

vec3 colorAt(uint vertex) {
  return vec3(colors[3u * vertex], colors[3u * vertex + 1u], colors[3u * vertex + 2u]);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(fragments, 0)))) {
    return;
  }
  uvec4 fragment = texelFetch(fragments, pixel, 0);
  vec3 color = background;
  if (fragment.y != kNoTriangle) {
    uvec3 vertices = triangleVertices(fragment.y);
    vec2 b = weightsOf(fragment);
    color = colorAt(vertices.x) * (1.0 - b.x - b.y) + colorAt(vertices.y) * b.x + colorAt(vertices.z) * b.y;
  }
#ifdef ENCODED
  imageStore(image, pixel, vec4(srgbFromLinear(color), 1.0));
#else
  imageStore(image, pixel, vec4(color, fragment.y == kNoTriangle ? 0.0 : 1.0));
#endif
}
