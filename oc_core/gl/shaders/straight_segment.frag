// What lies in a segment. TESTED: triangles may reach out of it; kept is what lies behind its first plane, before those
// where the rays of the pixel end.
layout(location = 0) flat in uint firstTriangle;
layout(location = 0) out uvec2 sample_;
#ifdef TESTED
layout(location = 1) in vec3 place;
layout(binding = 0) uniform usampler2D leaves;
// Of each leaf: the kind of its rays in this segment, -1 where they do not pass it.
layout(std430, binding = 2) readonly buffer EndsOfLeaves { int endsOfLeaves[]; };
// Of each kind: where its planes begin, and how many there are.
layout(std430, binding = 3) readonly buffer Kinds { uvec2 kinds[]; };
layout(std430, binding = 4) readonly buffer Planes { vec4 planes[]; };

bool isInSegment() {
  vec3 across = dFdx(place);
  vec3 down = dFdy(place);
  float size = length(place + viewpoint.xyz);
  bool inside = dot(begin.xyz, place) + begin.w >= -overlapOf(dot(begin.xyz, across), dot(begin.xyz, down), size);
  uint kind = 0u;
  if (kindCount != 1u) {
    kind = uint(max(endsOfLeaves[texelFetch(leaves, ivec2(gl_FragCoord.xy), 0).x], 0));
  }
  uvec2 range = kindCount != 1u ? kinds[kind] : uvec2(0u, planeCount);
  for (uint i = 0u; i < range.y; ++i) {
    vec4 plane = kindCount != 1u ? planes[range.x + i] : endPlanes[i];
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
