// Where a volume shows nothing: oc_core/volume_render/volume_occupancy.h.
layout(binding = 1) uniform usampler3D bricks;  // how many bricks away something is seen; 0 within

ivec3 brickOf(vec3 index) {
  return clamp(ivec3(floor(index / float(BRICK_EDGE))), ivec3(0), textureSize(bricks, 0) - 1);
}

// 0 where the brick of a place shows something.
int emptyBricksAround(vec3 index) {
  return int(texelFetch(bricks, brickOf(index), 0).r);
}

// How many steps from a place on, no farther than a length, end where `distance` bricks around it show nothing.
uint emptySteps(vec3 index, vec3 way, float length, int distance, float stepLength) {
  ivec3 brick = brickOf(index);
  ivec3 first = brick - (distance - 1);
  ivec3 end = brick + distance;
  ivec3 size = textureSize(bricks, 0);
  for (int axis = 0; axis < 3; ++axis) {
    // The outermost bricks hold all that lies beyond.
    bool isOpen = way[axis] > 0.0 ? end[axis] >= size[axis] : first[axis] <= 0;
    if (way[axis] != 0.0 && !isOpen) {
      float wall = float(BRICK_EDGE * (way[axis] > 0.0 ? end[axis] : first[axis]));
      length = min(length, (wall - index[axis]) / way[axis]);
    }
  }
  // No more than there are: a thousandth of a step is more than lengths are rounded.
  return uint(max(length / stepLength - 1e-3, 0.0));
}
