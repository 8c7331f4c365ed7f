// Rays of a planar pinhole, or of a general one, cut here: each is one piece at the most.
layout(std140, binding = 1) uniform VolumeExtent {
  mat4 indexFromWorld;
  vec3 eyeIndex;
  float unitsByWorldLength;
  vec4 clips[MAX_CLIPS];  // the normal, and how far within the half space the eye is
  int clipCount;
};

#if LENSES
// A row for each zone, as oc_core/camera/gpc_map.h has it: centre and half extent; 1 / zoom, and outer; the coefficients
// of f in the transition.
layout(binding = 3) uniform sampler2D zones;

vec2 pinholeFromImage(vec2 image) {
  int count = textureSize(zones, 0).y;
  for (int i = 0; i < count; ++i) {
    vec4 place = texelFetch(zones, ivec2(0, i), 0);
    vec2 edges = texelFetch(zones, ivec2(1, i), 0).xy;
    vec2 d = image - place.xy;
    float r = max(abs(d.x) / place.z, abs(d.y) / place.w);
    if (r < edges.y) {
      vec4 c = texelFetch(zones, ivec2(2, i), 0);
      float s = r - 1.0;
      return place.xy + d * (r <= 1.0 ? edges.x : (c.x + s * (c.y + s * (c.z + s * c.w))) / r);
    }
  }
  return image;
}
#else
vec2 pinholeFromImage(vec2 image) {
  return image;
}
#endif

VolumeRayPiece pinholePiece;

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
  vec2 across = (pinholeFromImage(vec2(pixel) + 0.5) - center) / focal;
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
  pinholePiece = VolumeRayPiece(eyeIndex + wayIndex * first, unitLength * (last - first), wayIndex / unitLength, first,
                          way / worldLength, 1.0 / unitLength, false);
  return 1u;
}

VolumeRayPiece pieceAt(uint i) {
  return pinholePiece;
}

vec4 surfaceOf(uint inRows) {
  return vec4(0, 0, 0, kNowhere);
}
