// Someone who walks through a scene: an eye at its height over the floor. Steps end at walls and slide along them,
// climb stairs and go down slopes; where there is no floor one flies.
//
// DEVIATION: the text leaves the walk to the user; walls, floors and stairs are found by rays, so that every scene has
// them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/explore/explore_scene.h"

namespace ocelli {

/// The least upright part of the normal of what one can stand on.
inline constexpr float kFloorNormal = 0.7f;

/// Where the walker is and looks. Angles in degrees: heading 0 looks to the north (-z), 90 to the east (+x); pitch is
/// up from level.
struct WalkerView {
  glm::dvec3 eye{0};
  double headingDegrees = 0;
  double pitchDegrees = 0;

  bool operator==(const WalkerView&) const = default;
};

/// Unit vectors: where it looks, and the level one of its heading.
glm::dvec3 lookOf(const WalkerView& view);
glm::dvec3 headingOf(const WalkerView& view);
/// The heading of a direction, degrees; that of `otherwise` where it is upright.
double headingDegreesOf(const glm::dvec3& direction, double otherwise = 0);
/// From one view to another along the shorter turn; `share` from 0 to 1.
WalkerView between(const WalkerView& from, const WalkerView& to, double share);

/// What the walker does for a while, as a person holds keys or sticks. Shares of the full speed, -1 to 1.
struct WalkInput {
  double forward = 0;
  double right = 0;
  double up = 0;         ///< where it flies
  double turnRight = 0;  ///< of the heading
  double lookUp = 0;     ///< of the pitch
  bool fast = false;
  glm::dvec2 pointerDegrees{0};  ///< turns by so much at once: to the right, and up

  bool still() const { return *this == WalkInput{}; }
  bool operator==(const WalkInput&) const = default;
};

struct WalkerOptions {
  double eyeHeight = 1.6;     ///< over the floor, metres
  double radius = 0.25;       ///< how near walls come, metres
  double stepHeight = 0.45;   ///< what one climbs without a jump, metres
  double speed = 1.6;         ///< metres a second
  double fastFactor = 3;      ///< of the speed
  double turnDegrees = 60;    ///< a second
  double maxPitch = 75;       ///< degrees, up and down
  double fovHorizontal = 70;  ///< degrees, of the image
  bool fly = false;           ///< through walls, too
};

class ExploreWalker {
 public:
  /// Starts at a place to stand: see openPlace().
  ExploreWalker(const ExploreScene& scene, const WalkerOptions& options);

  const WalkerView& view() const { return view_; }
  const WalkerOptions& options() const { return options_; }
  WalkerOptions& options() { return options_; }
  /// Jumps there. The eye stays at its own height where no floor is below it.
  void jump(const WalkerView& view);
  /// Sets the view alone, as what moves the walker along a path does.
  void place(const WalkerView& view) { view_ = view; }
  void step(const WalkInput& input, double seconds);

  /// The floor below a point within `reach` metres; nothing where there is none.
  std::optional<glm::vec3> floorBelow(const glm::dvec3& point, double reach) const;
  bool overFloor() const { return overFloor_; }
  /// The last step met a wall.
  bool atWall() const { return atWall_; }

  /// The pinhole of this view.
  PinholeCamera camera(int width, int height) const;

 private:
  void turn(const WalkInput& input, double seconds);
  glm::dvec3 slid(glm::dvec3 move) const;

  const ExploreScene& scene_;
  WalkerOptions options_;
  WalkerView view_;
  bool overFloor_ = false;
  mutable bool atWall_ = false;
};

/// Where one can stand and see far: the entrance of a maze, the beginning of a path, or an open place near the middle
/// of the scene. Where there is no floor, a place before the scene from which one sees all of it.
WalkerView openPlace(const ExploreScene& scene, const WalkerOptions& options);

/// The pinhole of any view; zNear and zFar fit the scene.
PinholeCamera walkerCamera(const WalkerView& view, const ExploreScene& scene, double fovHorizontalDegrees, int width,
                           int height);

}  // namespace ocelli
