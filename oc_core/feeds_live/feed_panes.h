// What surveillance shows of the same feeds: a grid of panes, one for each frustum in its order, each with its label.
#pragma once

#include "oc_core/feeds_live/feed_composer.h"
#include "oc_core/feeds_live/feed_labels.h"

namespace ocelli {

/// Where a feed is in the grid, in pixels.
struct FeedPane {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;

  bool operator==(const FeedPane&) const = default;
};

/// In as many columns as make panes largest; each feed keeps its shape in the middle of its cell.
std::vector<FeedPane> feedPanes(const FeedSetup& setup, int width, int height);

/// Sets `image`, of the size of the setup's output, to the last frames of a composer; each pixel is the mean of those
/// that it covers. Panes of feeds without a frame are grey. `labels` has one entry a frustum, or none.
void drawFeedPanes(const FeedComposer& composer, const std::vector<FeedLabel>& labels, Image<Rgb8>& image);

}  // namespace ocelli
