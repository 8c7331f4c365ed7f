// What a pinhole sees from the same place, to compare with.
#pragma once

#include <memory>

#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {

inline constexpr const char* kPinholePane = "pinhole";  ///< the name of its row

std::unique_ptr<ExplorePane> makePinholePane();

}  // namespace ocelli
