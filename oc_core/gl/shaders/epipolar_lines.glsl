// Epipolar lines as oc_core/camera/epipolar_lines.h has them, and their cells (epipolar_camera.h).
layout(std140, binding = 1) uniform Lines {
  dvec2 epipole;
  double disparity;
  double advanceSign;
  int rowCount;
  int longest;
  int isParallel;
  int isForward;
  int isRing;
  float firstAngle;
  float angleStep;
  float clipMargin;
};

struct Row {
  dvec2 direction;
  int start;
  int length;
  int firstDisocclusion;
  int disocclusionCount;
};
layout(std430, binding = 4) readonly buffer Rows { Row rows[]; };

double positionAtRadius(int row, double radius) {
  return isForward != 0 ? rows[row].start - radius : radius - rows[row].start;
}
double radiusAt(int row, double position) {
  return isForward != 0 ? rows[row].start - position : rows[row].start + position;
}
bool hasPosition(int row, double position) {
  return isParallel != 0 || radiusAt(row, position) > 0.0LF;
}
double xAt(int row, double position) {
  if (isParallel != 0) {
    return position;
  }
  double inverse = 1.0LF / radiusAt(row, position);
  return isForward != 0 ? inverse : -inverse;
}
double positionAt(int row, double x) {
  return isParallel != 0 ? x : positionAtRadius(row, (isForward != 0 ? 1.0LF : -1.0LF) / x);
}
double inverseZScale(double x) {
  return isParallel != 0 ? 1.0LF : isForward != 0 ? x : -x;
}
dvec2 linePoint(int row, double position) {
  return isParallel != 0 ? dvec2(position, row + 0.5LF) : epipole + rows[row].direction * radiusAt(row, position);
}

// The row's coordinate of a point of the base image.
float rowCoordinate(vec2 q) {
  if (isParallel != 0) {
    return q.y;
  }
  vec2 d = vec2(dvec2(q) - epipole);
  const float kTurn = 6.28318530718;
  float halfTurn = angleStep * float(rowCount) / 2.0;
  float angle = atan(d.y, d.x) - firstAngle - halfTurn;
  return (angle - kTurn * round(angle / kTurn) + halfTurn) / angleStep;
}
double cellBegin(int cell) {
  return double(cell) - 0.51LF;
}
int cellOf(double position) {
  return int(position + 0.51LF);
}
