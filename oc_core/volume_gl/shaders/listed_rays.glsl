// Rays of any camera, cut on the CPU: the pieces of some rows of an image, one pixel after the other.
layout(std430, binding = 2) readonly buffer Pieces { vec4 pieces[]; };  // three each
// Of each pixel, and one behind the last: where its pieces begin.
layout(std430, binding = 3) readonly buffer FirstPieces { uint firstPiece[]; };
#if SURFACES
layout(std430, binding = 4) readonly buffer Surfaces { vec4 surfaces[]; };
#endif

uint listedFrom;

uint pieceCount(ivec2 pixel, uint inRows) {
  listedFrom = firstPiece[inRows];
  return firstPiece[inRows + 1u] - listedFrom;
}

VolumeRayPiece pieceAt(uint i) {
  uint at = 3u * (listedFrom + i);
  vec4 a = pieces[at];
  vec4 b = pieces[at + 1u];
  vec4 c = pieces[at + 2u];
  return VolumeRayPiece(a.xyz, abs(a.w), b.xyz, b.w, c.xyz, c.w, a.w < 0.0);
}

// The colour of the surface at which a ray ends, and its parameter there.
vec4 surfaceOf(uint inRows) {
#if SURFACES
  return surfaces[inRows];
#else
  return vec4(0, 0, 0, kNowhere);
#endif
}
