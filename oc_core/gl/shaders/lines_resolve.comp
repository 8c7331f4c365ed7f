// From depth and triangle of each sample along epipolar lines to its fragment.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D depths;
layout(binding = 1) uniform usampler2D indices;
layout(binding = 0, rgba32ui) writeonly uniform uimage2D fragments;

void main() {
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(place, imageSize(fragments)))) {
    return;
  }
  uint triangle = texelFetch(indices, place, 0).x;
  if (triangle == kNoTriangle) {
    imageStore(fragments, place, kNoFragment);
    return;
  }
  uvec3 vertices = triangleVertices(triangle);
  vec3 weights = weightsAt(cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                           cameraFromWorld(position(vertices.z)), vec2(linePoint(place.y, place.x + 0.5LF)));
  imageStore(fragments, place,
             packFragment(uintBitsToFloat(texelFetch(depths, place, 0).x), triangle, weights.yz));
}
