// Depths before a segment is drawn: as far away as can be where its rays pass, nearer than all else where they do not.
layout(binding = 0) uniform usampler2D leaves;
layout(std430, binding = 2) readonly buffer EndsOfLeaves { int endsOfLeaves[]; };

void main() {
  gl_FragDepth = endsOfLeaves[texelFetch(leaves, ivec2(gl_FragCoord.xy), 0).x] < 0 ? 1.0 : 0.0;
}
