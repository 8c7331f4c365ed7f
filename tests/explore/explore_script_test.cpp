#include "oc_core/explore/explore_script.h"

#include <gmock/gmock.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/explore/explore_offscreen.h"
#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string errorOf(const std::string& text) {
  try {
    exploreScriptFromJsonText(text, "script.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string errorOfStep(const std::string& step) {
  return errorOf("{\"steps\": [" + step + "]}");
}

ExploreReport played(const std::string& steps, ExploreOffscreenOptions options = {}) {
  ExploreScene scene(test::twoRooms());
  return exploreOffscreen(
      scene, exploreScriptFromJsonText("{\"size\": [160, 90], \"steps\": [" + steps + "]}", "script.json"), options);
}

std::string playError(const std::string& steps) {
  try {
    played(steps);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ExploreScript, readsSizeAndSteps) {
  const ExploreScript script =
      exploreScriptFromJsonText(R"({"size": [640, 360], "steps": [{"walk": {"forward": 1}}, {"turn": 3}]})", "s");
  EXPECT_EQ(script.width, 640);
  EXPECT_EQ(script.height, 360);
  EXPECT_EQ(script.steps.size(), 2u);
  EXPECT_EQ(exploreScriptFromJsonText(R"({"steps": []})", "s").width, 1280);
}

TEST(ExploreScript, saysWhatIsWrongAndWhere) {
  EXPECT_THAT(errorOf("{}"), HasSubstr("\"steps\" is missing"));
  EXPECT_THAT(errorOf(R"({"steps": [], "speed": 3})"), HasSubstr("\"speed\" is unknown"));
  EXPECT_THAT(errorOf(R"({"size": [640.5, 360], "steps": []})"), HasSubstr("two whole numbers"));
  EXPECT_THAT(errorOf(R"({"size": [10, 360], "steps": []})"), HasSubstr("\"size\""));
  EXPECT_THAT(errorOfStep("{}"), HasSubstr("a step has one of the fields walk, turn"));
  EXPECT_THAT(errorOfStep(R"({"turn": 3}, {"fly": 4})"), HasSubstr("\"steps\" 2"));
  EXPECT_THAT(errorOfStep(R"({"turn": 3, "look": 4})"), HasSubstr("\"look\" is unknown"));
  EXPECT_THAT(errorOfStep(R"({"walk": {"fast": 4}})"), HasSubstr("\"fast\""));
  EXPECT_THAT(errorOfStep(R"({"choose": "telescope"})"), HasSubstr("pinhole"));
  EXPECT_THAT(errorOfStep(R"({"save": "a.jpg"})"), HasSubstr("ends in .png"));
  EXPECT_THAT(errorOfStep(R"({"seconds": -1})"), HasSubstr("\"seconds\""));
  EXPECT_THAT(errorOfStep(R"({"go": {"to": [1, 2]}})"), HasSubstr("\"to\""));
  EXPECT_THAT(errorOfStep(R"({"wait": "idle"})"), HasSubstr("rest"));
}

TEST(ExploreScript, theSchemaHasEveryStep) {
  const nlohmann::json schema = readJsonFile(OCELLI_EXPLORE_SCRIPT_SCHEMA);
  std::set<std::string> described;
  for (const auto& [name, property] : schema.at("$defs").at("step").at("properties").items()) {
    described.insert(name);
  }
  std::set<std::string> known;
  for (const ExploreStepKind& kind : exploreStepKinds().rows()) {
    known.insert(kind.name);
  }
  EXPECT_EQ(described, known);
  std::vector<std::string> constructors;
  for (const LiveConstructorRow& row : liveConstructors()) {
    constructors.emplace_back(row.name);
  }
  EXPECT_EQ(schema.at("$defs").at("step").at("properties").at("choose").at("enum").get<std::vector<std::string>>(),
            constructors);
}

TEST(ExploreScript, examplesAreRead) {
  size_t count = 0;
  for (const auto& file : std::filesystem::directory_iterator(OCELLI_EXPLORE_EXAMPLES)) {
    EXPECT_GT(readExploreScript(file.path()).steps.size(), 0u) << file.path();
    ++count;
  }
  EXPECT_GT(count, 0u);
}

TEST(ExploreScript, walksAndTurnsExactlySoFar) {
  ExploreScene scene(test::hall());
  class Session final : public ExploreSession {
   public:
    explicit Session(ExploreScene& scene) : explorer_(scene) {}
    Explorer& explorer() override { return explorer_; }
    void showFrame(const WalkInput& input) override { explorer_.advance(input, 1 / kExploreFramesPerSecond); }
    Image<Rgb8> picture() override { return {}; }
    void startRecording(const std::filesystem::path&) override {}
    void stopRecording() override {}

   private:
    Explorer explorer_;
  };
  Session session(scene);
  play(exploreScriptFromJsonText(R"({"steps": [{"go": {"to": [1, 1.6, 4], "heading": 0}}, {"walk": {"forward": 3.3}},
                                     {"turn": 77}, {"look": -12}, {"walk": {"right": -0.5, "fast": true}}]})",
                                 "s"),
       session);
  const WalkerView& view = session.explorer().walker().view();
  EXPECT_NEAR(view.headingDegrees, 77, 1e-9);
  EXPECT_NEAR(view.pitchDegrees, -12, 1e-9);
  const double turned = 77 * 3.14159265358979 / 180;
  EXPECT_NEAR(view.eye.x, 1 - 0.5 * std::cos(turned), 1e-6);
  EXPECT_NEAR(view.eye.z, 4 - 3.3 - 0.5 * std::sin(turned), 1e-6);
}

