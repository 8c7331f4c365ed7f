// The view: the image of the camera that is chosen, with borders around what bends.
#pragma once

#include <memory>

#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {

std::unique_ptr<ExplorePane> makeViewPane();

}  // namespace ocelli
