// A camera drawn by hand (section 4.3.2.1): two plans of the scene in which frusta are added, aimed, bent, split,
// merged and limited, while the view shows the image.
#pragma once

#include <memory>

#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {

inline constexpr const char* kDrawPane = "draw";  ///< the name of its row

std::unique_ptr<ExplorePane> makeDrawPane();

}  // namespace ocelli
