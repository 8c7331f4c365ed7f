// Cuts triangles along epipolar lines and samples the spans (section 3.4.2) as oc_core/render/rasterize_spans.cpp does:
// at the centres of base pixels (TARGET BASE), or where the rays that edges added meet them (TARGET SHADOWS). The
// closest sample is found first (STAGE DEPTH), the lowest triangle at its depth then (STAGE INDEX).
#define DEPTH 1
#define INDEX 2

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Items { uvec2 items[]; };
layout(location = 0) uniform uint first;
layout(location = 1) uniform uint count;
layout(binding = 1) uniform sampler2D tops;
#if STAGE == DEPTH
layout(binding = 0, r32ui) uniform uimage2D depths;
#else
layout(binding = 0, r32ui) readonly uniform uimage2D depths;
layout(binding = 1, r32ui) uniform uimage2D indices;
#endif

uint triangle;
int firstCell;  // of the block, and the one behind its last
int endCell;

void keep(ivec2 at, double inverseZ) {
  uint bits = floatBitsToUint(float(1.0LF / inverseZ));
#if STAGE == DEPTH
  imageAtomicMin(depths, at, bits);
#else
  if (imageLoad(depths, at).x == bits) {
    imageAtomicMin(indices, at, triangle);
  }
#endif
}

struct Span {
  int row;
  double from;
  double to;
  double fromInverseZ;
  double toInverseZ;
};

