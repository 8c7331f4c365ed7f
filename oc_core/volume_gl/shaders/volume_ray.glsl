// What the ways to give rays share: pieces of rays within a volume, as oc_core/volume_render/ray_pieces.h has them. A
// way defines pieceCount(), pieceAt() and surfaceOf().
layout(local_size_x = 8, local_size_y = 8) in;
layout(location = 0) uniform int firstRow;  // of the image
layout(location = 1) uniform int endRow;

struct VolumeRayPiece {
  vec3 from;       // index coordinates
  float length;    // in the unit of extinctions
  vec3 way;        // index coordinates by length
  float t;         // the ray's parameter where the piece begins
  vec3 direction;  // in the scene's world, of length 1
  float tByLength;
  bool continues;  // it begins where the piece before ends
};
const VolumeRayPiece kNoPiece = VolumeRayPiece(vec3(0), 0.0, vec3(0), 0.0, vec3(0), 0.0, false);

// A parameter that no ray has.
const float kNowhere = 3.0e38;
