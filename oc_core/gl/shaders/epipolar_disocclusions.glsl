// The disocclusions over epipolar lines, as oc_core/camera/epipolar_camera.h has them.
struct Disocclusion {
  int position;
  int added;
  int shift;
  int unused;
  double xRight;
  double yFar;
};
layout(std430, binding = 5) readonly buffer Disocclusions { Disocclusion disocclusions[]; };
// For each cell of each row where its list begins, and then the lists: indices of disocclusions within their row.
layout(std430, binding = 6) readonly buffer Over { uint over[]; };

uvec2 listOver(int row, int cell) {
  int i = row * (longest + 1) + cell;
  return uvec2(over[i], over[i + 1]);
}

// The disocclusion that a point over a cell is in, given its x - D y; -1 for none.
int disocclusionOf(int row, int cell, double xRight) {
  uvec2 list = listOver(row, cell);
  for (uint i = list.x; i < list.y; ++i) {
    int index = rows[row].firstDisocclusion + int(over[i]);
    if (xRight > disocclusions[index].xRight) {
      return index;
    }
  }
  return -1;
}
