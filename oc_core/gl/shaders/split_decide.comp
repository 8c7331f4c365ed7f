// What is to be done with each piece, or with each triangle of the scene (SOURCE TRIANGLES): split it at the edges that
// are too long (section 6.1.3), draw it as it is where none is, or drop it where it cannot be displaced or is torn. As
// oc_core/render/rasterize_subdivided.h does it.
//
// Both ways of a branch may cost time, taken or not: so clipping, which few triangles need, is done elsewhere.
#define TRIANGLES 1
#define PIECES 2

#if SOURCE == PIECES
layout(std430, binding = 2) readonly buffer Source { uint source[]; };
#endif
layout(location = 2) uniform uint depth;

const uint kDeepest = 24u;  // only guards against numbers gone wrong

struct Corner {
  vec3 p;
  vec2 undistorted;
  vec2 image;
};

Corner corner(vec3 p) {
  vec2 undistorted = imageFromCamera(p);
  return Corner(p, undistorted, distorted(undistorted, p.z));
}
float squared(vec2 v) {
  return v.x * v.x + v.y * v.y;
}
bool mustSplit(Corner a, Corner b) {
  float longest = longestEdge * longestEdge;
  bool isLong = squared(a.undistorted - b.undistorted) > longest || squared(a.image - b.image) > longest;
  return isLong && distance(a.p, b.p) > shortestEdge * min(a.p.z, b.p.z) / focal;
}
bool torn(Corner a, Corner b) {
  return squared(a.image - b.image) > tornEdge * tornEdge;
}

// Whether a triangle may cover the centre of a pixel. Most leaves cover none, and nothing is as dear as to draw them.
const float kRounding = 1.0 / 64.0;  // pixels: rasterisers snap corners, to 1/256 at least
bool leftOf(vec2 from, vec2 to, vec2 at, float side) {
  vec2 along = to - from;
  return side * (along.x * (at.y - from.y) - along.y * (at.x - from.x)) < -kRounding * length(along);
}
bool coversCentre(vec2 a, vec2 b, vec2 c) {
  vec2 first = ceil(min(a, min(b, c)) - 0.5 - kRounding);
  vec2 last = floor(max(a, max(b, c)) - 0.5 + kRounding);
  if (any(lessThan(last, first))) {
    return false;
  }
  vec2 at = first + 0.5;
  float side = sign((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  return any(greaterThan(last, first)) || !(leftOf(a, b, at, side) || leftOf(b, c, at, side) || leftOf(c, a, at, side));
}

uint decide(vec3 pa, vec3 pb, vec3 pc) {
  Corner a = corner(pa);
  Corner b = corner(pb);
  Corner c = corner(pc);
  uint split = mustSplit(a, b) ? kSplitAb : 0u;
  split |= mustSplit(b, c) ? kSplitBc : 0u;
  split |= mustSplit(c, a) ? kSplitCa : 0u;
  if (split == 0u || depth >= kDeepest) {
    bool drawn = coversCentre(a.image, b.image, c.image) && !(torn(a, b) || torn(b, c) || torn(c, a));
    return drawn ? kLeaf : kDrop;
  }
  return displacesWithin(min(a.undistorted, min(b.undistorted, c.undistorted)),
                         max(a.undistorted, max(b.undistorted, c.undistorted))) ? split : kDrop;
}

#if SOURCE == TRIANGLES
// On which sides of the frustum, widened by the longest displacement, a point lies outside.
uint outside(vec3 p) {
  float margin = clipMargin;
  vec2 q = imageFromCamera(p);
  uint sides = (p.z >= zNear ? 0u : 1u) | (p.z <= zFar ? 0u : 2u);
  if (p.z > 0.0) {
    sides |= (q.x >= -margin ? 0u : 4u) | (q.y >= -margin ? 0u : 8u) | (q.x <= pinholeSize.x + margin ? 0u : 16u) |
             (q.y <= pinholeSize.y + margin ? 0u : 32u);
  }
  return sides;
}

uint decideItem(uint item) {
  uvec3 vertices = triangleVertices(item);
  vec3 a = cameraFromWorld(position(vertices.x));
  vec3 b = cameraFromWorld(position(vertices.y));
  vec3 c = cameraFromWorld(position(vertices.z));
  uint outA = outside(a);
  uint outB = outside(b);
  uint outC = outside(c);
  if ((outA | outB | outC) != 0u) {
    return (outA & outB & outC) != 0u ? kDrop : kClip;
  }
  vec2 qa = imageFromCamera(a);
  vec2 qb = imageFromCamera(b);
  vec2 qc = imageFromCamera(c);
  return displacesWithin(min(qa, min(qb, qc)), max(qa, max(qb, qc))) ? decide(a, b, c) : kDrop;
}
#else
vec2 weightsAt(uint word) {
  return uintBitsToFloat(uvec2(source[word], source[word + 1u]));
}

uint decideItem(uint item) {
  uint at = kPieceWords * item;
  uvec3 vertices = triangleVertices(source[at]);
  vec3 corners[3] = vec3[3](cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                            cameraFromWorld(position(vertices.z)));
  return decide(pointOf(corners, weightsAt(at + 1u)), pointOf(corners, weightsAt(at + 3u)),
                pointOf(corners, weightsAt(at + 5u)));
}
#endif
