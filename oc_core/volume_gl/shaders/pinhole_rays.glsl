// Rays of a planar pinhole, cut here: each is one piece at the most.
layout(std140, binding = 3) uniform VolumeExtent {
  mat4 indexFromWorld;
  vec4 eyeIndex;  // and the unit of extinctions by the scene's lengths
  vec4 clips[MAX_CLIPS];  // normal, and how far within the half space the eye is
  uint clipCount;
};

RayPiece pinholePiece;

// A half space cuts what lies between two depths: `height` is how far within it the eye is, `slope` what a unit of
// depth adds.
bool narrow(float height, float slope, inout float first, inout float last) {
  if (slope == 0.0) {
    return height >= 0.0;
  }
  float z = -height / slope;
  if (slope > 0.0) {
    first = max(first, z);
  } else {
    last = min(last, z);
  }
  return first < last;
}

uint pieceCount(ivec2 pixel) {
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
  for (uint i = 0u; i < clipCount; ++i) {
    if (!narrow(clips[i].w, dot(clips[i].xyz, way), first, last)) {
      return 0u;
    }
  }
  float worldLength = length(way);
  float unitLength = worldLength * eyeIndex.w;
  pinholePiece = RayPiece(eyeIndex.xyz + wayIndex * first, unitLength * (last - first), wayIndex / unitLength, first,
                          way / worldLength, 1.0 / unitLength, false);
  return 1u;
}

RayPiece pieceAt(uint i) {
  return pinholePiece;
}

vec4 surfaceOf() {
  return vec4(0, 0, 0, kNoSurface);
}
