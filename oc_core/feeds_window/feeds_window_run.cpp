// runFeedsWindow(): the window on a screen.
#include <atomic>
#include <exception>
#include <thread>

#include "oc_core/feeds_window/feeds_window.h"
#include "oc_core/window/gui_window_run.h"

namespace ocelli {
namespace {

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
  runGuiWindow(window, shown, [&] { return !thread.hasFailed() && (!options.goesOn || options.goesOn()); });
  thread.finish();
}

}  // namespace ocelli
