// Image points of an epipolar occlusion camera: EpipolarCamera::project().
struct Projected {
  vec2 place;
  float t;  // 0 where the point has no image
};

layout(location = 8) uniform int imageWidth;

int rowOf(float row) {
  float floored = floor(row);
  if (isRing != 0) {
    floored -= float(rowCount) * floor(floored / float(rowCount));
  }
  return int(clamp(floored, 0.0, float(rowCount - 1)));
}
// Columns that are added before a base position.
int shiftAt(int row, double position) {
  int below = rows[row].firstDisocclusion;
  int above = below + rows[row].disocclusionCount;
  while (below < above) {
    int middle = (below + above) / 2;
    if (position < disocclusions[middle].position) {
      above = middle;
    } else {
      below = middle + 1;
    }
  }
  return below == rows[row].firstDisocclusion ? 0 : disocclusions[below - 1].shift;
}

Projected project(vec3 worldPoint) {
  vec3 p = cameraFromWorld(worldPoint);
  if (!(p.z >= zNear && p.z <= zFar)) {
    return Projected(vec2(0), 0.0);
  }
  vec2 q = imageFromCamera(p);
  float rowPlace = rowCoordinate(q);
  int row = rowOf(rowPlace);
  double position = isParallel != 0 ? double(q.x) : positionAtRadius(row, length(dvec2(q) - epipole));
  double column = position;
  if (position >= rows[row].length) {
    column += imageWidth - rows[row].length;  // beyond the base image: beyond this one
  } else if (position >= 0.0LF) {
    double x = xAt(row, position);
    double y = inverseZScale(x) / double(p.z);
    int index = disocclusionOf(row, cellOf(position), x - disparity * y);
    if (index >= 0 && (y >= disocclusions[index].yFar || position < disocclusions[index].position)) {
      double xFar = x - disparity * max(0.0LF, y - disocclusions[index].yFar);
      column = positionAt(row, xFar) + disocclusions[index].shift;
    } else {
      column += shiftAt(row, position);
    }
  }
  return Projected(vec2(column, rowPlace), p.z);
}
