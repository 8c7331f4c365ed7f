// `builtin:fence`: a picket fence before a patterned wall. Its gaps are given in pixels of the default view, because
// gaps of about a pixel are what breaks reference images.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

// Half sizes of the scene's box, whose corners lie on the unit sphere: fitting changes nothing, so pixels stay pixels.
glm::vec3 halfSizes() {
  return glm::normalize(glm::vec3(0.80f, 0.56f, 0.22f));
}

/// Length of a pixel of the default view (720x480, the eye at (0, 0, 10)) at the given z.
double pixelSizeAt(double z) {
  const double halfHeight = std::tan(std::asin(1.0 / kDefaultEyeDistance));
  return (kDefaultEyeDistance - z) * halfHeight / (kDefaultHeight / 2);
}

/// A board with a pointed top: five corners in front, five behind.
Mesh makePicket(float width, float bottom, float shoulder, float tip, float back, float front) {
  const float half = width / 2;
  const std::array<glm::vec2, 5> outline{
      {{-half, bottom}, {half, bottom}, {half, shoulder}, {0, tip}, {-half, shoulder}}};
  Mesh picket;
  for (const float z : {front, back}) {
    for (const glm::vec2& corner : outline) {
      picket.positions.push_back({corner, z});
    }
  }
  picket.triangles = {{0, 1, 2}, {0, 2, 4}, {4, 2, 3}, {6, 5, 7}, {7, 5, 9}, {7, 9, 8}};
  for (uint32_t i = 0; i < 5; ++i) {
    const uint32_t j = (i + 1) % 5;
    picket.triangles.push_back({i, i + 5, j + 5});
    picket.triangles.push_back({i, j + 5, j});
  }
  return picket;
}

/// Diagonal stripes of tiles in five colours: what is behind a gap can be told from what is beside it.
Mesh makeWall(const glm::vec3& half) {
  const std::array<glm::vec3, 5> colors{palette::skyBlue(), palette::vermilion(), palette::green(), palette::blue(),
                                        palette::purple()};
  glm::mat4 worldFromPanel(1);
  worldFromPanel[3] = {0, 0, -half.z, 1};
  Mesh wall;
  addPanel(wall, evenLines(-half.x, half.x, 30), evenLines(-half.y, half.y, 21), worldFromPanel,
           [&](size_t i, size_t j) { return colors[(i + 2 * j) % colors.size()] * ((i + j) % 2 == 0 ? 1.0f : 0.7f); });
  return wall;
}

Scene buildFence(const BuiltinValues& values) {
  const glm::vec3 half = halfSizes();
  const float front = half.z;
  const float thickness = 0.02f;
  const double pixel = pixelSizeAt(front);
  const double gap = values.number("gap") * pixel;
  const size_t pickets = values.count("pickets");
  const double fenceWidth = 2 * 0.93 * half.x;
  const double width = (fenceWidth - gap * static_cast<double>(pickets - 1)) / static_cast<double>(pickets);
  if (width < pixel) {
    throw InputError(
        fmt::format("{} pickets with gaps of {:g} pixels are wider than the fence, which has {:.0f} pixels", pickets,
                    values.number("gap"), fenceWidth / pixel),
        "builtin:fence", "fewer pickets or narrower gaps");
  }
  Scene scene;
  scene.add(makeWall(half));
  scene.meshes.push_back(makePicket(static_cast<float>(width), -half.y, 0.62f * half.y,
                                    0.62f * half.y + std::min(0.6f * static_cast<float>(width), 0.3f * half.y),
                                    front - thickness, front));
  for (size_t i = 0; i < pickets; ++i) {
    const double x = -fenceWidth / 2 + width / 2 + static_cast<double>(i) * (width + gap);
    scene.instances.push_back(
        {1, glm::translate(glm::mat4(1), glm::vec3(x, 0, 0)), i % 2 == 0 ? palette::ivory() : palette::yellow()});
  }
  scene.meshes.push_back(makeBox({static_cast<float>(fenceWidth) / 2, 0.035f, thickness / 2}));
  for (const float y : {-0.6f, 0.35f}) {
    scene.instances.push_back(
        {2, glm::translate(glm::mat4(1), {0, y * half.y, front - 1.5f * thickness}), palette::orange()});
  }
  return scene;
}

}  // namespace

BuiltinScene fenceScene() {
  return {"fence",
          "a picket fence before a patterned wall",
          {{"gap", "between pickets, in pixels of the default view at 720x480", BuiltinParameter::Kind::kNumber, "4",
            0.1, 100},
           {"pickets", "how many", BuiltinParameter::Kind::kInteger, "14", 2, 200}},
          buildFence};
}

}  // namespace ocelli
