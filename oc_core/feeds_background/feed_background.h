// What a feed sees without subjects, and so which of its pixels are subjects (section 4.3.3: "background subtraction").
//
// A mixture of Gaussians for each pixel (Zivkovic 2004, OpenCV's MOG2), at half the resolution. Cameras change their
// exposure as a whole, which is no subject: the median ratio between a frame and the background, per channel, is taken
// out of the frame before it is compared, and put into the background before it is shown.
#pragma once

#include <memory>

#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct FeedBackgroundOptions {
  double learnSeconds = 120;  ///< what stands still for about so long becomes background
  double framesPerSecond = 30;
  /// Blobs of fewer feed pixels are noise.
  double minBlobPixels = 150;
};

class FeedBackground {
 public:
  /// `known` is what the feed sees without subjects; an empty image stands for what it learns from its frames.
  FeedBackground(int width, int height, const Image<Rgb8>& known, const FeedBackgroundOptions& options = {});
  ~FeedBackground();
  FeedBackground(const FeedBackground&) = delete;
  FeedBackground& operator=(const FeedBackground&) = delete;

  /// Finds the subjects of the next frame; none where the feed is covered.
  FeedBlobs update(const Image<Rgb8>& frame);
  /// The background in a light that stays the same; of the size of the feed. Empty before the first frame of a feed
  /// whose background is not known.
  const Image<Rgb8>& image() const;
  /// Whether hardly anything of the background is seen, for some frames: the camera is covered, was turned away, or it
  /// is dark.
  bool isCovered() const;
  /// How much of that light the last frame has that was not covered, per channel.
  glm::dvec3 light() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
