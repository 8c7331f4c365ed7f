// Forms: questions of all kinds, a card each.
#pragma once

#include <optional>

#include "study/screen/page_drawing.h"
#include "study/session/session_flow.h"

namespace ocelli {

/// What the mouse did, if anything. `scroll` follows the field that the keys act on.
std::optional<FormAction> drawForm(StudyCanvas& canvas, const FormScreen& screen, PageScroll& scroll);

}  // namespace ocelli
