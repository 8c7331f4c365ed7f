#include "oc_core/explore_window/explore_window_session.h"

#include <ctime>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/explore_window/explore_window.h"

namespace ocelli {
namespace {

constexpr double kSessionFrame = 1 / kExploreFramesPerSecond;
/// Frames that panels need to show what has just opened.
constexpr int kMaxSettling = 20;

double millisecondsNow() {
  return static_cast<double>(steadyNanoseconds()) / 1e6;
}

class WindowSession final : public ExploreSession {
 public:
  WindowSession(GlContext& context, const ExploreScript& script, ExploreWindowSessionOptions options)
      : ExploreSession({options.folder, options.wrote}),
        options_(std::move(options)),
        recorder_(options_.record),
        window_(context, {.make = makeKept(options_.model),
                          .way = ExploreWindowWork::Way::kStepwise,
                          .folder = options_.folder,
                          .showTimes = false}) {
    window_.handle(ResizeEvent{script.width, script.height, 1, options_.contentScale});
    showFrame({});
  }

  Explorer& explorer() override {
    OC_CHECK(model_ != nullptr, "the first frame has made it");
    return model_->explorer();
  }

  void showFrame(const WalkInput& input) override {
    WindowMotion motion = windowMotionOf(input);
    window_.hold(motion);
    const double begin = millisecondsNow();
    window_.update(kSessionFrame);
    const double updated = millisecondsNow();
    const std::clock_t cpu = std::clock();
    window_.draw();
    cpuSeconds_ += static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    times_.walk.push_back(updated - begin);
    times_.window.push_back(millisecondsNow() - updated);
    window_.hold({});
    if (recorder_.isOn()) {
      recorder_.add(window_.screenshot(), kSessionFrame);
    }
    if (window_.takeRecordWish()) {
      throw InputError("V records nothing here", "", "use the steps record and stop_recording");
    }
  }

  void give(const InputEvent& event) override { window_.handle(event); }

  Image<Rgb8> picture() override {
    for (int i = 0; i < kMaxSettling && (i == 0 || window_.needsDrawing()); ++i) {
      window_.update(0);
      window_.draw();
    }
    return window_.screenshot();
  }

  void startRecording(const std::filesystem::path& path) override {
    recorder_.start(path, window_.target().width(), window_.target().height());
    window_.state().recording = true;
  }
  void stopRecording() override {
    recorder_.stop();
    window_.state().recording = false;
    wrote(recorder_.path());
  }

  ExploreWindowTimes finish() {
    if (recorder_.isOn()) {
      stopRecording();
    }
    times_.windowCpu = 1000 * cpuSeconds_ / static_cast<double>(times_.window.size());
    return std::move(times_);
  }

 private:
  ExploreWindowWork::Make makeKept(const ExplorerWindowOptions& options) {
    return [this, options](const Progress& progress) {
      auto model = std::make_unique<ExplorerWindowModel>(options, progress);
      model_ = model.get();
      return model;
    };
  }

  ExploreWindowSessionOptions options_;
  ExploreRecorder recorder_;
  ExplorerWindowModel* model_ = nullptr;  ///< of the window
  ExploreWindow window_;
  ExploreWindowTimes times_;
  double cpuSeconds_ = 0;
};

}  // namespace

ExploreWindowTimes playInExploreWindow(GlContext& context, const ExploreScript& script,
                                       ExploreWindowSessionOptions options) {
  options.model.explorer.waitForWays = true;  // the same script gives the same pictures
  WindowSession session(context, script, std::move(options));
  play(script, session);
  return session.finish();
}

}  // namespace ocelli
