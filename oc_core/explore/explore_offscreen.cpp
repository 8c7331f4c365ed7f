#include "oc_core/explore/explore_offscreen.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/explore/explore_shown_camera.h"

namespace ocelli {
namespace {

double milliseconds() {
  return static_cast<double>(steadyNanoseconds()) / 1e6;
}

class OffscreenSession final : public ExploreSession {
 public:
  OffscreenSession(ExploreScene& scene, ExploreOffscreenOptions options)
      : ExploreSession({options.folder, options.wrote}),
        options_(std::move(options)),
        explorer_(scene, options_.explorer),
        renderer_(scene),
        jumps_(scene) {
    if (options_.start) {
      explorer_.jumpTo(*options_.start);
      showFrame({});
    }
    if (!options_.camera.empty()) {
      exploreFrom(explorer_, options_.camera);
      showFrame({});
    }
  }

  Explorer& explorer() override { return explorer_; }

  void showFrame(const WalkInput& input) override {
    const ExploreFrame before = explorer_.frame();
    const double begin = milliseconds();
    const std::clock_t processorBegin = std::clock();
    explorer_.advance(input, 1 / kExploreFramesPerSecond);
    const double stepped = milliseconds();
    // A frame that dissolves needs the picture of the one before.
    const ExploreFrame& now = explorer_.frame();
    if (now.dissolve > 0 && now.dissolveFrom == before.number && drawn_ != before.number) {
      renderer_.draw(before);
    }
    ++report_.frames;
    if (options_.measureTimes || options_.measureJumps || recording_ || now.dissolve > 0) {
      const double beforeDrawing = milliseconds();
      drawNow();
      report_.times.step.push_back(stepped - begin);
      report_.times.draw.push_back(milliseconds() - beforeDrawing);
      processorSeconds_ += static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC;
      if (recording_) {
        recording_->add(picture_);
      }
      if (options_.measureJumps) {
        measureJump(before);
      }
    }
  }

  Image<Rgb8> picture() override {
    if (drawn_ != explorer_.frame().number || picture_.empty()) {
      drawNow();
    }
    return picture_;
  }

  void startRecording(const std::filesystem::path& path) override {
    if (!options_.record) {
      throw InputError("videos are not recorded here", path.string(), "leave the step out");
    }
    if (recording_) {
      throw InputError("a video is being recorded already", path.string(),
                       "stop that one before: {\"stop_recording\": true}");
    }
    recording_ = options_.record(path, explorer_.frame().pinhole.width(), explorer_.frame().pinhole.height());
    recordingPath_ = path;
  }
  void stopRecording() override {
    if (!recording_) {
      throw InputError("no video is being recorded", "", "begin one before: {\"record\": \"walk.mp4\"}");
    }
    recording_->finish();
    recording_.reset();
    wrote(recordingPath_);
  }

  ExploreReport finish() {
    if (recording_) {
      stopRecording();
    }
    report_.times.processorMeanMs =
        1000 * processorSeconds_ / std::max(1.0, static_cast<double>(report_.times.draw.size()));
    report_.changes = jumps_.changes();
    report_.worst = jumps_.worst();
    return std::move(report_);
  }

 private:
  void drawNow() {
    picture_ = renderer_.draw(explorer_.frame()).image;
    drawn_ = explorer_.frame().number;
  }

  /// Where the walker jumps somewhere else, every picture jumps.
  void measureJump(const ExploreFrame& before) {
    const ExploreFrame& now = explorer_.frame();
    const WalkerOptions& walker = explorer_.walker().options();
    const double farthest = walker.speed * walker.fastFactor * explorer_.scene().metre() / kExploreFramesPerSecond;
    if (glm::distance(before.walker.eye, now.walker.eye) > kJumpFactor * farthest) {
      jumps_.cut();
    }
    jumps_.add(now, picture_, walker.fovHorizontal, walker.turnDegrees / kExploreFramesPerSecond);
  }

  static constexpr double kJumpFactor = 20;  // of the fastest step: glides are faster than steps

  ExploreOffscreenOptions options_;
  Explorer explorer_;
  ExploreRenderer renderer_;
  JumpMeasure jumps_;
  std::optional<ExploreRecording> recording_;
  std::filesystem::path recordingPath_;
  Image<Rgb8> picture_;
  int drawn_ = -1;
  ExploreReport report_;
  double processorSeconds_ = 0;
};

}  // namespace

double ExploreTimes::mean() const {
  const double sum = std::accumulate(step.begin(), step.end(), 0.0) + std::accumulate(draw.begin(), draw.end(), 0.0);
  return step.empty() ? 0 : sum / static_cast<double>(step.size());
}

double ExploreTimes::percentile(double share) const {
  std::vector<double> sums(step.size());
  for (size_t i = 0; i < sums.size(); ++i) {
    sums[i] = step[i] + draw[i];
  }
  if (sums.empty()) {
    return 0;
  }
  const auto at = static_cast<size_t>(
      std::clamp(std::ceil(share * static_cast<double>(sums.size())) - 1, 0.0, static_cast<double>(sums.size() - 1)));
  std::nth_element(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(at), sums.end());
  return sums[at];
}

int ExploreReport::jumps() const {
  return static_cast<int>(
      std::count_if(changes.begin(), changes.end(), [](const FrameChange& change) { return change.jumps(); }));
}

ExploreReport exploreOffscreen(ExploreScene& scene, const ExploreScript& script, ExploreOffscreenOptions options) {
  options.explorer.width = script.width;
  options.explorer.height = script.height;
  options.explorer.waitForWays = true;
  OffscreenSession session(scene, std::move(options));
  play(script, session);
  return session.finish();
}

}  // namespace ocelli
