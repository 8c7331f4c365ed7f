// Lights the voxels that triangles pass through: sector_clip.cpp, screen_polygon.cpp and dither.h on the GPU, with the
// same operations in the same order. `precise` keeps compilers from fusing and reordering them.
//
// Real is double, or float where SINGLE is defined. Then rounding could have a surface along the border of two sectors
// miss both, so these overlap by more than it (Triangle.slack).
#ifdef SINGLE
#define Real float
#define Real2 vec2
#define Real3 vec3
#define Real4 vec4
const Real kRounding = 1.0 / 2097152.0;  // 2^-21: some operations of 2^-24 each
#else
#define Real double
#define Real2 dvec2
#define Real3 dvec3
#define Real4 dvec4
const Real kRounding = 0;
#endif

// Some drivers (NVIDIA 580) keep arrays of doubles as floats where a variable indexes them. So arrays hold words.
#ifdef SINGLE
#define Word float
Word wordOf(Real value) { return value; }
Real realOf(Word word) { return word; }
#else
#define Word uvec2
Word wordOf(Real value) { return unpackDouble2x32(value); }
Real realOf(Word word) { return packDouble2x32(word); }
#endif

layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Colors { float colors[]; };
layout(std430, binding = 2) readonly buffer Triangles { uint corners[]; };
layout(std430, binding = 3) readonly buffer Directions { Real2 directions[]; };  // of sectors
layout(std430, binding = 4) buffer Voxels { uint voxels[]; };                    // laid out as gl_volume.h says
layout(std430, binding = 5) buffer Queue {
  uint queuedCount;   // goes on counting where the queue is full
  uvec2 queued[];     // a large triangle, and which kGroupParts of its parts
};

layout(location = 0) uniform int slices;  // of a half turn
layout(location = 1) uniform int width;
layout(location = 2) uniform int height;
layout(location = 3) uniform Real halfHeight;
layout(location = 4) uniform Real slope;  // tan of half a sector
layout(location = 5) uniform bool ownSecondHalf;
layout(location = 6) uniform bool dithered;
layout(location = 7) uniform uint triangleCount;
layout(location = 8) uniform uint room;  // of the queue
layout(location = 9) uniform uint firstGroup;

// Software renderers end a shader after 65535 turns of its loops, all together. So an invocation lights at most so many
// voxels, or a row of a part.
const int kMaxVoxels = 16384;
const int kMaxBandRows = 16;
const uint kGroupParts = 64u;

struct Triangle {
  Real3 a;     // corners: (x, v, z) in columns from the axis and rows from the top
  Real3 b;
  Real3 c;
  Real slack;  // how far sectors reach beyond their borders, in columns
  vec3 color;  // at the first corner, and what the others have more
  vec3 colorB;
  vec3 colorC;
};

