// runFeedsWindow(): the window on a screen.
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "oc_core/feeds_window/feeds_window.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

constexpr double kFeedsRest = 0.1;  ///< how long the window waits for something to happen

/// Runs the feeds on a thread of its own, and ends it.
class FeedsThread {
 public:
  FeedsThread(FeedsScreen& screen, const std::function<void(FeedsScreen&)>& run)
      : screen_(screen), thread_([this, &run] {
          try {
            run(screen_);
          } catch (...) {
            error_ = std::current_exception();
            hasFailed_ = true;
          }
          screen_.end();
        }) {}
  ~FeedsThread() { join(); }
  FeedsThread(const FeedsThread&) = delete;
  FeedsThread& operator=(const FeedsThread&) = delete;

  bool hasFailed() const { return hasFailed_; }
  /// Closes the screen, waits for the end, and throws what the run threw.
  void finish() {
    join();
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  void join() {
    screen_.close();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  FeedsScreen& screen_;
  std::exception_ptr error_;
  std::atomic<bool> hasFailed_{false};
  std::thread thread_;
};

}  // namespace

void runFeedsWindow(const FeedGraph& graph, const FeedsWindowOptions& options,
                    const std::function<void(FeedsScreen& screen)>& run) {
  GlWindow window({.title = options.title, .width = 1280, .height = 960});
  FeedsScreen screen(options.isLive, [] { GlWindow::wake(); });
  FeedsWindow shown(window.context(), graph, screen, options.folder);
  shown.state().hasLabels = options.hasLabels;
  shown.state().hasRedErased = options.hasRedErased;
  screen.setErased(options.hasRedErased ? ErasedLook::kRed : ErasedLook::kBackground);
  FeedsThread thread(screen, run);
  auto last = std::chrono::steady_clock::now();
  while (!shown.wantsClose() && !thread.hasFailed() && (!options.goesOn || options.goesOn())) {
    for (const InputEvent& event : window.poll(kFeedsRest)) {
      shown.handle(event);
    }
    const auto now = std::chrono::steady_clock::now();
    shown.update(std::chrono::duration<double>(now - last).count());
    last = now;
    if (shown.takeFullscreenWish()) {
      window.setFullscreen(!window.isFullscreen());
    }
    if (shown.needsDrawing()) {
      shown.draw();
      const GlScope scope(window.context());
      window.show(shown.framebuffer(), shown.pixelWidth(), shown.pixelHeight());
    }
  }
  thread.finish();
}

}  // namespace ocelli
