#include "oc_core/explore_window/explore_window_session.h"

#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

std::vector<std::filesystem::path> playSteps(GlContext& context, const std::string& steps,
                                             const std::filesystem::path& folder, OpenExploreVideo record = {}) {
  const ExploreScript script = exploreScriptFromJsonText(R"({"size": [640, 360], "steps": [)" + steps + "]}", "script");
  std::vector<std::filesystem::path> written;
  playInExploreWindow(
      context, script,
      {.model = {.read =
                     [](const Progress&) {
                       SceneOptions options;
                       options.fit = false;
                       return std::make_shared<ExploreScene>(loadGuidedScene("builtin:maze,columns=3,rows=3", options));
                     }},
       .folder = folder,
       .record = std::move(record),
       .wrote = [&](const std::filesystem::path& path) { written.push_back(path); }});
  return written;
}

class ExploreWindowSessionTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context = openTestContext(GetParam());
  test::TemporaryFolder folder;
};

TEST_P(ExploreWindowSessionTest, theSameScriptGivesTheSameImages) {
  const std::string steps =
      R"({"choose": "portal"}, {"wait": "rest"}, {"key": "Tab"}, {"walk": {"forward": 1}}, {"save": "walk.png"})";
  playSteps(*context, steps, folder / "one");
  playSteps(*context, steps, folder / "two");
  EXPECT_EQ(test::fileBytes(folder / "one/walk.png"), test::fileBytes(folder / "two/walk.png"));
}

TEST_P(ExploreWindowSessionTest, keysAndClicksReachTheWindow) {
  playSteps(*context,
            R"({"save": "plain.png"}, {"key": "H"}, {"save": "help.png"}, {"key": "Escape"}, {"key": "M"},
               {"save": "alone.png"}, {"drag": {"from": [200, 150], "to": [300, 150]}}, {"save": "turned.png"},
               {"key": "M"}, {"scroll": {"at": [600, 200], "up": 3}}, {"click": [600, 200]}, {"save": "moved.png"})",
            folder.path());
  std::set<std::string> images;
  for (const char* name : {"plain.png", "help.png", "alone.png", "turned.png", "moved.png"}) {
    EXPECT_TRUE(images.insert(test::fileBytes(folder / name)).second) << name;
  }
}

TEST_P(ExploreWindowSessionTest, framesOfTheWindowAreRecorded) {
  int frames = 0;
  bool isWhole = false;
  const auto record = [&](const std::filesystem::path&, int width, int height) {
    EXPECT_EQ(width, 640);
    EXPECT_EQ(height, 360);
    return ExploreRecording{[&](const Image<Rgb8>&) { ++frames; }, [&] { isWhole = true; }};
  };
  const std::vector<std::filesystem::path> written = playSteps(
      *context, R"({"record": "walk.mp4"}, {"seconds": 0.5}, {"stop_recording": true})", folder.path(), record);
  EXPECT_EQ(frames, 15);
  EXPECT_TRUE(isWhole);
  EXPECT_EQ(written, std::vector<std::filesystem::path>{folder / "walk.mp4"});
}

TEST_P(ExploreWindowSessionTest, whatCannotBeDoneSaysWhere) {
  const auto messageOf = [&](const std::string& steps) -> std::string {
    try {
      playSteps(*context, steps, folder.path());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageOf(R"({"key": "Nonsense"})").find("Shift+T"), std::string::npos);
  EXPECT_NE(messageOf(R"({"record": "walk.mp4"})").find("videos are not recorded here"), std::string::npos);
  EXPECT_NE(messageOf(R"({"key": "V"})").find("stop_recording"), std::string::npos);
}

TEST(ExploreWindowExamples, canBeRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OCELLI_EXPLORE_EXAMPLES)) {
    EXPECT_FALSE(readExploreScript(entry.path()).steps.empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

INSTANTIATE_TEST_SUITE_P(Offscreen, ExploreWindowSessionTest, kOffscreenProviders, providerName);

}  // namespace
}  // namespace ocelli
