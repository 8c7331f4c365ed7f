// The time of each feed, in the picture.
#pragma once

#include <string>
#include <vector>

#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds_live/feed_stream.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct FeedLabel {
  FeedState state = FeedState::kLive;
  bool hasFrame = false;
  double ageSeconds = 0;    ///< of the frame that is shown
  std::string remark = {};  ///< what is wrong with the feed besides: "MOVED 14 px"

  /// Frames come in, and nothing is wrong.
  bool isGood() const { return state == FeedState::kLive && hasFrame && remark.empty(); }
};

/// Names are cut after 20 letters: "left 33 ms", "left LATE 2.4 s", "left LOST no picture", "left MOVED 14 px 33 ms".
std::string feedLabelText(const std::string& name, const FeedLabel& label);

/// Where a label is in the image, in pixels.
struct FeedLabelBox {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

/// Of each frustum: at the upper left of its part, or lines below it where another label is. They stay within the
/// image as long as they fit into it.
std::vector<FeedLabelBox> feedLabelBoxes(const FeedGraph& graph, const std::vector<FeedLabel>& labels);

/// Draws the label of each frustum into its part of the image.
void drawFeedLabels(const FeedGraph& graph, const std::vector<FeedLabel>& labels, Image<Rgb8>& image);

}  // namespace ocelli
