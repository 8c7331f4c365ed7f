// Clips triangles to the frustum, widened by `clipMargin` pixels, as oc_core/render/frustum_clip.h does; what is
// left goes to the children, as triangles around its first corner. Counted first (STAGE COUNT), written then (EMIT).
#define COUNT 1
#define EMIT 2

layout(std430, binding = 2) readonly buffer Source { uint source[]; };
#if STAGE == EMIT
layout(std430, binding = 5) writeonly buffer Children { uint children[]; };
#endif

const int kMostCorners = 9;
dvec3 points[kMostCorners];
dvec2 weights[kMostCorners];
int corners = 0;

// Keeps where dot(normal, p) + offset >= 0; a cut is computed from its inner end to its outer one.
void clip(dvec3 normal, double offset) {
  dvec3 keptPoints[kMostCorners];
  dvec2 keptWeights[kMostCorners];
  int kept = 0;
  for (int i = 0; i < corners; ++i) {
    int j = i + 1 == corners ? 0 : i + 1;
    double di = dot(normal, points[i]) + offset;
    double dj = dot(normal, points[j]) + offset;
    if (di >= 0.0 && kept < kMostCorners) {
      keptPoints[kept] = points[i];
      keptWeights[kept] = weights[i];
      ++kept;
    }
    if ((di >= 0.0) != (dj >= 0.0) && kept < kMostCorners) {
      int inner = di >= 0.0 ? i : j;
      int outer = di >= 0.0 ? j : i;
      double t = di >= 0.0 ? di / (di - dj) : dj / (dj - di);
      keptPoints[kept] = points[inner] + (points[outer] - points[inner]) * t;
      keptWeights[kept] = weights[inner] + (weights[outer] - weights[inner]) * t;
      ++kept;
    }
  }
  corners = kept;
  for (int i = 0; i < kept; ++i) {
    points[i] = keptPoints[i];
    weights[i] = keptWeights[i];
  }
}

void clipTriangle(uint triangle) {
  uvec3 vertices = triangleVertices(triangle);
  vec3 given[3] = vec3[3](cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                          cameraFromWorld(position(vertices.z)));
  for (int i = 0; i < 3; ++i) {
    if (any(isnan(given[i])) || any(isinf(given[i]))) {
      return;
    }
    points[i] = dvec3(given[i]);
  }
  weights[0] = dvec2(0, 0);
  weights[1] = dvec2(1, 0);
  weights[2] = dvec2(0, 1);
  corners = 3;
  double margin = double(clipMargin);
  dvec2 least = (-dvec2(center) - margin) / double(focal);
  dvec2 most = (dvec2(pinholeSize) - dvec2(center) + margin) / double(focal);
  clip(dvec3(0, 0, 1), -double(zNear));
  clip(dvec3(0, 0, -1), double(zFar));
  clip(dvec3(1, 0, -least.x), 0.0);
  clip(dvec3(-1, 0, most.x), 0.0);
  clip(dvec3(0, 1, -least.y), 0.0);
  clip(dvec3(0, -1, most.y), 0.0);
}

void main() {
  uint item = gl_GlobalInvocationID.x;
  if (item < count) {
    clipTriangle(source[first + item]);
  }
  uint pieces = uint(max(corners - 2, 0));
  uvec4 own = uvec4(0u, pieces, 0u, 0u);
  uvec4 sum = sumInGroup(own);
#if STAGE == COUNT
  if (gl_LocalInvocationID.x == kGroup - 1u) {
    groups[gl_WorkGroupID.x] = sum;
  }
#else
  uint at = kPieceWords * (groups[gl_WorkGroupID.x].y + sum.y - pieces);
  for (int i = 2; i < corners; ++i) {
    children[at] = source[first + item];
    int ends[3] = int[3](0, i - 1, i);
    for (uint k = 0u; k < 3u; ++k) {
      vec2 b = vec2(weights[ends[k]]);
      children[at + 1u + 2u * k] = floatBitsToUint(b.x);
      children[at + 2u + 2u * k] = floatBitsToUint(b.y);
    }
    at += kPieceWords;
  }
#endif
}
