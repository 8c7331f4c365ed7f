// Clips triangles to the frustum, widened by `clipMargin` pixels, as oc_core/render/frustum_clip.h does; what is left
// goes to the children, as triangles around its first corner. Counted first (STAGE COUNT), written then (EMIT).
//
// The polygon lies in shared memory: drivers that keep variables in registers take long over arrays with an index that
// varies.
#define COUNT 1
#define EMIT 2

layout(std430, binding = 2) readonly buffer Source { uint source[]; };
#if STAGE == EMIT
layout(std430, binding = 5) writeonly buffer Children { uint children[]; };
#endif

const int kMaxCorners = 9;
const int kPlanes = 6;

// A polygon of each invocation, and the one that clipping makes of it: x, y, z, b1, b2 of each corner.
shared double polygons[2][kGroup][kMaxCorners * 5];

double coordinate(int which, int corner, int k) {
  return polygons[which][gl_LocalInvocationID.x][5 * corner + k];
}
void setCoordinate(int which, int corner, int k, double value) {
  polygons[which][gl_LocalInvocationID.x][5 * corner + k] = value;
}

// How far inside of a plane of the frustum a corner lies.
double inside(int plane, int which, int corner) {
  double z = coordinate(which, corner, 2);
  if (plane < 2) {
    return plane == 0 ? z - double(zNear) : double(zFar) - z;
  }
  int axis = (plane - 2) / 2;
  double margin = double(clipMargin);
  double middle = double(center[axis]);
  double p = coordinate(which, corner, axis);
  return (plane & 1) == 0 ? p + z * ((middle + margin) / double(focal))
                          : z * ((double(pinholeSize[axis]) - middle + margin) / double(focal)) - p;
}

// Clips the polygon `corners` long at `which` against each plane; leaves it there, and returns its length. A cut is
// computed from its inner end to its outer one, so triangles that share an edge cut it alike.
int clipped(int corners, inout int which) {
  for (int plane = 0; plane < kPlanes; ++plane) {
    int kept = 0;
    for (int i = 0; i < corners; ++i) {
      int j = i + 1 == corners ? 0 : i + 1;
      double di = inside(plane, which, i);
      double dj = inside(plane, which, j);
      if (di >= 0.0LF && kept < kMaxCorners) {
        for (int k = 0; k < 5; ++k) {
          setCoordinate(1 - which, kept, k, coordinate(which, i, k));
        }
        ++kept;
      }
      if ((di >= 0.0LF) != (dj >= 0.0LF) && kept < kMaxCorners) {
        int inner = di >= 0.0LF ? i : j;
        int outer = di >= 0.0LF ? j : i;
        double t = di >= 0.0LF ? di / (di - dj) : dj / (dj - di);
        for (int k = 0; k < 5; ++k) {
          double from = coordinate(which, inner, k);
          setCoordinate(1 - which, kept, k, from + (coordinate(which, outer, k) - from) * t);
        }
        ++kept;
      }
    }
    corners = kept;
    which = 1 - which;
  }
  return corners;
}

// Corners of the triangle at polygon 0; 0 where one is not finite.
int loadTriangle(uint triangle) {
  uvec3 vertices = triangleVertices(triangle);
  for (int i = 0; i < 3; ++i) {
    vec3 p = cameraFromWorld(position(vertices[i]));
    if (any(isnan(p)) || any(isinf(p))) {
      return 0;
    }
    setCoordinate(0, i, 0, double(p.x));
    setCoordinate(0, i, 1, double(p.y));
    setCoordinate(0, i, 2, double(p.z));
    setCoordinate(0, i, 3, i == 1 ? 1.0LF : 0.0LF);
    setCoordinate(0, i, 4, i == 2 ? 1.0LF : 0.0LF);
  }
  return 3;
}

void main() {
  uint item = gl_GlobalInvocationID.x;
  int which = 0;
  int corners = item < count ? clipped(loadTriangle(source[first + item]), which) : 0;
  uint pieces = uint(max(corners - 2, 0));
  uint sum = sumInGroup(packCounts(0u, pieces, 0u));
#if STAGE == COUNT
  if (gl_LocalInvocationID.x == kGroup - 1u) {
    groups[gl_WorkGroupID.x] = unpackCounts(sum);
  }
#else
  uint at = kPieceWords * (groups[gl_WorkGroupID.x].y + unpackCounts(sum).y - pieces);
  for (int i = 2; i < corners; ++i) {
    children[at] = source[first + item];
    for (int k = 0; k < 3; ++k) {
      int corner = k == 0 ? 0 : i - 2 + k;
      children[at + 1u + 2u * uint(k)] = floatBitsToUint(float(coordinate(which, corner, 3)));
      children[at + 2u + 2u * uint(k)] = floatBitsToUint(float(coordinate(which, corner, 4)));
    }
    at += kPieceWords;
  }
#endif
}
