// The scripts of docs/explore.md: they draw what the page says.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "oc_core/base/file_bytes.h"
#include "oc_core/frustum_editor/editor_script.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

const GuidedScene& town() {
  static const GuidedScene scene = [] {
    SceneOptions options;
    options.fit = false;
    return loadGuidedScene("builtin:town", options);
  }();
  return scene;
}

EditorSession played(const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path file = std::filesystem::path(OCELLI_CAMERA_EXAMPLES) / name;
  return playEditorScript(editorScriptFromJsonText(readFile(file), file.string()), file.parent_path(), View{},
                          town().mesh, town().guides, folder);
}

/// Objects by how many pixels show them.
std::map<uint32_t, int> seenObjects(const MultiperspectiveCamera& camera) {
  std::map<uint32_t, int> seen;
  for (const Fragment& fragment : rasterize(camera, town().mesh)) {
    if (fragment.covered()) {
      ++seen[town().objectOfTriangle[fragment.triangle]];
    }
  }
  seen.erase(0);
  return seen;
}

int objectsOfAtLeast(const std::map<uint32_t, int>& seen, int pixels) {
  return static_cast<int>(
      std::count_if(seen.begin(), seen.end(), [&](const auto& each) { return each.second >= pixels; }));
}

TEST(EditorTown, theSummaryHasEightViewpointsThatEachShowSomething) {
  const test::TemporaryFolder folder;
  EditorSession session = played("draw_town.json", folder.path());
  const GraphCamera& camera = std::get<GraphCamera>(session.editor().camera());
  ASSERT_EQ(camera.frusta().size(), 8U);
  std::set<std::pair<double, double>> viewpoints;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    viewpoints.insert({frustum.viewpoint.x, frustum.viewpoint.z});
  }
  EXPECT_EQ(viewpoints.size(), 8U);

  const FragmentImage image = rasterize(session.editor().camera(), town().mesh);
  std::vector<std::set<uint32_t>> objects(8);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const Fragment& fragment = image(x, y);
      if (fragment.covered()) {
        const std::optional<glm::vec3> point =
            session.editor().drawn().graph().unproject({pixel.x, pixel.y, fragment.t});
        const int frustum = point ? camera.frustumOf(glm::dvec3(*point)) : -1;
        if (frustum >= 0) {
          objects[static_cast<size_t>(frustum)].insert(town().objectOfTriangle[fragment.triangle]);
        }
      }
    }
  }
  for (size_t i = 0; i < objects.size(); ++i) {
    objects[i].erase(0);
    EXPECT_GE(objects[i].size(), 1U) << camera.frusta()[i].name;
  }

  // A pinhole at the root's eye shows far less; the clock tower is in the middle.
  const std::map<uint32_t, int> seen = seenObjects(session.editor().camera());
  const std::map<uint32_t, int> pinhole = seenObjects(GraphCamera(camera.root()));
  EXPECT_GE(objectsOfAtLeast(seen, 100), objectsOfAtLeast(pinhole, 100) + 20);  // 101 and 75
  EXPECT_GT(seen.at(town().guides.target->object), 20000);

  EXPECT_TRUE(std::filesystem::exists(folder / "draw-town.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "draw-town-plan.png"));
}

TEST(EditorTown, withoutTheHouseNoFrustaOverlap) {
  const test::TemporaryFolder folder;
  EditorSession session = played("draw_town.json", folder.path());
  // The house is last, and what is inside of its walls is no one else's to see: its overlap with the root is allowed.
  for (const DrawnOverlap& overlap : session.editor().drawn().overlaps) {
    EXPECT_EQ(overlap.first, "root");
    EXPECT_EQ(overlap.second, "house");
  }
  session.editor().select("house");
  ASSERT_TRUE(session.editor().removeSelected());
  EXPECT_TRUE(session.editor().allowOverlap(false)) << session.editor().message();
}

TEST(EditorTown, theCurvedCameraSeesAroundTheCorner) {
  const test::TemporaryFolder folder;
  EditorSession session = played("draw_street.json", folder.path());
  const CurvedRayCamera& camera = std::get<CurvedRayCamera>(session.editor().camera());
  ASSERT_EQ(camera.bends().size(), 1U);
  const std::map<uint32_t, int> seen = seenObjects(session.editor().camera());
  const std::map<uint32_t, int> pinhole = seenObjects(GraphCamera(camera.root()));
  int gained = 0;
  for (const auto& [object, pixels] : seen) {
    gained += pixels >= 100 && !pinhole.contains(object) ? 1 : 0;
  }
  EXPECT_GE(gained, 3);
}

}  // namespace
}  // namespace ocelli
