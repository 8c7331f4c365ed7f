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
  for (const std::string name : {"builtin:house", "builtin:house,seed=3", "builtin:house,seed=7"}) {
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
      for (size_t i = 0; i < walk.cells.size(); ++i) { auto& c = walk.cells[i]; auto& m = map.cells[i];
        printf("  %zu: %s parent %d turns %zu pixels %.2f kind %d center %.1f %.1f %.1f size %.1f x %.1f h %.1f rise %.1f exits %zu\n", i, textOf(c.unseen), c.parent, c.turns, c.pixels, (int)m.kind, m.center.x, m.center.y, m.center.z, 2*m.halfLength, 2*m.halfWidth, m.height, m.floorRise, regions[i].exits.size()); }
      for (size_t i = 0; i < map.portals.size(); ++i) { auto& p = map.portals[i]; bool a=false,b=false; for (auto& e : regions[p.from].exits) a |= e.portal == i; for (auto& e : regions[p.to].exits) b |= e.portal == i;
        if (!a || !b) printf("  portal %zu: %u %d -> %u %d center %.2f %.2f %.2f normal %.2f %.2f half %.2f up %.2f\n", i, p.from, a, p.to, b, p.opening.center.x, p.opening.center.y, p.opening.center.z, p.opening.normal.x, p.opening.normal.z, glm::length(p.opening.halfRight), p.opening.halfUp.y); }
      printf("   frusta %zu\n", walk.camera.frusta().size());
      std::string file = name; for (char& c : file) if (c == ':' || c == ',' || c == '=') c = '_';
      test::keepImage(walk.camera, scene.mesh, file + (found ? "_found" : "_guides"));
    }
  }
}

}  // namespace
}  // namespace ocelli
