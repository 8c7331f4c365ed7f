#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/constructor/walk_fields.h"
#include "oc_core/constructor/walk_region.h"
#include "oc_core/walkable/walkable.h"
#include "tests/constructor/walk_checks.h"

namespace ocelli {
namespace {

TEST(WalkScenes, debug) {
  for (const std::string name : {"builtin:town", "builtin:house", "builtin:house,seed=3", "builtin:city", "builtin:city,seed=4"}) {
    SceneOptions options;
    options.fit = false;
    const GuidedScene scene = loadGuidedScene(name, options);
    for (const bool found : {false, true}) {
      if (!found && !scene.guides.walk) continue;
      const WalkMap map = found ? findWalkMap(scene.mesh, inUnits({}, metreOf(name, scene).units)) : *scene.guides.walk;
      const auto regions = walkRegionsOf(map);
      size_t exits = 0;
      for (auto& r : regions) exits += r.exits.size();
      printf("%s %s: %zu cells, %zu portals, %zu exits of %zu\n", name.c_str(), found ? "found" : "guides", map.cells.size(), map.portals.size(), exits, 2 * map.portals.size());
      const ComprehensiveWalk walk = makeComprehensiveWalk(map, {}, 1920, 1080);
      std::map<std::string, size_t> why;
      for (auto& c : walk.cells) ++why[textOf(c.unseen)];
      for (auto& [text, n] : why) printf("   %zu: %s\n", n, text.c_str());
      printf("   frusta %zu\n", walk.camera.frusta().size());
      std::string file = name; for (char& c : file) if (c == ':' || c == ',' || c == '=') c = '_';
      test::keepImage(walk.camera, scene.mesh, file + (found ? "_found" : "_guides"));
    }
  }
}

}  // namespace
}  // namespace ocelli
