// Ways from the angle of a scene that turns rigidly to the volume of a refresh, for turning_bench.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/pack/packed_scene.h"

namespace ocelli {

/// How far the scene turns from refresh to refresh: 30 degrees a second at 24 Hz.
inline constexpr double kTurnDegrees = 1.25;

/// Makes the volume of a refresh, and says how long its stages took, milliseconds. The first call is of refresh 0.
using TurningWay = std::function<std::vector<double>(int refresh)>;

/// The mesh, turned and sliced anew; `ordered` is in the slicer's best order. One stage.
TurningWay geometryWay(const Mesh& ordered, const DisplayProfile& profile);

/// The reference images that `build` makes for an eye. Turning the scene is turning the eye the other way round: so the
/// scene may stay as it is, and what was made of it once. Then their mesh, turned as the scene, and its slices. Three
/// stages.
TurningWay ocriWay(std::function<ReferenceImages(const PinholeCamera& reference)> build, int width, int height,
                   const DisplayProfile& profile);

/// What all triangles of a scene take that is sliced in parts, one after the other into one volume: milliseconds.
struct PartsTimes {
  size_t parts = 0;
  double standing = 0;  ///< every part stands in memory in the slicer's best order
  double streamed = 0;  ///< every part is read from the pack anew, which lies in the memory of the system
};

/// Every part in turn, so that one alone need be in memory; the least of `runs` refreshes, added up. The display has
/// one bit a channel.
PartsTimes sliceInParts(const PackedScene& scene, size_t trianglesOfPart, int runs, const DisplayProfile& profile);

}  // namespace ocelli
