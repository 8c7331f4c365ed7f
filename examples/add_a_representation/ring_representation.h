// Depth images from a ring of eyes all round the scene, each without what those before it hold: "ring-6", or any number
// from ring-1 to ring-16. The first is that of the reference view.
#pragma once

#include "oc_core/ocri/representation_kind.h"

ocelli::RepresentationKind ringRepresentation();
