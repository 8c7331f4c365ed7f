// Pictures of scene files in the default view. OCELLI_TEST_IMAGES=FOLDER keeps them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "oc_core/camera/view.h"
#include "oc_core/image/color.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::test {

inline constexpr int kSide = 240;
/// The default view is 10 from the origin; this is how many pixels a unit there has.
inline float pixelsOfUnit() {
  const PinholeCamera camera(View{}, kSide, kSide);
  return camera.project(glm::vec3(1, 0, 0))->u - camera.project(glm::vec3(0))->u;
}

using Picture = Image<glm::vec3>;

/// Black where nothing is seen.
inline Picture pictureOf(const Mesh& mesh, const std::string& name, int side = kSide) {
  const FragmentImage fragments = rasterize(PinholeCamera(View{}, side, side), mesh);
  Picture picture(side, side, glm::vec3(0));
  for (size_t i = 0; i < picture.size(); ++i) {
    if (fragments[i].covered()) {
      picture[i] = colorOf(fragments[i], mesh);
    }
  }
  if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
    writePng(std::filesystem::path(folder) / (name + ".png"), srgbFromLinear(picture));
  }
  return picture;
}

inline Picture pictureOfFile(const std::filesystem::path& path, const SceneOptions& options, const std::string& name,
                             int side = kSide) {
  return pictureOf(loadScene(path.string(), options), name, side);
}

inline size_t differences(const Picture& a, const Picture& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    count += glm::distance(a[i], b[i]) > 1e-4f ? 1 : 0;
  }
  return count;
}

inline size_t covered(const Picture& picture) {
  return static_cast<size_t>(
      std::count_if(picture.begin(), picture.end(), [](const glm::vec3& c) { return c != glm::vec3(0); }));
}

}  // namespace ocelli::test
