#include "oc_core/explore_window/pinhole_pane.h"

#include <cmath>

#include "oc_core/explore_window/explore_image_fit.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {
namespace {

class PinholePane : public ExplorePane {
 public:
  void ask(const ExplorePaneFrame& frame, WindowShape& shape) const override { shape.pinhole = frame.pixels(); }

  void paint(const ExplorePaneFrame& frame, GlContext& context, const GlObject& framebuffer) override {
    if (frame.picture == nullptr || !frame.picture->pinhole) {
      return;
    }
    if (frame.isFresh || !image_) {
      image_.upload(context, *frame.picture->pinhole);
    }
    frame.copy(image_, context, framebuffer);
  }

  void draw(const ExplorePaneFrame&) override {}

 private:
  ImageTexture image_;
};

}  // namespace

std::unique_ptr<ExplorePane> makePinholePane() {
  return std::make_unique<PinholePane>();
}

}  // namespace ocelli
