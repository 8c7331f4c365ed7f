// What the ways to give rays share: pieces of rays within a volume, as oc_core/volume_render/ray_pieces.h has them. A
// way defines pieceCount() and pieceAt().
struct RayPiece {
  vec3 from;       // index coordinates
  float length;    // in the unit of extinctions
  vec3 way;        // index coordinates by length
  float t;         // the ray's parameter where the piece begins
  vec3 direction;  // in the scene's world, of length 1
  float tByLength;
  bool continues;  // it begins where the piece before ends
};

// Where rays end at a surface: its colour and the ray's parameter.
const float kNoSurface = 3.0e38;
