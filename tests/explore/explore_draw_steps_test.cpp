// The step "draw" of scripts: a camera is drawn, shown and saved.
#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/explore/explore_offscreen.h"
#include "oc_core/explore/explore_shown_camera.h"
#include "tests/base/temporary_folder.h"
#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

TEST(ExploreDrawSteps, drawWhatIsShownThen) {
  const test::TemporaryFolder folder;
  const std::string drawing =
      folder
          .write("drawing.json", R"({"size": [160, 90], "view": {"eye": [0, 1.6, 8], "target": [0, 1.6, 0],
                  "fov_vertical_degrees": 45, "z_near": 0.1}, "steps": [{"tool": "bend"}, {"stroke": [[-6, 2], [6, 2]]},
                  {"handle": "viewpoint", "of": "frustum 1"}, {"move": [1, 8]}, {"save": "drawn.json"}]})")
          .string();
  ExploreOffscreenOptions options;
  options.folder = folder / "out";
  std::vector<std::string> wrote;
  options.wrote = [&](const std::filesystem::path& path) { wrote.push_back(path.filename().string()); };
  ExploreScene scene(test::hall());
  const std::string steps = R"({"draw": ")" + drawing + R"("}, {"expect": "drawing.json"}, {"wait": "rest"},
                               {"save": "seen.png"}, {"save_camera": "camera.json"},
                               {"camera": ")" +
                            (folder / "out/drawn.json").string() + R"("}, {"wait": "rest"},
                               {"save": "again.png"})";
  exploreOffscreen(scene, exploreScriptFromJsonText("{\"size\": [160, 90], \"steps\": [" + steps + "]}", "script.json"),
                   options);
  EXPECT_EQ(wrote, (std::vector<std::string>{"drawn.json", "seen.png", "camera.json", "again.png"}));
  EXPECT_THAT(readFile(folder / "out/camera.json"), HasSubstr("frustum 1"));
  EXPECT_EQ(readPng(folder / "out/seen.png"), readPng(folder / "out/again.png"));
}

TEST(ExploreDrawSteps, filesThatAreReadLieBesideTheScript) {
  const test::TemporaryFolder folder;
  folder.write("drawing.json", R"({"size": [160, 90], "view": {"eye": [0, 1.6, 8], "target": [0, 1.6, 0],
                 "fov_vertical_degrees": 45, "z_near": 0.1}, "steps": [{"save": "drawn.json"}]})");
  const std::filesystem::path script = folder.write(
      "script.json", R"({"size": [160, 90], "steps": [{"draw": "drawing.json"}, {"camera": "drawn.json"}]})");
  ExploreOffscreenOptions options;
  options.folder = folder.path();
  ExploreScene scene(test::hall());
  EXPECT_GT(exploreOffscreen(scene, readExploreScript(script), options).frames, 0);
  // A file to begin with is one of the user's, and named as usual.
  options.camera = (folder / "drawn.json").string();
  EXPECT_NO_THROW(checkExploreCamera(options.camera));
  const ExploreScript drawn =
      exploreScriptFromJsonText(R"({"size": [160, 90], "steps": [{"wait": "rest"}, {"expect": "drawn.json"}]})", "s");
  EXPECT_GT(exploreOffscreen(scene, drawn, options).frames, 0);
}

TEST(ExploreDrawSteps, whatIsNoCameraIsRefusedAtOnce) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(checkExploreCamera("portal"));
  EXPECT_THROW(checkExploreCamera("telescope"), InputError);
  EXPECT_THROW(checkExploreCamera((folder / "missing.json").string()), InputError);
  EXPECT_THROW(checkExploreCamera(folder.write("other.json", "{}").string()), InputError);
}

TEST(ExploreDrawSteps, errorsNameTheStepOfTheDrawing) {
  const test::TemporaryFolder folder;
  const std::string drawing = folder.write("drawing.json", R"({"steps": [{"undo": 1}]})").string();
  ExploreScene scene(test::hall());
  try {
    exploreOffscreen(
        scene, exploreScriptFromJsonText(R"({"size": [160, 90], "steps": [{"draw": ")" + drawing + R"("}]})", "s"), {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("drawing.json, step 1"));
    EXPECT_THAT(error.what(), HasSubstr("nothing to undo"));
  }
}

}  // namespace
}  // namespace ocelli