TEST(ExploreScript, errorsOfStepsNameTheStep) {
  EXPECT_THAT(playError(R"({"turn": 5}, {"pick": [5, 5]})"),
              AllOf(HasSubstr("\"steps\" 2"), HasSubstr("nothing to pick"), HasSubstr("takes clicks")));
  EXPECT_THAT(playError(R"({"expect": "rays bend"})"), HasSubstr("the state \"rays bend\" is expected"));
  EXPECT_THAT(playError(R"({"option": {"name": "shadow", "value": 1}})"), HasSubstr("has no option \"shadow\""));
  EXPECT_THAT(playError(R"({"stop_recording": true})"), HasSubstr("no video"));
  EXPECT_THAT(playError(R"({"record": "a.mp4"})"), HasSubstr("not recorded here"));
  EXPECT_THAT(playError(R"({"camera": "nothing.json"})"), HasSubstr("nothing.json"));
  EXPECT_THAT(playError(R"({"key": "H"})"), HasSubstr("window"));
  EXPECT_THAT(playError(R"({"walk": {"forward": 10000}})"), HasSubstr("minutes"));
  EXPECT_THAT(playError(R"({"save": "/tmp/a.png"})"), HasSubstr("no file in the folder"));
  EXPECT_THAT(playError(R"({"save_camera": "../a.json"})"), HasSubstr("no file in the folder"));
}

TEST(ExploreScript, savesImagesCamerasAndFrames) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "explore_script_test";
  std::filesystem::remove_all(folder);
  ExploreOffscreenOptions options;
  options.folder = folder;
  int frames = 0;
  bool finished = false;
  options.record = [&](const std::filesystem::path&, int width, int height) {
    EXPECT_EQ(width, 160);
    EXPECT_EQ(height, 90);
    return ExploreRecording{[&](const Image<Rgb8>&) { ++frames; }, [&] { finished = true; }};
  };
  std::vector<std::string> wrote;
  options.wrote = [&](const std::filesystem::path& path) { wrote.push_back(path.filename().string()); };
  played(R"({"go": {"to": [5, 1.6, 0.5], "heading": -55}}, {"choose": "portal"}, {"wait": "rest"},
            {"save": "here/a.png"}, {"save_camera": "c.json"}, {"record": "w.mp4"}, {"seconds": 0.5},
            {"stop_recording": true}, {"camera": ")" +
             (folder / "c.json").string() + R"("}, {"wait": "rest"}, {"save": "b.png"})",
         options);
  EXPECT_EQ(frames, 15);
  EXPECT_TRUE(finished);
  EXPECT_EQ(wrote, (std::vector<std::string>{"a.png", "c.json", "w.mp4", "b.png"}));
  EXPECT_EQ(readPng(folder / "here/a.png"), readPng(folder / "b.png")) << "the camera that was saved shows the same";
}

}  // namespace
}  // namespace ocelli
