#include "oc_core/feeds_measure/feed_rigs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {

std::span<const FeedRig> feedRigs() {
  static const std::vector<FeedRig> rigs{corridorTRig(), corridorRig(), shopRig(), courtyardRig()};
  return rigs;
}

const FeedRig& feedRigOf(const std::string& scene) {
  std::string names;
  for (const FeedRig& rig : feedRigs()) {
    const std::string name = std::string("builtin:") + rig.scene;
    if (scene == name || scene.starts_with(name + ",")) {
      return rig;
    }
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError("there are no cameras and ways for the scene " + scene, "SCENE", "choose one of: " + names);
}

Feed rigFeed(const std::string& name, const glm::ivec2& size, double focal, const glm::dvec3& eye,
             const glm::dvec3& target) {
  Feed feed;
  feed.name = name;
  feed.source = name + ".mkv";
  feed.background = name + ".png";
  feed.width = size.x;
  feed.height = size.y;
  feed.lens.focal = {focal, focal};
  feed.lens.center = glm::dvec2(size) / 2.0;
  feed.pose = {eye, target, {0, 1, 0}};
  return feed;
}

FeedSetup resizedSetup(FeedSetup setup, int width, int height) {
  const auto scaleOf = [&](int oldWidth, int oldHeight) {
    return std::min(static_cast<double>(width) / oldWidth, static_cast<double>(height) / oldHeight);
  };
  for (Feed& feed : setup.feeds) {
    const glm::dvec2 beside = feed.lens.center - glm::dvec2(feed.width, feed.height) / 2.0;
    const double scale = scaleOf(feed.width, feed.height);
    feed.lens.focal *= scale;
    feed.lens.center = glm::dvec2(width, height) / 2.0 + scale * beside;
    feed.width = width;
    feed.height = height;
  }
  FeedOutput& output = setup.output;
  const double half = std::tan(radiansFromDegrees(output.fovVerticalDegrees) / 2);
  const double scale = scaleOf(output.width, output.height);
  output.fovVerticalDegrees = degreesFromRadians(2 * std::atan(half * height / (scale * output.height)));
  output.width = width;
  output.height = height;
  return setup;
}

}  // namespace ocelli
