// The rows that representation_registry.cpp begins with.
#pragma once

#include <vector>

#include "oc_core/ocri/representation_kind.h"

namespace ocelli {

std::vector<RepresentationKind> builtinRepresentations();

}  // namespace ocelli
