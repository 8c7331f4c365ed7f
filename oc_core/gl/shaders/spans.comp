// Cuts triangles along epipolar lines and samples the spans (section 3.4.2) as oc_core/render/rasterize_spans.cpp does:
// at the centres of base pixels (TARGET BASE), or where the rays that edges added meet them (TARGET DISOCCLUSIONS). The
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

// A corner of a triangle beside a row's centre line. Not in arrays: some drivers (NVIDIA 580) keep those of doubles as
// floats where a variable indexes them.
struct LineCorner {
  dvec2 p;
  double side;
  double inverseZ;
};

LineCorner lineCorner(vec2 corner, float inverseZ, int row, dvec2 direction) {
  dvec2 q = dvec2(corner);
  dvec2 p = isParallel != 0 ? dvec2(q.x, q.y - (row + 0.5LF)) : q - epipole;
  return LineCorner(p, cross2(direction, p), double(inverseZ));
}

// Where an edge crosses the line: position and 1/z. From the end with the larger side, so that both triangles at an edge
// have the same.
bool crosses(LineCorner a, LineCorner b, int row, dvec2 direction, out dvec2 found) {
  found = dvec2(0);
  if ((a.side >= 0.0LF) == (b.side >= 0.0LF)) {
    return false;
  }
  if (a.side < 0.0LF) {
    LineCorner other = a;
    a = b;
    b = other;
  }
  double s = a.side / (a.side - b.side);
  dvec2 at = a.p + (b.p - a.p) * s;
  double along = direction.x * at.x + direction.y * at.y;
  if (isParallel == 0 && along <= 0.0LF) {
    return false;  // on the line of the opposite angle
  }
  found = dvec2(isParallel != 0 ? along : positionAtRadius(row, along), (1.0LF - s) * a.inverseZ + s * b.inverseZ);
  return true;
}

// The part of a row's centre line within the triangle.
bool cut(LineTriangle t, int row, out Span span) {
  dvec2 direction = isParallel != 0 ? dvec2(1, 0) : rows[row].direction;
  LineCorner a = lineCorner(t.corners[0].q, t.corners[0].inverseZ, row, direction);
  LineCorner b = lineCorner(t.corners[1].q, t.corners[1].inverseZ, row, direction);
  LineCorner c = lineCorner(t.corners[2].q, t.corners[2].inverseZ, row, direction);
  dvec2 onAB, onBC, onCA;
  bool crossesAB = crosses(a, b, row, direction, onAB);
  bool crossesBC = crosses(b, c, row, direction, onBC);
  bool crossesCA = crosses(c, a, row, direction, onCA);
  int crossings = int(crossesAB) + int(crossesBC) + int(crossesCA);
  if (crossings == 0) {
    return false;
  }
  dvec2 first = crossesAB ? onAB : crossesBC ? onBC : onCA;
  dvec2 second = crossesCA ? onCA : onBC;
  if (crossings == 1) {
    // The triangle holds the epipole, where the line ends; x is infinite there itself.
    dvec3 areas = dvec3(cross2(b.p, c.p), cross2(c.p, a.p), cross2(a.p, b.p));
    double sum = areas.x + areas.y + areas.z;
    if (sum == 0.0LF) {
      return false;
    }
    second = dvec2(positionAtRadius(row, 1e-3LF),
                   (areas.x * a.inverseZ + areas.y * b.inverseZ + areas.z * c.inverseZ) / sum);
  }
  bool inOrder = first.x <= second.x;
  dvec2 from = inOrder ? first : second;
  dvec2 to = inOrder ? second : first;
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
// The ray of L through the centre of base pixel j, where it lies in a disocclusion.
void drawLeft(Span span, int j) {
  double inverseZ = inverseZAt(span, j + 0.5LF);
  double x = xAt(span.row, j + 0.5LF);
  double y = inverseZ * inverseZScale(x);
  int index = disocclusionOf(span.row, j + 1, x - disparity * y);
  if (index >= 0 && y < disocclusions[index].yFar && j >= disocclusions[index].position - disocclusions[index].added) {
    keep(ivec2(j + disocclusions[index].shift, span.row), inverseZ);
  }
}

double xRightAt(int row, double position, double inverseZ) {
  double x = xAt(row, position);
  return isParallel != 0 ? x - disparity * inverseZ : x * (1.0LF - advanceSign * disparity * inverseZ);
}

// Rays of R that cross the span over a cell.
void drawRight(Span span, int cell) {
  // 1/z is linear over the span, so y = slope x + offset; R sees the span from minRight to maxRight.
  double change = (span.toInverseZ - span.fromInverseZ) / (span.to - span.from);
  double slope = change;
  double offset = span.fromInverseZ - change * span.from;
  if (isParallel == 0) {
    offset = -advanceSign * change;
    slope = advanceSign * (span.fromInverseZ - offset * radiusAt(span.row, span.from));
  }
  double rightFrom = xRightAt(span.row, span.from, span.fromInverseZ);
  double rightTo = xRightAt(span.row, span.to, span.toInverseZ);
  double minRight = min(rightFrom, rightTo);
  double maxRight = max(rightFrom, rightTo);
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
    int index = rows[span.row].firstDisocclusion + int(over[i]);
    Disocclusion disocclusion = disocclusions[index];
    double a = positionAt(span.row, right0 + disparity * disocclusion.yFar);
    double b = positionAt(span.row, right1 + disparity * disocclusion.yFar);
    double least = double(disocclusion.position - disocclusion.added);
    double most = double(disocclusion.position - 1);
    int column = int(clamp(ceil(min(a, b) - 0.5LF - kRounding), least, most + 1.0LF));
    int last = int(clamp(floor(max(a, b) - 0.5LF + kRounding), least - 1.0LF, most));
    for (; column <= last; ++column) {
      double xRight = xAt(span.row, column + 0.5LF) - disparity * disocclusion.yFar;
      double x = (xRight + disparity * offset) / spread;
      double y = (x - xRight) / disparity;
      double position = positionAt(span.row, x);
      if (xRight >= minRight && xRight < maxRight && y >= disocclusion.yFar && cellOf(position) == cell &&
          disocclusionOf(span.row, cell, xRight) == index) {
        keep(ivec2(column + disocclusion.shift, span.row), inverseZAt(span, position));
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
