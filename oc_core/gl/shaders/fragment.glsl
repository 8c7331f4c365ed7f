// A texel of a fragment image is what oc_core/render/fragment_image.h holds: bits of z, triangle, bits of b1 and b2.
const uint kNoTriangle = 0xffffffffu;
const uvec4 kNoFragment = uvec4(0u, kNoTriangle, 0u, 0u);

uvec4 packFragment(float z, uint triangle, vec2 b) {
  return uvec4(floatBitsToUint(z), triangle, floatBitsToUint(b.x), floatBitsToUint(b.y));
}
float zOf(uvec4 fragment) {
  return uintBitsToFloat(fragment.x);
}
vec2 weightsOf(uvec4 fragment) {
  return uintBitsToFloat(fragment.zw);
}
