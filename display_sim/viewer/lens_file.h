// Lenses as the JSON file of a camera, which `--camera` takes.
#pragma once

#include <string>

#include "oc_core/camera/gpc_layout.h"

namespace ocelli {

/// {"camera": "gpc", ...}. Numbers are as short as they can be to be read back as they are. Throws InputError where
/// there is no lens, as such files have one at least.
std::string lensFileText(const GpcLayout& layout);

}  // namespace ocelli
