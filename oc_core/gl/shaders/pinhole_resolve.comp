// From the triangle that a pixel sees to the fragment: where on the triangle, and how far away.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 0, rgba32ui) writeonly uniform uimage2D fragments;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(pinholeSize)))) {
    return;
  }
  uint triangle = texelFetch(visible, pixel, 0).x;
  if (triangle == kNoTriangle) {
    imageStore(fragments, pixel, kNoFragment);
    return;
  }
  uvec3 vertices = triangleVertices(triangle);
  vec3 a = cameraFromWorld(position(vertices.x));
  vec3 b = cameraFromWorld(position(vertices.y));
  vec3 c = cameraFromWorld(position(vertices.z));
  vec3 weights = weightsAt(a, b, c, vec2(pixel) + 0.5);
  float z = weights.x * a.z + weights.y * b.z + weights.z * c.z;
  imageStore(fragments, pixel, packFragment(z, triangle, weights.yz));
}
