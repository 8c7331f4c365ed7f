// A small room whose images are worked out in plain steps: walls with a pattern, and a pillar that hides some of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/sea/sea_build.h"
#include "oc_core/sea/sea_source.h"

namespace ocelli::test {

/// The walls of a room of 4 x 3 x 5 metres around the origin, and a pillar in it.
Mesh roomProxy();

class RoomImages : public SeaSource {
 public:
  explicit RoomImages(std::vector<SeaPose> poses, SeaProjection projection = {.width = 64, .height = 64});

  std::string description() const override { return "a room"; }
  const SeaProjection& projection() const override { return projection_; }
  const std::vector<SeaPose>& poses() const override { return poses_; }
  const std::vector<std::string>& names() const override { return names_; }
  Image<Rgb8> image(uint32_t index) const override;
  /// As seen from any pose.
  Image<Rgb8> seenFrom(const SeaPose& pose) const;

 private:
  std::vector<SeaPose> poses_;
  SeaProjection projection_;
  std::vector<std::string> names_;
  SeaProxy room_;
};

/// So many places on a level grid about the middle of the room, so far apart.
std::vector<SeaPose> gridPoses(int columns, int rows, double spacing);

/// Places beside the pillar: from each of them it hides another part of the wall.
std::vector<SeaPose> aroundThePillar();
/// Points on the walls, the floor and the ceiling, so far apart.
std::vector<glm::vec3> wallPoints(float spacing);

SeaSettings settingsOf(const SeaSource& source, SeaWay way = SeaWay::kDirect);

/// How far two images differ in the mean, in steps of 8-bit values.
double meanDifference(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace ocelli::test
