// From the triangle that a pixel sees to the fragment: where on the triangle, and how far away.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 0, rgba32ui) writeonly uniform uimage2D fragments;

// Corners are moved to the grid on which the processor's rasteriser fills, 1/256 pixel, so that both interpolate alike.
vec2 snapped(vec2 q) {
  return roundEven(q * 256.0) / 256.0;
}
float cross2(vec2 a, vec2 b) {
  return a.x * b.y - a.y * b.x;
}
float largest(vec2 v) {
  return max(abs(v.x), abs(v.y));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(imageSize)))) {
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
  vec2 at = vec2(pixel) + 0.5;
  vec3 weights;  // times 1/z at the corner: linear over the image
  bool inFront = min(a.z, min(b.z, c.z)) >= zNear;
  vec2 qa = vec2(0);
  vec2 qb = vec2(0);
  vec2 qc = vec2(0);
  if (inFront) {
    qa = snapped(imageFromCamera(a)) - at;
    qb = snapped(imageFromCamera(b)) - at;
    qc = snapped(imageFromCamera(c)) - at;
  }
  if (inFront && max(largest(qa), max(largest(qb), largest(qc))) < 8192.0) {
    weights = vec3(cross2(qb, qc), cross2(qc, qa), cross2(qa, qb));
    // What rounding leaves outside of the triangle is on its border.
    float area = weights.x + weights.y + weights.z;
    weights = max(weights / area, 0.0) / vec3(a.z, b.z, c.z);
  } else {
    vec3 ray = vec3((at - center) / focal, 1.0);
    weights = vec3(dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray));
    // Their sum has the sign of the side that is seen; a weight of the other sign is rounding.
    weights = max(weights * sign(weights.x + weights.y + weights.z), 0.0);
  }
  weights /= weights.x + weights.y + weights.z;
  float z = weights.x * a.z + weights.y * b.z + weights.z * c.z;
  imageStore(fragments, pixel, packFragment(z, triangle, weights.yz));
}
