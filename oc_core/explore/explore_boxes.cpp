#include "oc_core/explore/explore_boxes.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr double kBorder = 0.45;       // of the image, over which what leaves it fades
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
  const ImagePoint middle = view.imageFromCamera(p);
  const double width = view.width();
  const double height = view.height();
  const double u = std::min<double>(middle.u, width - static_cast<double>(middle.u));
  const double v = std::min<double>(middle.v, height - static_cast<double>(middle.v));
  // Evenly, so that it is no faster at any place than it has to be while the head turns.
  return std::clamp(u / (kBorder * width), 0.0, 1.0) * std::clamp(v / (kBorder * height), 0.0, 1.0);
}

}  // namespace ocelli
