// The Utah teapot, from Martin Newell's 32 bicubic Bezier patches (1975).
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The teapot in its own units: 3.15 high, y up, its bottom at y = 0, the spout along +x, the axis of the body on y.
/// Each patch becomes `segments` x `segments` quads (1 or more). No colours. Not closed: the spout, and a gap under the
/// lid.
Mesh makeTeapot(int segments);

}  // namespace ocelli
