#include "display_driver/pacing/moving_view.h"

#include "oc_core/ocri/representation_kind.h"

namespace ocelli {

MovingView::MovingView(std::unique_ptr<SceneMotion> motion, MovingImages& images, const MotionPlayback& playback,
                       size_t fewestPixels, Construction wanted)
    : motion_(std::move(motion)),
      images_(images),
      clock_(motion_->durationSeconds(), playback),
      wanted_(wanted),
      fewestPixels_(fewestPixels) {
  motion_->at(0);
  if (castsFor(fewestPixels_)) {
    followWithRays();
  }
}

EyesOptions::SceneState MovingView::moveTo(HostTime seen) {
  const std::optional<double> seconds = clock_.at(seen);
  if (!seconds) {
    return EyesOptions::SceneState::kEnded;
  }
  motion_->at(*seconds);
  const std::pair now(motion_->topology(), motion_->shape());
  if (std::exchange(shown_, now) == now) {
    return EyesOptions::SceneState::kSame;
  }
  raysAreBehind_ = true;
  return EyesOptions::SceneState::kMoved;
}

bool MovingView::castsFor(size_t pixels) const {
  const RepresentationKind& kind = *images_.choice().kind;
  return kind.castsRays ||
         (kind.rayCrossover && constructWithRays(wanted_, *kind.rayCrossover, motion_->mesh().triangles.size(),
                                                 RayStructure::kRefits, {kind.refitShare, pixels}));
}

void MovingView::followWithRays() {
  if (rays_ == nullptr || raysTopology_ != motion_->topology()) {
    rebuilds_ += rays_ != nullptr ? 1 : 0;
    rays_ = std::make_unique<RayScene>(motion_->mesh(), RayScene::Quality::kLow, RayScene::Motion::kMoves);
    raysTopology_ = motion_->topology();
  } else if (raysAreBehind_ && rays_->update() == RayScene::Update::kRebuilt) {
    ++rebuilds_;
  }
  raysAreBehind_ = false;
}

ReferenceImages MovingView::imagesFrom(const PinholeCamera& reference) {
  const bool cast = castsFor(static_cast<size_t>(reference.width()) * static_cast<size_t>(reference.height()));
  if (cast) {
    followWithRays();
  }
  ++imagesMade_;
  imagesByRays_ += cast ? 1 : 0;
  return images_.next(reference, motion_->mesh(), cast ? rays_.get() : nullptr);
}

}  // namespace ocelli
