// A GuiWindow on a screen.
#pragma once

#include <functional>

#include "oc_core/window/gl_window.h"
#include "oc_core/window/gui_window.h"

namespace ocelli {

/// Until the user closes it, or `goesOn`, which is asked again and again where it is given, says no. `shown` draws with
/// the context of `window`. It draws when something has changed; while that goes on, 60 times a second.
/// GlWindow::wake() tells it that something has changed. Throws GlError, and what `shown` throws.
void runGuiWindow(GlWindow& window, GuiWindow& shown, const std::function<bool()>& goesOn = {});

}  // namespace ocelli
