// What is to be done with a piece: bits for the edges to be split, or one of these.
const uint kSplitAb = 1u;
const uint kSplitBc = 2u;
const uint kSplitCa = 4u;
const uint kDrop = 0u;
const uint kLeaf = 8u;
const uint kClip = 16u;

uint countsOf(uint code) {
  return code == kDrop ? 0u
       : code == kLeaf ? packCounts(1u, 0u, 0u)
       : code == kClip ? packCounts(0u, 0u, 1u)
                       : packCounts(0u, uint(bitCount(code)) + 1u, 0u);
}

// What is kept of a piece from deciding to writing: its code, and the counts of those before it in its group.
uint withPlace(uint code, uint before) {
  return code | before << 5;
}
uint codeOf(uint kept) {
  return kept & 31u;
}
uint beforeOf(uint kept) {
  return kept >> 5;
}

// The triangle of the scene that an item stands for, where items are triangles: with BLOCKS, those of listed blocks.
#ifdef BLOCKS
const uint kBlockTriangles = 32u;  // oc_core/render/mesh_blocks.h
layout(std430, binding = 2) readonly buffer Blocks { uint blocks[]; };

uint sourceTriangle(uint item) {
  return blocks[item / kBlockTriangles] * kBlockTriangles + item % kBlockTriangles;
}
#else
uint sourceTriangle(uint item) {
  return item;
}
#endif
