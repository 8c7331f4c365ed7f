// Depths before rays of one kind are drawn: as far away as can be where they pass, nearer than all else where not.
layout(binding = 0) uniform usampler2D leaves;
layout(std430, binding = 2) readonly buffer IsOfKind { uint isOfKind[]; };  // of each leaf

void main() {
  gl_FragDepth = isOfKind[texelFetch(leaves, ivec2(gl_FragCoord.xy), 0).x] != 0u ? 0.0 : 1.0;
}
