// Maps of all built-in scenes, those of plans and those that are found, are read as they were written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>
#include <tuple>

#include "oc_core/base/error.h"
#include "oc_core/walkable/walk_map_file.h"
#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/house_plan.h"

namespace ocelli {
namespace {

void expectSameAfterFile(const WalkMap& map, const std::string& what) {
  const std::string text = jsonText(map);
  const WalkMap again = walkMapFromJsonText(text, what);
  EXPECT_EQ(again.cells, map.cells) << what;
  EXPECT_EQ(again.partOfCell, map.partOfCell) << what;
  EXPECT_EQ(again.roomOfCell, map.roomOfCell) << what;
  ASSERT_EQ(again.portals.size(), map.portals.size()) << what;
  for (size_t p = 0; p < map.portals.size(); ++p) {
    const WalkPortal& one = map.portals[p];
    const WalkPortal& other = again.portals[p];
    EXPECT_EQ(std::tie(one.from, one.to, one.isJoint), std::tie(other.from, other.to, other.isJoint)) << what;
    EXPECT_EQ(one.opening.center, other.opening.center) << what;
    EXPECT_EQ(one.opening.halfRight, other.opening.halfRight) << what;
    EXPECT_EQ(one.opening.halfUp, other.opening.halfUp) << what;
    // A product of two vectors of floats, divided by their lengths.
    EXPECT_LT(glm::distance(one.opening.normal, other.opening.normal), 1e-6f) << what;
  }
  EXPECT_EQ(jsonText(again), text) << what;
}

TEST(WalkMapFiles, OfAllBuiltinScenesAreReadAsTheyWereWritten) {
  expectSameAfterFile(cityWalkMap(planCity({})), "the plan of the city");
  expectSameAfterFile(houseWalkMap(planHouse({})), "the plan of the house");
  size_t found = 0;
  for (const BuiltinScene& builtin : listBuiltinScenes()) {
    const bool isPlace = builtin.name == "museum" || builtin.name == "office" || builtin.name == "library";
    const std::string source =
        "builtin:" + builtin.name + (isPlace ? ",texel=0.1" : "");  // not of millions of triangles
    GuidedScene scene;
    try {
      scene = loadGuidedScene(source, {.fit = false});
    } catch (const InputError&) {
      continue;  // a scene without triangles, as a volume
    }
    WalkMap map;
    try {
      map = findWalkMap(scene.mesh, inUnits({}, metreOf(source, scene).units));
    } catch (const InputError&) {
      continue;  // it has no floor
    }
    ++found;
    expectSameAfterFile(map, source + ", found");
  }
  EXPECT_GE(found, 5U);
}

TEST(WalkMapFiles, RingsAreLimitedInAll) {
  // 101 tunnels of 10,000 rings; 100 are allowed.
  std::string tunnel = R"({"kind": "tunnel", "center": [0, 0, 0], "length": 4, "width": 2, "height": 2, "rings": [)";
  for (int i = 0; i < 10000; ++i) {
    tunnel += i == 0 ? "[0,1,1,2]" : ",[0,1,1,2]";
  }
  tunnel += "]}";
  std::string cells = tunnel;
  for (int i = 1; i < 101; ++i) {
    cells += "," + tunnel;
  }
  try {
    walkMapFromJsonText("{\"cells\": [" + cells + "]}", "text");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("cell 100"), testing::HasSubstr("\"rings\""),
                                             testing::HasSubstr("may have 1000000")));
  }
}

}  // namespace
}  // namespace ocelli
