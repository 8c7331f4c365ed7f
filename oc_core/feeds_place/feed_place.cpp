#include "oc_core/feeds_place/feed_place.h"

#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/scene/scene.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {

FeedPlaceScene loadFeedPlace(const std::string& source, const std::optional<double>& metre, bool hasMap,
                             const Progress& progress) {
  SceneOptions options;
  options.fit = false;
  GuidedScene scene = loadGuidedScene(source, options, progress);
  const SceneMetre length = metre ? SceneMetre{*metre, true} : metreOf(source, scene);
  FeedPlaceScene place;
  place.metre = length.units;
  place.isMetreKnown = length.isKnown;
  place.mesh = std::move(scene.mesh);
  if (place.metre != 1) {
    transform(place.mesh, glm::scale(glm::mat4(1), glm::vec3(static_cast<float>(1 / place.metre))));
  }
  if (hasMap) {
    place.map = findWalkMap(place.mesh, {}, progress);
  }
  return place;
}

}  // namespace ocelli
