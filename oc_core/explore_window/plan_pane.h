// The scene from above: where the walker is, what the frusta cover, cells, portals and what is picked.
#pragma once

#include <memory>

#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {

inline constexpr const char* kPlanPane = "plan";  ///< the name of its row

std::unique_ptr<ExplorePane> makePlanPane();

}  // namespace ocelli
