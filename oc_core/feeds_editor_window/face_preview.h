// The composed image of one frame of each feed, as the faces are drawn now. For the .cpp files of this room.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/feeds/feed_map.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class FacePreview {
 public:
  /// `frames` has an image for each feed; empty ones are hatched.
  explicit FacePreview(std::vector<Image<Rgb8>> frames) : frames_(std::move(frames)) {}

  /// Composes anew where the graph is another one than the last time. Returns whether it was. `graph` may be null.
  bool update(const std::shared_ptr<const FeedGraph>& graph);
  /// Empty before the first graph.
  const Image<Rgb8>& image() const { return image_; }
  /// Of the size of the image; null before the first one.
  const FeedGraph* graph() const { return small_.get(); }

 private:
  std::vector<Image<Rgb8>> frames_;
  std::shared_ptr<const FeedGraph> seen_;
  std::unique_ptr<FeedGraph> small_;
  Image<Rgb8> image_;
};

}  // namespace ocelli