vec3 positionOf(uint vertex) {
  return vec3(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
}

vec3 colorOf(uint vertex) {
  return vec3(colors[3 * vertex], colors[3 * vertex + 1], colors[3 * vertex + 2]);
}

Real3 sweepPoint(vec3 position) {
  precise Real3 p = Real3(position.x * (width / Real(2)), (1 - position.y / halfHeight) * (height / Real(2)),
                          position.z * (width / Real(2)));
  return p;
}

Real distanceFromAxis(Real3 corner) {
  return max(abs(corner.x), abs(corner.z));
}

Triangle loadTriangle(uint index) {
  uvec3 t = uvec3(corners[3 * index], corners[3 * index + 1], corners[3 * index + 2]);
  Triangle triangle;
  triangle.a = sweepPoint(positionOf(t.x));
  triangle.b = sweepPoint(positionOf(t.y));
  triangle.c = sweepPoint(positionOf(t.z));
  triangle.slack = kRounding * max(distanceFromAxis(triangle.a),
                                   max(distanceFromAxis(triangle.b), distanceFromAxis(triangle.c)));
  triangle.color = colorOf(t.x);
  precise vec3 colorB = colorOf(t.y) - triangle.color;
  precise vec3 colorC = colorOf(t.z) - triangle.color;
  triangle.colorB = colorB;
  triangle.colorC = colorC;
  return triangle;
}

// The first and last of the `count` unit cells that the closed interval [lo, hi] touches, faces included.
ivec2 touchedCells(Real lo, Real hi, int count) {
  if (!(hi >= 0 && lo <= Real(count))) {
    return ivec2(0, -1);
  }
  int last = int(min(hi, Real(count)));
  Real from = max(lo, Real(0));
  int first = int(from);
  first -= Real(first) == from ? 1 : 0;
  return ivec2(max(first, 0), min(last, count - 1));
}

ivec2 touchedRows(Triangle t) {
  return touchedCells(min(t.a.y, min(t.b.y, t.c.y)), max(t.a.y, max(t.b.y, t.c.y)), height);
}

// A part is a sector and a band of so many rows.
int bandRows() {
  return clamp(kMaxVoxels / width, 1, kMaxBandRows);
}

uint bandsOf(ivec2 rows) {
  return uint((rows.y - rows.x) / bandRows() + 1);
}

// ---- sectors

// Sectors x, x + 1, ..., x + y - 1, each modulo their number: those that a triangle may touch.
ivec2 sectorsOf(uint triangle) {
  // atan() may be wrong by 4096 units of the last place, here of pi, and two angles are subtracted.
  const float kAngleError = 2 * 4096 * 2.4e-7;
  float stepsPerRadian = slices / 3.14159265;
  float angles[3];
  bool onAxis = false;
  for (int k = 0; k < 3; ++k) {
    vec3 p = positionOf(corners[3 * triangle + k]);
    onAxis = onAxis || (p.x == 0 && p.z == 0);
    angles[k] = atan(p.z, p.x) * stepsPerRadian;
  }
  float lo = 0;
  float hi = 0;
  for (int k = 1; k < 3; ++k) {
    float steps = angles[k] - angles[0];
    steps += steps > slices ? -2 * slices : steps < -slices ? 2 * slices : 0;
    lo = min(lo, steps);
    hi = max(hi, steps);
  }
  float margin = 1e-2 + kAngleError * stepsPerRadian;
  lo += angles[0] - margin;
  hi += angles[0] + margin;
  // Seen from the axis a triangle beside it spans less than half a turn, one that holds it at least that.
  if (onAxis || hi - lo >= slices) {
    return ivec2(0, 2 * slices);
  }
  int first = int(floor(lo + 0.5));
  int last = int(floor(hi + 0.5));
  return ivec2((first + 2 * slices) % (2 * slices), last - first + 1);
}

// ---- the part of a triangle in a sector

const int kMaxPoints = 6;

// x: outward, y: across, in columns; z: v; b: weights of the triangle's second and third corner.
struct SectorPoint {
  Real3 at;
  Real2 b;
};

struct StoredPoint {
  Word outward, across, v, b, c;
};

StoredPoint stored(SectorPoint p) {
  return StoredPoint(wordOf(p.at.x), wordOf(p.at.y), wordOf(p.at.z), wordOf(p.b.x), wordOf(p.b.y));
}
SectorPoint loaded(StoredPoint p) {
  return SectorPoint(Real3(realOf(p.outward), realOf(p.across), realOf(p.v)), Real2(realOf(p.b), realOf(p.c)));
}

SectorPoint mixed(SectorPoint a, SectorPoint b, Real t) {
  precise Real3 at = a.at + (b.at - a.at) * t;
  precise Real2 weights = a.b + (b.b - a.b) * t;
  return SectorPoint(at, weights);
}

// Not negative on the inner side of a border: side is 1 or -1.
Real inside(SectorPoint p, Real side, Real slack) {
  precise Real value = p.at.x * slope + side * p.at.y + slack;
  return value;
}

// Points are kept where constants index them: arrays that are indexed by variables are slow memory on many GPUs, and far
// slower on software renderers.
void keep(inout StoredPoint points[kMaxPoints], inout int size, SectorPoint p) {
  for (int i = 0; i < kMaxPoints; ++i) {
    if (i == size) {
      points[i] = stored(p);
    }
  }
  ++size;
}

// The edge from a to b; goes on to b.
void clipEdge(inout StoredPoint points[kMaxPoints], inout int size, inout SectorPoint a, inout Real inA, SectorPoint b,
              Real side, Real slack) {
  Real inB = inside(b, side, slack);
  if ((inA < 0) != (inB < 0)) {
    precise Real t = inA / (inA - inB);
    keep(points, size, mixed(a, b, t));
  }
  if (inB >= 0) {
    keep(points, size, b);
  }
  a = b;
  inA = inB;
}

// Keeps what is inside of one border (Sutherland and Hodgman), of no more than `most` points.
void clipToBorder(inout StoredPoint points[kMaxPoints], inout int size, const int most, Real side, Real slack) {
  StoredPoint whole[kMaxPoints] = points;
  int wholeSize = size;
  size = 0;
  StoredPoint last = whole[0];
  for (int i = 1; i < most; ++i) {
    if (i < wholeSize) {
      last = whole[i];
    }
  }
  SectorPoint a = loaded(last);
  Real inA = inside(a, side, slack);
  for (int i = 0; i < most; ++i) {
    if (i < wholeSize) {
      clipEdge(points, size, a, inA, loaded(whole[i]), side, slack);
    }
  }
}

// A corner in the coordinates of a sector; `outside` counts the corners beyond either border.
SectorPoint cornerInSector(Real3 p, Real2 weights, Real2 direction, Real slack, inout ivec2 outside) {
  precise Real outward = p.x * direction.x + p.z * direction.y;
  precise Real across = p.z * direction.x - p.x * direction.y;
  SectorPoint corner = SectorPoint(Real3(outward, across, p.y), weights);
  outside.x += inside(corner, 1, slack) < 0 ? 1 : 0;
  outside.y += inside(corner, -1, slack) < 0 ? 1 : 0;
  return corner;
}

// A corner of the outline on the screen: column, row, and weights.
struct ScreenPoint {
  Word q, v, b, c;
};

Real4 loaded(ScreenPoint p) {
  return Real4(realOf(p.q), realOf(p.v), realOf(p.b), realOf(p.c));
}

// Returns how many.
int clipToSector(Triangle triangle, int sector, out ScreenPoint screen[kMaxPoints]) {
  Real2 direction = directions[sector];
  StoredPoint points[kMaxPoints];
  ivec2 outside = ivec2(0);
  points[0] = stored(cornerInSector(triangle.a, Real2(0, 0), direction, triangle.slack, outside));
  points[1] = stored(cornerInSector(triangle.b, Real2(1, 0), direction, triangle.slack, outside));
  points[2] = stored(cornerInSector(triangle.c, Real2(0, 1), direction, triangle.slack, outside));
  if (outside.x == 3 || outside.y == 3) {
    return 0;
  }
  int size = 3;
  if (outside.x > 0) {
    clipToBorder(points, size, 3, 1, triangle.slack);
  }
  if (outside.y > 0 && size > 0) {
    clipToBorder(points, size, 4, -1, triangle.slack);
  }
  for (int k = 0; k < kMaxPoints; ++k) {
    precise Real q = width / Real(2) + Real(sector < slices ? 1 : -1) * realOf(points[k].outward);
    screen[k] = ScreenPoint(wordOf(q), points[k].v, points[k].b, points[k].c);
  }
  return size;
}

// ---- voxels

uint reducedBits(vec3 color, int slice, int column, int row) {
  uint sum = uint(column) * 2686409057u + uint(row) * 3288575657u + uint(slice) * 1928973365u;
  float threshold = dithered ? (float(sum >> 9) + 0.5) * (1.0 / 8388608.0) : 0.0;
  return (color.x > threshold ? 1u : 0u) | (color.y > threshold ? 2u : 0u) | (color.z > threshold ? 4u : 0u);
}

// Lights columns of a row between two points of the triangle, at whose chord the colours are taken. `mirrored`: in the
// slice that the second half turn has of its own.
void lightColumns(Triangle triangle, int slice, int row, Real4 lo, Real4 hi, ivec2 columns, bool mirrored) {
  slice += mirrored ? slices : 0;
  uint rowWords = uint(width + 7) / 8;
  uint base = (uint(slice) * uint(height) + uint(row)) * rowWords;
  uint at = 0;
  uint word = 0;
  precise Real span = hi.x - lo.x;
  for (int column = columns.x; column <= columns.y; ++column) {
    precise Real t = span > 0 ? clamp((column + Real(0.5) - lo.x) / span, Real(0), Real(1)) : Real(0);
    precise Real2 b = lo.zw + (hi.zw - lo.zw) * t;
    precise vec3 color = triangle.color + triangle.colorB * float(b.x) + triangle.colorC * float(b.y);
    int shown = mirrored ? width - 1 - column : column;
    if (word != 0u && at != uint(shown) / 8) {
      atomicOr(voxels[base + at], word);
      word = 0;
    }
    at = uint(shown) / 8;
    word |= reducedBits(color, slice, shown, row) << (shown % 8 * 4);
  }
  if (word != 0u) {
    atomicOr(voxels[base + at], word);
  }
}

void extend(inout Real4 lo, inout Real4 hi, Real4 point) {
  if (point.x < lo.x) {
    lo = point;
  }
  if (point.x > hi.x) {
    hi = point;
  }
}

// What a corner and the edge after it add to the extent of a row.
void extendByEdge(inout Real4 lo, inout Real4 hi, Real4 a, Real4 b, int row) {
  if (a.y >= Real(row) && a.y <= Real(row + 1)) {
    extend(lo, hi, a);
  }
  for (int border = row; border <= row + 1; ++border) {
    precise Real t = (Real(border) - a.y) / (b.y - a.y);
    if (t > 0 && t < 1) {
      precise Real4 crossing = a + (b - a) * t;
      extend(lo, hi, crossing);
    }
  }
}

// Lights what the triangle touches in a sector, of the rows given.
void lightSector(Triangle triangle, int sector, ivec2 within) {
  ScreenPoint points[kMaxPoints];
  int size = clipToSector(triangle, sector, points);
  if (size == 0) {
    return;
  }
  Real top = realOf(points[0].v);
  Real bottom = top;
  for (int i = 1; i < kMaxPoints; ++i) {
    if (i < size) {
      top = min(top, realOf(points[i].v));
      bottom = max(bottom, realOf(points[i].v));
    }
  }
  ivec2 rows = touchedCells(top, bottom, height);
  rows = ivec2(max(rows.x, within.x), min(rows.y, within.y));
  int slice = sector < slices ? sector : sector - slices;
  for (int row = rows.x; row <= rows.y; ++row) {
    // Within a row the extreme points are corners of the polygon or lie where its outline crosses the row's border.
    Real4 lo = Real4(1e30);
    Real4 hi = Real4(-1e30);
    for (int i = 0; i < kMaxPoints; ++i) {
      if (i < size) {
        bool last = i + 1 == size || i + 1 == kMaxPoints;
        Real4 next = loaded(points[min(i + 1, kMaxPoints - 1)]);
        extendByEdge(lo, hi, loaded(points[i]), last ? loaded(points[0]) : next, row);
      }
    }
    ivec2 columns = touchedCells(lo.x, hi.x, width);
    for (int turn = 0; turn < (ownSecondHalf ? 2 : 1); ++turn) {
      lightColumns(triangle, slice, row, lo, hi, columns, turn == 1);
    }
  }
}
