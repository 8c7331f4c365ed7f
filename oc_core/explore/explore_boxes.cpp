#include "oc_core/explore/explore_boxes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr double kBorder = 0.9;        // of the angle from the middle to the border, over which what leaves fades
constexpr float kAroundPlace = 0.25f;  // metres

}  // namespace

std::optional<Box> clickedBox(const ExploreScene& scene, const ExplorePick& pick) {
  if (!pick.surface) {
    return std::nullopt;
  }
  if (pick.object > 0 && pick.object < scene.objects().size() && !scene.objects()[pick.object].empty()) {
    return scene.objects()[pick.object];
  }
  const glm::vec3 half(kAroundPlace * static_cast<float>(scene.metre()));
  return Box{pick.position - half, pick.position + half};
}

double fadedByDepth(const Box& box, const PinholeCamera& view, double metre, double from, double to) {
  double nearest = 1e30;
  for (const glm::vec3& corner : cornersOf(box)) {
    nearest = std::min(nearest, static_cast<double>(view.cameraFromWorld(corner).z));
  }
  return glm::smoothstep(from, to, nearest / metre);
}

double fadedByBorder(const Box& box, const PinholeCamera& view) {
  const glm::vec3 p = view.cameraFromWorld(box.center());
  if (!(p.z > 0)) {
    return 0;
  }
  // Evenly with the angle, so that it is no faster at any place than it has to be while the head turns.
  const auto share = [&](float off, int pixels) {
    const double border = std::atan(pixels / (2 * static_cast<double>(view.focalPixels())));
    const double angle = std::atan2(static_cast<double>(std::abs(off)), static_cast<double>(p.z));
    return std::clamp((border - angle) / (kBorder * border), 0.0, 1.0);
  };
  return share(p.x, view.width()) * share(p.y, view.height());
}

}  // namespace ocelli
