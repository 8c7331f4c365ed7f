// What is to be done with a piece: bits for the edges to be split, or one of these.
const uint kSplitAb = 1u;
const uint kSplitBc = 2u;
const uint kSplitCa = 4u;
const uint kDrop = 0u;
const uint kLeaf = 8u;
const uint kClip = 16u;

uvec4 countsOf(uint code) {
  return code == kDrop ? uvec4(0u)
       : code == kLeaf ? uvec4(1u, 0u, 0u, 0u)
       : code == kClip ? uvec4(0u, 0u, 1u, 0u)
                       : uvec4(0u, uint(bitCount(code)) + 1u, 0u, 0u);
}
