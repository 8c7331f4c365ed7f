// Rays of any camera, as the CPU has cut them: the pieces of some rows of an image, one pixel after the other.
layout(std430, binding = 3) readonly buffer Pieces { vec4 pieces[]; };  // three each
// Of each pixel, and one behind the last: where its pieces begin.
layout(std430, binding = 4) readonly buffer FirstPieces { uint firstPiece[]; };
#if SURFACES
layout(std430, binding = 5) readonly buffer Surfaces { vec4 surfaces[]; };
#endif

uint listedPixel;

uint pieceCount(ivec2 pixel) {
  listedPixel = uint((pixel.y - int(firstRow)) * imageSize(colors).x + pixel.x);
  return firstPiece[listedPixel + 1u] - firstPiece[listedPixel];
}

RayPiece pieceAt(uint i) {
  uint at = 3u * (firstPiece[listedPixel] + i);
  vec4 a = pieces[at];
  vec4 b = pieces[at + 1u];
  vec4 c = pieces[at + 2u];
  return RayPiece(a.xyz, abs(a.w), b.xyz, b.w, c.xyz, c.w, a.w < 0.0);
}

vec4 surfaceOf() {
#if SURFACES
  return surfaces[listedPixel];
#else
  return vec4(0, 0, 0, kNoSurface);
#endif
}
