// What lies in a segment. TESTED: triangles may reach out of it; kept is what lies behind its first plane and before
// those where rays end.
layout(location = 0) flat in uint firstTriangle;
layout(location = 0) out uvec2 sample_;
#ifdef TESTED
layout(location = 1) in vec3 place;
// Where rays end, beyond the first planes.
layout(std430, binding = 2) readonly buffer Planes { vec4 planes[]; };

bool isInSegment() {
  vec3 across = dFdx(place);
  vec3 down = dFdy(place);
  float size = length(place + viewpoint.xyz);
  bool inside = dot(begin.xyz, place) + begin.w >= -overlapOf(dot(begin.xyz, across), dot(begin.xyz, down), size);
  for (uint i = 0u; i < planeCount; ++i) {
    vec4 plane = i < kEndPlanes ? endPlanes[i] : planes[i];
    float height = dot(plane.xyz, place) + plane.w;
    inside = inside && height <= overlapOf(dot(plane.xyz, across), dot(plane.xyz, down), size);
  }
  return inside;
}
#endif

void main() {
#ifdef TESTED
  if (!isInSegment()) {
    discard;
  }
#endif
  sample_ = uvec2(piece, firstTriangle + uint(gl_PrimitiveID));
}
