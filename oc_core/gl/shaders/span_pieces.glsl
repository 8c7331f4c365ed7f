// Triangles of the scene and what clipping left of some, in the base image.
#define TRIANGLES 1
#define PIECES 2
layout(std430, binding = 7) readonly buffer Pieces { uint pieces[]; };

const uint kIsPiece = 0x80000000u;

// An item of work is a triangle in a block: so many rows, and so many cells of each. Its loops stay short, since a
// driver may end a shader after 2^16 rounds of them, silently. Blocks are numbered row by row.
const int kBlockCells = 4096;
int blockRows() {
  return clamp(4096 / longest, 1, 16);
}
int blocksPerRow() {
  return longest / kBlockCells + 1;
}

struct LineVertex {
  vec2 q;
  float inverseZ;
};
struct LineTriangle {
  uint triangle;
  LineVertex corners[3];
};

LineVertex lineVertex(vec3 p) {
  return LineVertex(imageFromCamera(p), 1.0 / p.z);
}

// `source` is the index of a triangle, or that of a piece with a bit set.
LineTriangle lineTriangle(uint source) {
  vec2 b[3] = vec2[3](vec2(0, 0), vec2(1, 0), vec2(0, 1));
  uint triangle = source;
  if ((source & kIsPiece) != 0u) {
    uint at = kPieceWords * (source & ~kIsPiece);
    triangle = pieces[at];
    for (uint i = 0u; i < 3u; ++i) {
      b[i] = uintBitsToFloat(uvec2(pieces[at + 1u + 2u * i], pieces[at + 2u + 2u * i]));
    }
  }
  uvec3 vertices = triangleVertices(triangle);
  vec3 corners[3] = vec3[3](cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                            cameraFromWorld(position(vertices.z)));
  LineTriangle made;
  made.triangle = triangle;
  for (int i = 0; i < 3; ++i) {
    made.corners[i] = lineVertex(pointOf(corners, b[i]));
  }
  return made;
}

float rowStep(float from, float to) {
  float step = to - from;
  float bend = float(rowCount);
  return step > bend / 2.0 ? step - bend : step < -bend / 2.0 ? step + bend : step;
}

// Rows that may cross a triangle, with room for rounding of angles; the last may be beyond the last row of a ring.
ivec2 rowsOf(LineTriangle t) {
  float slack = isParallel != 0 ? 0.01 : 0.25;
  float a = rowCoordinate(t.corners[0].q);
  float b = rowCoordinate(t.corners[1].q);
  float c = rowCoordinate(t.corners[2].q);
  if (isRing == 0) {
    return ivec2(max(int(ceil(min(a, min(b, c)) - 0.5 - slack)), 0),
                 min(int(floor(max(a, max(b, c)) - 0.5 + slack)), rowCount - 1));
  }
  float toB = rowStep(a, b);
  float toC = rowStep(a, c);
  ivec2 range = ivec2(int(ceil(a + min(0.0, min(toB, toC)) - 0.5 - slack)),
                      int(floor(a + max(0.0, max(toB, toC)) - 0.5 + slack)));
  bool holdsEpipole = abs(toB + rowStep(b, c) + rowStep(c, a)) > float(rowCount) / 2.0;
  return holdsEpipole || range.y - range.x >= rowCount ? ivec2(0, rowCount - 1) : range;
}
int wrappedRow(int row) {
  return row < 0 ? row + rowCount : row >= rowCount ? row - rowCount : row;
}
