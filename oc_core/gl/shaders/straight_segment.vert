// Corners of triangles, pulled from the scene, as a segment of straight rays projects them
// (oc_core/render/straight_segment.h).
layout(location = 0) flat out uint triangle;
layout(location = 1) out vec2 weights;
layout(location = 2) out vec3 place;  // from the viewpoint

void main() {
  triangle = uint(gl_VertexID) / 3u;
  uint corner = uint(gl_VertexID) % 3u;
  weights = vec2(corner == 1u ? 1 : 0, corner == 2u ? 1 : 0);
  place = position(triangles[gl_VertexID]) - viewpoint.xyz;
  vec3 image = vec3(dotInOrder(place, rowU.xyz), dotInOrder(place, rowV.xyz), dotInOrder(place, rowW.xyz));
  gl_Position = vec4(2.0 * image.xy / pinholeSize - image.z, nearWeight, image.z);
  gl_ClipDistance[0] = dot(begin.xyz, place) + begin.w + margin;
}