double cross2(dvec2 a, dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// The part of a row's centre line within the triangle.
bool cut(LineTriangle t, int row, out Span span) {
  dvec2 direction = isParallel != 0 ? dvec2(1, 0) : rows[row].direction;
  dvec2 p[3];
  double side[3];
  for (int i = 0; i < 3; ++i) {
    dvec2 q = dvec2(t.corners[i].q);
    p[i] = isParallel != 0 ? dvec2(q.x, q.y - (row + 0.5LF)) : q - epipole;
    side[i] = cross2(direction, p[i]);
  }
  int crossings = 0;
  dvec2 found[2];  // position and 1/z
  for (int i = 0; i < 3; ++i) {
    int a = i;
    int b = i == 2 ? 0 : i + 1;
    if ((side[a] >= 0.0LF) == (side[b] >= 0.0LF)) {
      continue;
    }
    // The same crossing for both triangles at an edge: from the same end.
    if (side[a] < 0.0LF) {
      int other = a;
      a = b;
      b = other;
    }
    double s = side[a] / (side[a] - side[b]);
    dvec2 at = p[a] + (p[b] - p[a]) * s;
    double along = direction.x * at.x + direction.y * at.y;
    if (isParallel == 0 && along <= 0.0LF) {
      continue;  // on the line of the opposite angle
    }
    found[crossings] = dvec2(isParallel != 0 ? along : positionAtRadius(row, along),
                             (1.0LF - s) * double(t.corners[a].inverseZ) + s * double(t.corners[b].inverseZ));
    ++crossings;
  }
  if (crossings == 0) {
    return false;
  }
  if (crossings == 1) {
    // The triangle holds the epipole, where the line ends; x is infinite there itself.
    dvec3 areas = dvec3(cross2(p[1], p[2]), cross2(p[2], p[0]), cross2(p[0], p[1]));
    double sum = areas.x + areas.y + areas.z;
    if (sum == 0.0LF) {
      return false;
    }
    found[1] = dvec2(positionAtRadius(row, 1e-3LF),
                     (areas.x * double(t.corners[0].inverseZ) + areas.y * double(t.corners[1].inverseZ) +
                      areas.z * double(t.corners[2].inverseZ)) / sum);
  }
  bool inOrder = found[0].x <= found[1].x;
  dvec2 from = inOrder ? found[0] : found[1];
  dvec2 to = inOrder ? found[1] : found[0];
  span = Span(row, from.x, to.x, from.y, to.y);
  return true;
}

double inverseZAt(Span span, double position) {
  double share = clamp((position - span.from) / (span.to - span.from), 0.0LF, 1.0LF);
  return span.fromInverseZ + (span.toInverseZ - span.fromInverseZ) * share;
}

// The base pixels whose centres lie in [from, to): the first, and the one behind the last.
ivec2 centresWithin(Span span) {
  double most = double(rows[span.row].length);
  return ivec2(int(clamp(ceil(span.from - 0.5LF), 0.0LF, most)), int(clamp(ceil(span.to - 0.5LF), 0.0LF, most)));
}

#if TARGET == BASE
void draw(Span span) {
  ivec2 centres = centresWithin(span);
  for (int j = max(centres.x, firstCell); j < min(centres.y, endCell); ++j) {
    keep(ivec2(j, span.row), inverseZAt(span, j + 0.5LF));
  }
}
#else
// The ray of L through the centre of base pixel j, where it lies in a shadow.
void drawLeft(Span span, int j) {
  double inverseZ = inverseZAt(span, j + 0.5LF);
  double x = xAt(span.row, j + 0.5LF);
  double y = inverseZ * inverseZScale(x);
  int index = shadowOf(span.row, j + 1, x - disparity * y);
  if (index >= 0 && y < shadows[index].yFar && j >= shadows[index].position - shadows[index].added) {
    keep(ivec2(j + shadows[index].shift, span.row), inverseZ);
  }
}

double xRightAt(int row, double position, double inverseZ) {
  double x = xAt(row, position);
  return isParallel != 0 ? x - disparity * inverseZ : x * (1.0LF - advanceSign * disparity * inverseZ);
}

// Rays of R that cross the span over a cell.
void drawRight(Span span, int cell) {
  // 1/z is linear over the span, so y = slope x + offset; R sees the span from leastRight to mostRight.
  double change = (span.toInverseZ - span.fromInverseZ) / (span.to - span.from);
  double slope = change;
  double offset = span.fromInverseZ - change * span.from;
  if (isParallel == 0) {
    offset = -advanceSign * change;
    slope = advanceSign * (span.fromInverseZ - offset * radiusAt(span.row, span.from));
  }
  double rightFrom = xRightAt(span.row, span.from, span.fromInverseZ);
  double rightTo = xRightAt(span.row, span.to, span.toInverseZ);
  double leastRight = min(rightFrom, rightTo);
  double mostRight = max(rightFrom, rightTo);
  double spread = 1.0LF - disparity * slope;
  // The part over the cell.
  double end = cellBegin(cell + 1);
  double x0 = xAt(span.row, max(span.from, cellBegin(cell)));
  double x1 = xAt(span.row, hasPosition(span.row, end) ? min(span.to, end) : span.to);
  double right0 = x0 * spread - disparity * offset;
  double right1 = x1 * spread - disparity * offset;
  const double kRounding = 1e-6LF;
  uvec2 list = listOver(span.row, cell);
  for (uint i = list.x; i < list.y; ++i) {
    int index = rows[span.row].firstShadow + int(over[i]);
    Shadow shadow = shadows[index];
    double a = positionAt(span.row, right0 + disparity * shadow.yFar);
    double b = positionAt(span.row, right1 + disparity * shadow.yFar);
    double least = double(shadow.position - shadow.added);
    double most = double(shadow.position - 1);
    int column = int(clamp(ceil(min(a, b) - 0.5LF - kRounding), least, most + 1.0LF));
    int last = int(clamp(floor(max(a, b) - 0.5LF + kRounding), least - 1.0LF, most));
    for (; column <= last; ++column) {
      double xRight = xAt(span.row, column + 0.5LF) - disparity * shadow.yFar;
      double x = (xRight + disparity * offset) / spread;
      double y = (x - xRight) / disparity;
      double position = positionAt(span.row, x);
      if (xRight >= leastRight && xRight < mostRight && y >= shadow.yFar && cellOf(position) == cell &&
          shadowOf(span.row, cell, xRight) == index) {
        keep(ivec2(column + shadow.shift, span.row), inverseZAt(span, position));
      }
    }
  }
}

void draw(Span span) {
  int size = rows[span.row].length;
  if (span.to < 0.0LF || span.from >= double(size)) {
    return;
  }
  ivec2 centres = centresWithin(span);
  float farthest = float(min(span.fromInverseZ, span.toInverseZ));
  int cell = max(cellOf(max(span.from, 0.0LF)), firstCell);
  int last = min(cellOf(min(span.to, double(size))), endCell - 1);
  while (true) {
    while (cell <= last && farthest >= texelFetch(tops, ivec2(cell, span.row), 0).x) {
      ++cell;
    }
    if (cell > last) {
      return;
    }
    // A cell begins at the centre of the base pixel before it.
    if (cell - 1 >= centres.x && cell - 1 < centres.y) {
      drawLeft(span, cell - 1);
    }
    if (span.to > span.from) {
      drawRight(span, cell);
    }
    ++cell;
  }
}
#endif

void main() {
  if (gl_GlobalInvocationID.x >= count) {
    return;
  }
  uvec2 item = items[first + gl_GlobalInvocationID.x];
  LineTriangle t = lineTriangle(item.x);
  triangle = t.triangle;
  int firstRow = int(item.y) / blocksPerRow() * blockRows();
  int endRow = min(firstRow + blockRows(), rowCount);
  firstCell = int(item.y) % blocksPerRow() * kBlockCells;
  endCell = firstCell + kBlockCells;
  for (int row = firstRow; row < endRow; ++row) {
    Span span;
    if (cut(t, row, span)) {
      draw(span);
    }
  }
}
