#include "oc_core/shade/environment_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

/// Level, so that latitudes are those of the world.
View viewFrom(const glm::vec3& viewpoint) {
  View view;
  view.eye = viewpoint;
  view.target = viewpoint - glm::vec3(0, 0, 1);
  view.fovVerticalDegrees = 90;
  view.zNear = 1e-6f;
  return view;
}

}  // namespace

EnvironmentMap::EnvironmentMap(const glm::vec3& viewpoint, const Mesh& mesh, int height, const glm::vec3& background)
    : camera_(PinholeCamera(viewFrom(viewpoint), 2 * height, height)),
      viewpoint_(viewpoint),
      image_(colorImage(raycast(camera_, mesh, RayScene(mesh)), mesh, background)) {}

glm::vec3 EnvironmentMap::colorOf(const glm::vec3& direction) const {
  const auto place = camera_.project(viewpoint_ + glm::normalize(direction));
  const float u = place ? place->u - 0.5f : 0;
  const float v = place ? place->v - 0.5f : 0;
  const auto x = static_cast<int>(std::floor(u));
  const auto y = static_cast<int>(std::floor(v));
  const auto pixel = [&](int column, int row) {
    return image_((column + image_.width()) % image_.width(), std::clamp(row, 0, image_.height() - 1));
  };
  const float right = u - static_cast<float>(x);
  return glm::mix(glm::mix(pixel(x, y), pixel(x + 1, y), right), glm::mix(pixel(x, y + 1), pixel(x + 1, y + 1), right),
                  v - static_cast<float>(y));
}

}  // namespace ocelli
