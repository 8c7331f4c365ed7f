#include "oc_core/explore/explore_shown_camera.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"

namespace ocelli {
namespace {

bool isLiveConstructor(const std::string& name) {
  return std::ranges::any_of(liveConstructors(), [&](const LiveConstructorRow& row) { return name == row.name; });
}

}  // namespace

void showCamera(Explorer& explorer, const std::string& nameOrFile) {
  const PinholeCamera& view = explorer.frame().pinhole;
  const std::optional<glm::ivec2> size = sizeInFile(nameOrFile);
  const PinholeCamera reference = size ? PinholeCamera(view.view(), size->x, size->y) : view;
  explorer.showDrawn(constructCamera(nameOrFile, explorer.scene().scene(), reference), nameOrFile);
}

void checkExploreCamera(const std::string& constructorOrFile) {
  if (constructorOrFile.ends_with(".json")) {
    if (!namesConstructor(constructorOrFile)) {
      throw InputError("its camera is none to explore with", constructorOrFile,
                       "give the file of a graph or curved ray camera, such as K saves");
    }
  } else {
    findLiveConstructor(constructorOrFile);
  }
}

void exploreFrom(Explorer& explorer, const std::string& constructorOrFile) {
  if (isLiveConstructor(constructorOrFile)) {
    explorer.choose(constructorOrFile);
  } else {
    checkExploreCamera(constructorOrFile);
    showCamera(explorer, constructorOrFile);
  }
}

}  // namespace ocelli
