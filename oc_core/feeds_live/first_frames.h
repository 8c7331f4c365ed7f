// One frame of each feed, to look at.
#pragma once

#include <string>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct FirstFrame {
  Image<Rgb8> image;    ///< empty where the feed gives none of its size
  std::string message;  ///< why, as an error message
};

/// Of each feed of the setup; each is waited for at most so long.
std::vector<FirstFrame> firstFrames(const FeedSetup& setup, double maxWaitSeconds);

}  // namespace ocelli
