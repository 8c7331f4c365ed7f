// A magnifier laid over each focus: an inset with a zoomed picture, which covers what lies around the focus.
#pragma once

#include "oc_core/focus/focus_map.h"

namespace ocelli {

std::unique_ptr<FocusMap> insetFocusMap(const GpcLayout& layout, const glm::ivec2& size);

}  // namespace ocelli
