// Runs the viewer: in a window, or by a script without a display.
#pragma once

#include <functional>

#include "display_sim/viewer/viewer.h"
#include "display_sim/viewer/viewer_script.h"

namespace ocelli {

/// Until it is closed. Throws GlError where no window can be opened, and as Viewer does.
void runViewerWindow(const ViewerOptions& options);

/// Images go to `options.folder`; `saved` is told of each, and may be empty. Figures that differ from run to run are
/// not shown. Throws as ScriptPlayer does.
void runViewerScript(GlContext& context, ViewerOptions options, const ViewerScript& script,
                     const std::function<void(const std::string& file)>& saved = {});

}  // namespace ocelli
