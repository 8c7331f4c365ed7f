// Writes what split_decide.comp has decided: leaves, children, and the triangles that are to be clipped.
#define TRIANGLES 1
#define PIECES 2

#if SOURCE == PIECES
layout(std430, binding = 2) readonly buffer Source { uint source[]; };
#endif
layout(std430, binding = 4) writeonly buffer Leaves { uint leaves[]; };
layout(std430, binding = 5) writeonly buffer Children { uint children[]; };
layout(std430, binding = 6) readonly buffer Codes { uint codes[]; };
layout(std430, binding = 7) writeonly buffer Clips { uint clips[]; };
layout(location = 2) uniform uint firstLeaf;  // where leaves go

uint triangle;
uint place;

#define WRITE(list, at, p, q, r)           \
  {                                        \
    uint w = kPieceWords * (at);           \
    list[w] = triangle;                    \
    list[w + 1u] = floatBitsToUint(p.x);   \
    list[w + 2u] = floatBitsToUint(p.y);   \
    list[w + 3u] = floatBitsToUint(q.x);   \
    list[w + 4u] = floatBitsToUint(q.y);   \
    list[w + 5u] = floatBitsToUint(r.x);   \
    list[w + 6u] = floatBitsToUint(r.y);   \
  }

void main() {
  uint item = gl_GlobalInvocationID.x;
  uint kept = item < count ? codes[item] : kDrop;
  uint code = codeOf(kept);
  if (code == kDrop) {
    return;
  }
  uvec4 places = groups[gl_WorkGroupID.x] + unpackCounts(beforeOf(kept));
#if SOURCE == TRIANGLES
  triangle = sourceTriangle(first + item);
  vec2 a = vec2(0, 0);
  vec2 b = vec2(1, 0);
  vec2 c = vec2(0, 1);
#else
  uint at = kPieceWords * (first + item);
  triangle = source[at];
  vec2 a = uintBitsToFloat(uvec2(source[at + 1u], source[at + 2u]));
  vec2 b = uintBitsToFloat(uvec2(source[at + 3u], source[at + 4u]));
  vec2 c = uintBitsToFloat(uvec2(source[at + 5u], source[at + 6u]));
#endif
  if (code == kClip) {
    clips[places.z] = triangle;
    return;
  }
  if (code == kLeaf) {
    WRITE(leaves, firstLeaf + places.x, a, b, c)
    return;
  }
  // Turned so that one split is at ab, and two are at ab and bc.
  uint splits = uint(bitCount(code));
  if (code == kSplitBc || code == (kSplitBc | kSplitCa)) {
    vec2 bend = a;
    a = b;
    b = c;
    c = bend;
  } else if (code == kSplitCa || code == (kSplitCa | kSplitAb)) {
    vec2 bend = c;
    c = b;
    b = a;
    a = bend;
  }
  vec2 ab = (a + b) * 0.5;
  vec2 bc = (b + c) * 0.5;
  vec2 ca = (c + a) * 0.5;
  place = places.y;
  // Splits: 1 gives (a, ab, c) (ab, b, c), 2 gives (a, ab, bc) (ab, b, bc) (a, bc, c), 3 gives (a, ab, ca) (ab, b, bc)
  // (ca, bc, c) (ab, bc, ca).
  vec2 acrossA = splits == 1u ? c : splits == 2u ? bc : ca;
  vec2 acrossB = splits == 1u ? c : bc;
  WRITE(children, place, a, ab, acrossA)
  WRITE(children, place + 1u, ab, b, acrossB)
  if (splits >= 2u) {
    vec2 fromA = splits == 2u ? a : ca;
    WRITE(children, place + 2u, fromA, bc, c)
  }
  if (splits == 3u) {
    WRITE(children, place + 3u, ab, bc, ca)
  }
}
