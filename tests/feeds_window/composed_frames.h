// Images of a run that never was, for windows.
#pragma once

#include "oc_core/feeds_live/feeds_run.h"
#include "tests/feeds/made_setup.h"

namespace ocelli::test {

class ComposedFrames {
 public:
  /// The image is of that tone; all feeds are live.
  ComposedFrame frame(double seconds, int tone) {
    image_ = Image<Rgb8>(graph_.setup().output.width, graph_.setup().output.height, Rgb8(static_cast<uint8_t>(tone)));
    return {seconds, image_, composer_, feedSeconds_, labels_};
  }
  const FeedGraph& graph() const { return graph_; }
  std::vector<FeedLabel>& labels() { return labels_; }

 private:
  FeedGraph graph_{tSetup()};
  FeedComposer composer_{graph_};
  Image<Rgb8> image_;
  std::vector<double> feedSeconds_{0, 0, 0};
  std::vector<FeedLabel> labels_{
      {FeedState::kLive, true, 0.033}, {FeedState::kLive, true, 0.02}, {FeedState::kLive, true, 0.01}};
};

}  // namespace ocelli::test
