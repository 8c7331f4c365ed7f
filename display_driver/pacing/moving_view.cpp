#include "display_driver/pacing/moving_view.h"

#include "oc_core/ocri/representation_kind.h"

namespace ocelli {

MovingView::MovingView(std::unique_ptr<SceneMotion> motion, MovingImages& images, const MotionPlayback& playback,
                       Construction wanted)
    : motion_(std::move(motion)), images_(images), clock_(motion_->durationSeconds(), playback), wanted_(wanted) {
  motion_->at(0);
  followWithRays();
}

EyesOptions::SceneState MovingView::moveTo(HostTime seen) {
  const std::optional<double> seconds = clock_.at(seen);
  if (!seconds) {
    return EyesOptions::SceneState::kEnded;
  }
  const uint64_t before = motion_->topology();
  motion_->at(*seconds);
  const std::pair now(motion_->topology(), motion_->shape());
  if (std::exchange(shown_, now) == now) {
    return EyesOptions::SceneState::kSame;
  }
  if (before != now.first) {
    followWithRays();
  } else if (rays_ != nullptr && rays_->update() == RayScene::Update::kRebuilt) {
    ++rebuilds_;
  }
  return EyesOptions::SceneState::kMoved;
}

void MovingView::followWithRays() {
  rebuilds_ += rays_ != nullptr ? 1 : 0;
  rays_.reset();
  const std::optional<size_t> crossover = images_.choice().kind->rayCrossover;
  if (images_.choice().kind->castsRays ||
      (crossover && constructWithRays(wanted_, *crossover, motion_->mesh().triangles.size(), RayStructure::kRefits))) {
    rays_ = std::make_unique<RayScene>(motion_->mesh(), RayScene::Quality::kLow, RayScene::Motion::kMoves);
  }
}

ReferenceImages MovingView::imagesFrom(const PinholeCamera& reference) {
  return images_.next(reference, motion_->mesh(), rays_.get());
}

}  // namespace ocelli
