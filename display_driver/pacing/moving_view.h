// What a moving scene looks like from an eye that may move, too: the mesh at a time, what stands ready for drawing it,
// and the reference images of it.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "display_driver/pacing/eye_feed.h"
#include "display_driver/pacing/eyes_source.h"
#include "display_driver/pacing/motion_clock.h"
#include "oc_core/camera/view.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {

/// Called by one thread at a time.
class MovingView {
 public:
  /// `images` outlives it. Positions are in display radii. Images have `fewestPixels` or more. The acceleration
  /// structure, where images of so few pixels are constructed by rays (constructWithRays()), is built here, and follows
  /// the motion from then on.
  MovingView(std::unique_ptr<SceneMotion> motion, MovingImages& images, const MotionPlayback& playback,
             size_t fewestPixels, Construction wanted = Construction::kAuto);

  /// Moves the scene to where it is at that time.
  EyesOptions::SceneState moveTo(HostTime seen);
  /// Images of it as it stands. Throws as MovingImages::next() does.
  ReferenceImages imagesFrom(const PinholeCamera& reference);

  const SceneMotion& motion() const { return *motion_; }
  /// How many images were constructed, and of these by rays.
  int imagesMade() const { return imagesMade_; }
  int imagesByRays() const { return imagesByRays_; }
  /// How often the structure was built anew since.
  int rebuilds() const { return rebuilds_; }

 private:
  bool castsFor(size_t pixels) const;
  void followWithRays();

  std::unique_ptr<SceneMotion> motion_;
  MovingImages& images_;
  MotionClock clock_;
  Construction wanted_;
  size_t fewestPixels_;
  std::unique_ptr<RayScene> rays_;
  uint64_t raysTopology_ = 0;
  bool raysAreBehind_ = false;                          ///< the scene has moved since they followed
  std::optional<std::pair<uint64_t, uint64_t>> shown_;  ///< topology and shape
  int imagesMade_ = 0;
  int imagesByRays_ = 0;
  int rebuilds_ = 0;
};

/// An eye that stays where it is.
class StandingEye final : public EyeFeed {
 public:
  explicit StandingEye(const glm::vec3& eye = View{}.eye) : eye_(eye) {}
  std::optional<glm::vec3> eyeAt(HostTime) override { return eye_; }
  bool ended(HostTime) override { return false; }

 private:
  glm::vec3 eye_;
};

}  // namespace ocelli
