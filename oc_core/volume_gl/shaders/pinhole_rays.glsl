// Rays of a planar pinhole, cut here: each is one piece at the most.
layout(std140, binding = 1) uniform VolumeExtent {
  mat4 indexFromWorld;
  vec3 eyeIndex;
  float unitsByWorldLength;
  vec4 clips[MAX_CLIPS];  // the normal, and how far within the half space the eye is
  int clipCount;
};

RayPiece pinholePiece;

// A half space cuts what lies between two depths: `height` is how far within it the eye is, and grows by `slope` with
// depth. False where nothing is left.
bool narrow(float height, float slope, inout float first, inout float last) {
  if (slope == 0.0) {
    return height >= 0.0;
  }
  float z = -height / slope;
  first = slope > 0.0 ? max(first, z) : first;
  last = slope < 0.0 ? min(last, z) : last;
  return first < last;
}

uint pieceCount(ivec2 pixel, uint inRows) {
  vec2 across = (vec2(pixel) + 0.5 - center) / focal;
  vec3 way = forward + across.x * right + across.y * down;
  vec3 wayIndex = mat3(indexFromWorld) * way;
  vec3 upper = vec3(textureSize(voxels, 0)) - 0.5;
  float first = zNear;
  float last = zFar;
  for (int axis = 0; axis < 3; ++axis) {
    if (!narrow(eyeIndex[axis] + 0.5, wayIndex[axis], first, last) ||
        !narrow(upper[axis] - eyeIndex[axis], -wayIndex[axis], first, last)) {
      return 0u;
    }
  }
  for (int i = 0; i < clipCount; ++i) {
    if (!narrow(clips[i].w, dot(clips[i].xyz, way), first, last)) {
      return 0u;
    }
  }
  float worldLength = length(way);
  float unitLength = worldLength * unitsByWorldLength;
  pinholePiece = RayPiece(eyeIndex + wayIndex * first, unitLength * (last - first), wayIndex / unitLength, first,
                          way / worldLength, 1.0 / unitLength, false);
  return 1u;
}

RayPiece pieceAt(uint i) {
  return pinholePiece;
}

vec4 surfaceOf(uint inRows) {
  return vec4(0, 0, 0, kNowhere);
}
