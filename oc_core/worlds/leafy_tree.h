// A tree whose leaves are triangles of their own, for `builtin:tree`.
#pragma once

#include <cstddef>
#include <cstdint>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The fewest triangles of makeLeafyTree(): those of its trunk and branches, and of a leaf.
size_t minTreeTriangles();

/// About 2 high, on y = 0 around the y axis, of exactly `triangles`, minTreeTriangles() or more. Leaves have two
/// triangles each, the last one may have one; however many there are, they have about the same area together.
Mesh makeLeafyTree(size_t triangles, uint64_t seed);

}  // namespace ocelli
