// What is to be done with each piece of a triangle in a bend, or with each triangle of the scene (SOURCE TRIANGLES): as
// oc_core/render/bend_rasterizer.h does it.
#define TRIANGLES 1
#define PIECES 2

#if SOURCE == PIECES
layout(std430, binding = 2) readonly buffer Source { uint source[]; };
#endif
layout(location = 2) uniform uint depth;

const uint kDeepest = 24u;  // only guards against numbers gone wrong
const float kMaxBendPixels = 16.0;
const float kErrorPixels = 1.0 / 16.0;

bool mustSplit(BendPoint a, BendPoint b) {
  if (!a.imaged || !b.imaged) {
    return distance(a.p, b.p) > shortestEdge;
  }
  float share = abs(a.share - b.share);
  float long_ = distance(a.image, b.image);
  float bend = bendFactor * (share * (long_ + bendWidth * share) + long_ * long_ / (16.0 * bendWidth));
  BendPoint middle = bendPoint((a.p + b.p) * 0.5);
  vec2 straight_ = (a.image * a.weight + b.image * b.weight) / (a.weight + b.weight);
  return bend > kErrorPixels &&
         (bend > kMaxBendPixels || !middle.imaged || distance(middle.image, straight_) > kErrorPixels);
}

// In the world: all corners beyond one of the planes around the bend.
bool missesBend(vec3 a, vec3 b, vec3 c) {
  bool outside = max(dot(from.xyz, a), max(dot(from.xyz, b), dot(from.xyz, c))) + from.w < 0.0 ||
                 min(dot(to.xyz, a), min(dot(to.xyz, b), dot(to.xyz, c))) + to.w > 0.0;
  for (int i = 0; i < sideCount; ++i) {
    vec3 side = sides[i].xyz;
    outside = outside || max(dot(side, a), max(dot(side, b), dot(side, c))) + sides[i].w < 0.0;
  }
  return outside;
}

// An edge bulges by less than half of its length.
bool missesImage(vec2 a, vec2 b, vec2 c) {
  vec2 lower = min(a, min(b, c));
  vec2 upper = max(a, max(b, c));
  float room = 1.0 + ((upper.x - lower.x) + (upper.y - lower.y)) / 2.0;
  return any(lessThan(upper + room, vec2(0))) || any(greaterThan(lower - room, pinholeSize));
}

uint decide(vec3 pa, vec3 pb, vec3 pc) {
  if (missesBend(pa, pb, pc)) {
    return kDrop;
  }
  BendPoint a = bendPoint(pa);
  BendPoint b = bendPoint(pb);
  BendPoint c = bendPoint(pc);
  bool imaged = a.imaged && b.imaged && c.imaged;
  if (imaged && missesImage(a.image, b.image, c.image)) {
    return kDrop;
  }
  uint split = mustSplit(a, b) ? kSplitAb : 0u;
  split |= mustSplit(b, c) ? kSplitBc : 0u;
  split |= mustSplit(c, a) ? kSplitCa : 0u;
  return split != 0u && depth < kDeepest ? split : imaged ? kLeaf : kDrop;
}

#if SOURCE == TRIANGLES
uint decideItem(uint item) {
  uint triangle = sourceTriangle(item);
  if (3u * triangle >= uint(triangles.length())) {
    return kDrop;  // the last block is shorter
  }
  uvec3 vertices = triangleVertices(triangle);
  vec3 a = position(vertices.x) - before.xyz;
  vec3 b = position(vertices.y) - before.xyz;
  vec3 c = position(vertices.z) - before.xyz;
  vec3 sum = abs(a) + abs(b) + abs(c);
  bool finite = !any(isnan(sum)) && !any(isinf(sum));
  return finite ? decide(a, b, c) : kDrop;
}
#else
vec2 weightsAt(uint word) {
  return uintBitsToFloat(uvec2(source[word], source[word + 1u]));
}

uint decideItem(uint item) {
  uint at = kPieceWords * item;
  uvec3 vertices = triangleVertices(source[at]);
  vec3 corners[3] = vec3[3](position(vertices.x) - before.xyz, position(vertices.y) - before.xyz,
                            position(vertices.z) - before.xyz);
  return decide(pointOf(corners, weightsAt(at + 1u)), pointOf(corners, weightsAt(at + 3u)),
                pointOf(corners, weightsAt(at + 5u)));
}
#endif
