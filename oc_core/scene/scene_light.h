// Whether a scene has any light to show.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Whether all of its colours are so dark that an image of 8 bits a channel shows black.
bool isBlack(const Mesh& mesh);

}  // namespace ocelli
