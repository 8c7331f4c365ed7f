// A car and a barrel, of a few thousand triangles at most: what relief tiles carry (section 3.5.2.3.2). In metres; each
// stands on y = 0 over the origin.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// 4.6 m long, its front towards +x. Bumpers stand out from the body, behind a gap, and so do wheels and side mirrors;
/// the body is white, to be tinted.
Mesh makeCar();

/// 0.9 m high, bulging, of staves under four hoops that stand out; both heads are sunk behind the rim.
Mesh makeBarrel();

}  // namespace ocelli
