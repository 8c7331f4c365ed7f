#include "oc_core/feeds_measure/feed_rigs.h"

#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {

std::span<const FeedRig> feedRigs() {
  static const std::vector<FeedRig> rigs{corridorRig()};
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

}  // namespace ocelli
