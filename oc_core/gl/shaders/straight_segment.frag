// Keeps what lies in the segment: behind its first plane, before those where the rays of the pixel end.
layout(location = 0) flat in uint triangle;
layout(location = 1) in vec2 weights;
layout(location = 2) in vec3 place;
layout(binding = 0) uniform usampler2D leaves;
// Of each leaf: the kind of its rays in this segment, -1 where they do not pass it.
layout(std430, binding = 2) readonly buffer EndsOfLeaves { int endsOfLeaves[]; };
// Of each kind: where its planes begin, and how many there are.
layout(std430, binding = 3) readonly buffer Kinds { uvec2 kinds[]; };
layout(std430, binding = 4) readonly buffer Planes { vec4 planes[]; };
layout(location = 0) out uvec4 sample_;

void main() {
  vec3 across = dFdx(place);
  vec3 down = dFdy(place);
  float size = length(place + viewpoint.xyz);
  if (dot(begin.xyz, place) + begin.w < -overlapOf(dot(begin.xyz, across), dot(begin.xyz, down), size)) {
    discard;
  }
  int kind = endsOfLeaves[firstOfLeaves + texelFetch(leaves, ivec2(gl_FragCoord.xy), 0).x];
  if (kind < 0) {
    discard;
  }
  uvec2 range = kinds[kind];
  for (uint i = 0u; i < range.y; ++i) {
    vec4 plane = planes[range.x + i];
    float height = dot(plane.xyz, place) + plane.w;
    if (height > overlapOf(dot(plane.xyz, across), dot(plane.xyz, down), size)) {
      discard;
    }
  }
  sample_ = uvec4(piece, triangle, floatBitsToUint(weights));
}
