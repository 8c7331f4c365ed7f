#include "study/screen/latency_flash.h"

#include <array>
#include <utility>

#include "oc_core/base/steady_time.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/window/gamepads.h"
#include "oc_core/window/gl_window.h"
#include "oc_core/window/screen_target.h"
#include "study/screen/study_look.h"

namespace ocelli {
namespace {

/// The keys of the window, as a device that is looked at.
class WindowKeys : public ResponseDevice {
 public:
  explicit WindowKeys(GlWindow& window) : window_(window) {}

  bool mustBePolled() const override { return true; }
  void poll() override {
    for (const TimedWindowEvent& timed : window_.pollTimed(0)) {
      const auto* const input = std::get_if<InputEvent>(&timed.event);
      const auto* const key = input != nullptr ? std::get_if<KeyEvent>(input) : nullptr;
      if (key != nullptr) {
        counts_.presses += key->pressed ? 1 : 0;
        changes_.push_back({key->key, key->pressed, timed.nanoseconds, key->modifiers});
      }
    }
  }
  std::vector<KeyChange> take() override { return std::exchange(changes_, {}); }
  bool isConnected() const override { return true; }
  ResponseCounts counts() const override { return counts_; }
  std::string description() const override { return "keyboard of the window"; }

 private:
  GlWindow& window_;
  std::vector<KeyChange> changes_{};
  ResponseCounts counts_{};
};

/// Asks the window for its events too, so that the system does not take it for dead.
class BesideWindow : public ResponseDevice {
 public:
  BesideWindow(GlWindow& window, std::unique_ptr<ResponseDevice> device)
      : window_(window), device_(std::move(device)) {}

  bool mustBePolled() const override { return true; }
  void poll() override {
    window_.pollTimed(0);
    device_->poll();
  }
  std::vector<KeyChange> take() override { return device_->take(); }
  bool isConnected() const override { return device_->isConnected(); }
  ResponseCounts counts() const override { return device_->counts(); }
  std::string description() const override { return device_->description(); }

 private:
  GlWindow& window_;
  std::unique_ptr<ResponseDevice> device_;
};

class FlashScreen {
 public:
  explicit FlashScreen(GlWindow& window)
      : window_(window),
        scope_(window.context()),
        target_(window.context(), window.pixelWidth(), window.pixelHeight()) {
    show(false);
  }

  /// When the frame with the flash was handed to the screen, and the one before had been replaced.
  int64_t show(bool white) {
    target_.clear({0, 0, 0});
    if (white) {
      const GladGLContext& gl = window_.context().gl();
      constexpr std::array kWhite{1.0F, 1.0F, 1.0F, 1.0F};
      gl.Enable(GL_SCISSOR_TEST);
      // Row 0 of the target is the top of the screen.
      gl.Scissor(0, 0, target_.width() / 2, target_.height() / 2);
      gl.ClearNamedFramebufferfv(target_.framebuffer().id(), GL_COLOR, 0, kWhite.data());
      gl.Disable(GL_SCISSOR_TEST);
    }
    window_.present(target_.framebuffer(), target_.width(), target_.height());
    window_.awaitFrame();
    return steadyNanoseconds();
  }

 private:
  GlWindow& window_;
  GlScope scope_;
  ScreenTarget target_;
};

}  // namespace

LatencyReport measureFlashLatency(const std::string& responses, int monitor, const LatencyOptions& options,
                                  LatencyText& text) {
  GlWindowOptions windowOptions;
  windowOptions.title = "Ocelli: latency";
  windowOptions.resizable = false;
  windowOptions.scaled = false;
  windowOptions.monitor = monitor;
  GlWindow window(windowOptions);
  std::unique_ptr<ResponseDevice> device;
  if (responses.empty()) {
    device = std::make_unique<WindowKeys>(window);
  } else {
    device = std::make_unique<BesideWindow>(window, openResponseDevice(responses, {readFirstGamepad}));
  }
  FlashScreen screen(window);
  text = {device->description(),
          "flashes of the upper left quarter of the screen, from the time when their frame replaced the one before",
          {"the time from then to light: the rows of the screen above, and the panel's response", "the photodiode"},
          {"how much of the latency is the screen's: measure the light against the frame with an oscilloscope",
           "what a finger adds: the travel of the contact",
           "when a keyboard or gamepad told: it is looked at every 2 ms here, and USB asks it every 1 to 8 ms"}};
  return measureLatency(
      *device, [&] { return std::optional(screen.show(true)); }, [&] { screen.show(false); }, options);
}

}  // namespace ocelli
