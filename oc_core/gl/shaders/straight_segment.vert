// Corners of triangles as a segment of straight rays projects them (oc_core/render/straight_segment.h).
layout(location = 0) in vec3 worldPoint;
layout(location = 2) in uint firstIndex;  // of the draw
layout(location = 0) flat out uint firstTriangle;
#ifdef TESTED
layout(location = 1) out vec3 place;  // from the viewpoint
#endif

void main() {
  firstTriangle = firstIndex / 3u;
  vec3 p = worldPoint - viewpoint.xyz;
  vec3 image = vec3(dotInOrder(p, rowU.xyz), dotInOrder(p, rowV.xyz), dotInOrder(p, rowW.xyz));
  gl_Position = vec4(2.0 * image.xy / pinholeSize - image.z, nearWeight, image.z);
#ifdef TESTED
  place = p;
  gl_ClipDistance[0] = dot(begin.xyz, p) + begin.w + margin;
#else
  gl_ClipDistance[0] = 1.0;
#endif
}
