#include "display_sim/viewer/viewer_run.h"

#include <chrono>

#include "display_sim/viewer/script_player.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

/// Where nothing moves, a window looks whether something is made at least so often.
constexpr double kRestSeconds = 0.5;
/// ... and so often where pictures of an effect, or of lenses, may come, which are drawn by the same cores as the
/// window.
constexpr double kEffectRestSeconds = 0.02;

double restOf(const Viewer& viewer) {
  return viewer.isMoving() ? 0 : viewer.isDrawing() ? kEffectRestSeconds : kRestSeconds;
}

}  // namespace

void runViewerWindow(const ViewerOptions& options) {
  using Clock = std::chrono::steady_clock;
  GlWindow window({.title = "Ocelli: " + options.source});
  Viewer viewer(window.context(), options);
  auto last = Clock::now();
  while (!viewer.wantsClose()) {
    for (const InputEvent& event : window.poll(restOf(viewer))) {
      viewer.handle(event);
    }
    const auto now = Clock::now();
    viewer.update(std::chrono::duration<double>(now - last).count());
    last = now;
    viewer.draw();
    const GlScope scope(window.context());
    window.show(viewer.image().framebuffer(), viewer.image().width(), viewer.image().height());
  }
}

void runViewerScript(GlContext& context, ViewerOptions options, const ViewerScript& script,
                     const std::function<void(const std::string& file)>& saved) {
  options.showTimes = false;
  Viewer viewer(context, options);
  ScriptPlayer(viewer, options.folder, saved).play(script);
}

}  // namespace ocelli
