#include "oc_core/feeds_editor_window/face_preview.h"

#include <algorithm>

#include "oc_core/feeds/feed_compose.h"

namespace ocelli {
namespace {

constexpr int kPreviewWidth = 480;  ///< pixels, at most: it follows each drag

}  // namespace

bool FacePreview::update(const std::shared_ptr<const FeedGraph>& graph) {
  if (graph == nullptr || graph == seen_) {
    return false;
  }
  seen_ = graph;
  FeedSetup setup = graph->setup();
  const int width = std::min(kPreviewWidth, setup.output.width);
  setup.output.height = std::max(16, setup.output.height * width / setup.output.width);
  setup.output.width = width;
  small_ = std::make_unique<FeedGraph>(setup);
  std::vector<FeedPicture> pictures(small_->frusta());
  for (size_t i = 0; i < pictures.size(); ++i) {
    const Image<Rgb8>& frame = frames_[small_->feedIndexOf(i)];
    pictures[i].frame = frame.empty() ? nullptr : &frame;
  }
  composeFeeds(FeedMap(*small_), pictures, ErasedLook::kBackground, image_);
  return true;
}

}  // namespace ocelli
