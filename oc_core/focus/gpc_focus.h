// The general pinhole (section 5.2.2): a focus is undistorted, a transition around it makes up for the space it takes.
#pragma once

#include "oc_core/focus/focus_map.h"

namespace ocelli {

std::unique_ptr<FocusMap> gpcFocusMap(const GpcLayout& layout, const glm::ivec2& size);

}  // namespace ocelli
