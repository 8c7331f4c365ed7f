// The frusta of the ways that leave a crossing or room, for rays of a graph camera's root, deployed by any share: at 0
// the image is the root's, and it changes continuously with the share.
#pragma once

#include <array>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_camera.h"
#include "oc_core/constructor/walk_space.h"

namespace ocelli {

struct WaysView {
  std::array<double, 3> split{};  ///< of rays: to the left, ahead and to the right
  double fovWayDegrees = 40;
  double deployed = 1;
  glm::dvec3 eye{0};                       ///< of the user: the height of viewpoints over the floor is his
  double eyeHeight = 0;                    ///< over the floor below him
  std::optional<uint32_t> chosenPortal{};  ///< as in WalkCameraOptions
  double chosenShare = 0;
  double chosenOpen = 0;
};

/// The ways out of the crossing that one comes into by `opening`, from left to right, but for that one. The rays of the
/// root of `camera` part in the opening.
std::vector<WalkWay> addCrossingWays(GraphCamera& camera, const WalkSpace& space, const WalkExit& opening,
                                     const WaysView& view);

/// The ways out of the region in which the eye of the root is: rays turn in the openings to look straight in.
std::vector<WalkWay> addRoomWays(GraphCamera& camera, const WalkSpace& space, uint32_t number, const WaysView& view);

/// Sides, floor and ceiling of a region, moved outwards the farther the less is deployed: limits for rays in it. Those
/// of the first kind leave out sides with openings, for rays that go on through these.
std::vector<Plane> closedSides(const WalkRegion& region, double deployed);
std::vector<Plane> allSides(const WalkRegion& region, double deployed);

}  // namespace ocelli
