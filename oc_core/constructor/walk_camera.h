// The maze camera (section 4.3.1.4) for any scene with a walk map (oc_core/scene/walk_map.h): someone who stands
// anywhere on walkable floor, with any heading, sees ahead to the first crossing or room, and along all ways that leave
// it. The backward camera does so behind.
//
// In a tunnel, along its axis, the root frustum is as wide as the tunnel where the user stands, and its viewpoint lies
// so far behind that the opening of the crossing takes a given part of the image, however far away it is. There rays
// part: each way out gets its share of them, the split ratio, and the walls between the ways the rest (walk_fans.h).
// Where a way begins its rays turn once more, to look along it. In a room the eye is that of a pinhole, and rays bend
// in the openings ahead to look straight in (section 4.3.1.1).
//
// How far all of this is deployed is a function of the pose and of nothing else: not at all at an opening, across the
// tunnel and next to its walls' openings, in full some way from them. Not deployed the image is that of the pinhole of
// the eye, and everything between is continuous: so nothing jumps as the user walks, turns, and goes from one cell into
// the next. There is no state.
//
// An image is always given, also where nobody can walk: then it is the pinhole's, and the note says why.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_space.h"

namespace ocelli {

/// Lengths are in the scene's units.
struct WalkPose {
  glm::dvec3 eye{0};
  glm::dvec3 heading{0, 0, -1};  ///< any direction that is not vertical; its level part counts
};

struct WalkCameraOptions {
  std::array<double, 3> split{1.0 / 3, 1.0 / 3, 1.0 / 3};  ///< of rays: to the left, ahead and to the right
  bool backward = false;
  double fovHorizontalDegrees = 70;  ///< of the pinhole, and the widest of the root
  double fovWayDegrees = 40;         ///< at the beginning of the ways that leave the crossing
  double crossingShare = 0.8;        ///< of the image's width
  double deployWidths = 2;           ///< over how many widths of the tunnel the ways deploy behind an opening
  double portalsInRooms = 1;         ///< how far rays bend in the openings of the room that the user is in; 0 for none
  std::optional<double> deployed{};  ///< instead of what the pose allows; 0 is a pinhole, 1 deployed in full
  double lowered = 1;                ///< how far level rays move up from the middle, to show the floor (maze_horizon.h)
  double parallel = 0;               ///< 1 moves the viewpoint of the root away until its rays are almost parallel
  std::optional<uint32_t> chosenPortal{};  ///< of WalkMap::portals: the way out of the crossing to give more rays to
  double chosenShare = 0;                  ///< how far it gets them: 1 for all
  double chosenOpen = 0;                   ///< how far its sides let rays pass, which end rays otherwise: 1 for all
};

/// A way out of the crossing or room ahead.
struct WalkWay {
  uint32_t portal = 0;  ///< of WalkMap::portals
  uint32_t cell = 0;    ///< to which it leads
  size_t side = 1;      ///< 0 to the left, 1 ahead, 2 to the right
  int frustum = -1;     ///< of the camera, that looks along it; -1 where it is not shown
  std::string why;      ///< it is not shown; empty where it is
};

struct WalkCamera {
  GraphCamera camera;
  std::optional<uint32_t> cell{};      ///< in which the user stands
  std::optional<uint32_t> crossing{};  ///< whose ways are shown: the one ahead, or the room itself
  double deployed = 0;                 ///< 0 to 1
  std::vector<WalkWay> ways{};         ///< that leave the crossing, from left to right
  std::string note{};                  ///< why the image is no more than a pinhole's; empty where it is more
};

/// An image of that size. Throws InputError where the eye or the heading is not finite, where the heading is vertical,
/// where the split ratios are negative or do not add up to 1, and where the other options are out of range; never for a
/// pose.
WalkCamera makeWalkCamera(const WalkSpace& space, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height);
/// The same for one image. Where there are many, the space should be prepared once.
WalkCamera makeWalkCamera(const WalkMap& map, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height);

/// The pinhole of the user's eye, level, with the field of view of the options; backward too.
PinholeCamera walkPinhole(const WalkSpace& space, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height);

}  // namespace ocelli
