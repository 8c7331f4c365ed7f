// The effect pane in the viewer, driven as a person would.
#include "display_sim/viewer/effect_pane.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/effect_overlays.h"
#include "oc_core/base/error.h"
#include "tests/viewer/small_effect.h"
#include "tests/viewer/test_viewer.h"

namespace ocelli {
namespace {

using test::countDifferent;
using test::TestViewer;
using testing::HasSubstr;

class EffectPaneTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, EffectPaneTest, kOffscreenProviders, providerName);

/// The small scene, with its mirror: the pane is on, and drawn.
class MirrorViewer : public TestViewer {
 public:
  explicit MirrorViewer(GlProvider provider) : TestViewer(provider, test::kSmallScene) {
    player.play(DropStep{folder.write("mirror.roles.json", test::kMirrorRoles).string()});
    settle();
  }
  const EffectStatus& status() const { return viewer.facts().effect; }
  Image<Rgb8> expected(const std::string& way) const { return test::shadedPicture(status().picture->wanted, way); }
};

TEST_P(EffectPaneTest, isOffWhereNothingHasRolesAndSaysSoWhereItIsTurnedOn) {
  TestViewer test(GetParam());
  EXPECT_FALSE(test.viewer.state().effect.on);
  EXPECT_EQ(viewerLayout(test.viewer.state(), {960, 640}, 1).find(Pane::kEffect), nullptr);
  const Image<Rgb8> before = test.viewer.screenshot();
  test.key(Key::k5);
  test.settle();
  EXPECT_GT(countDifferent(before, test.viewer.screenshot()), 10000U);
  const EffectStatus& status = test.viewer.facts().effect;
  EXPECT_THAT(status.error, HasSubstr("--roles"));
  EXPECT_THAT(effectNotes(test.viewer.state(), status, false).front(), HasSubstr("--roles"));
  EXPECT_FALSE(test.viewer.isMoving());
  EXPECT_THROW(test.viewer.effectPicture(), InputError);
  test.key(Key::kO);
  test.settle();
  EXPECT_FALSE(test.viewer.state().effect.on);
  EXPECT_EQ(test.viewer.facts().effect.error, "");
}

TEST_P(EffectPaneTest, showsABuiltInMirrorByItselfAndFromItsView) {
  TestViewer test(GetParam(), "builtin:mirror");
  const EffectStatus& status = test.viewer.facts().effect;
  ASSERT_TRUE(status.picture) << status.error;
  EXPECT_TRUE(test.viewer.state().effect.on);
  EXPECT_EQ(test.viewer.state().effect.effect, "reflection");
  EXPECT_EQ(status.picture->wanted.way, "ddoc");
  EXPECT_EQ(test.viewer.state().reconstruction.view, *status.home);
  EXPECT_EQ(test.viewer.effectPicture(), test::shadedPicture(status.picture->wanted, "ddoc"));
  // Home brings the eye back to where each pane has it.
  test.key(Key::k3);
  test.key(Key::kHome);
  EXPECT_EQ(test.viewer.state().reconstruction.view, View{});
  test.key(Key::k5);
  test.key(Key::kHome);
  EXPECT_EQ(test.viewer.state().reconstruction.view, *status.home);
}

TEST_P(EffectPaneTest, theWindowShowsThePictureToTheByte) {
  MirrorViewer test(GetParam());
  test.key(Key::k5);
  test.settle();
  const Image<Rgb8>& picture = test.viewer.effectPicture();
  const Image<Rgb8> pane = test.paneImage(Pane::kEffect);
  const auto place = picturePlace(test.viewer.state(), {pane.width(), pane.height()});
  ASSERT_EQ(place.size, glm::ivec2(picture.width(), picture.height()));
  // Texts stand over its upper part, buttons over its lower one.
  size_t different = 0;
  for (int y = picture.height() / 3; y < picture.height() * 3 / 4; ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      different += pane(place.corner.x + x, place.corner.y + y) != picture(x, y);
    }
  }
  EXPECT_EQ(different, 0U);
}

TEST_P(EffectPaneTest, keysSwitchBetweenTheWayTheTracedPictureAndTheirDifference) {
  MirrorViewer test(GetParam());
  const Image<Rgb8> byWay = test.expected("ddoc");
  const Image<Rgb8> traced = test.expected("traced");
  EXPECT_EQ(test.viewer.effectPicture(), byWay);
  test.key(Key::kK);
  EXPECT_EQ(test.viewer.effectPicture(), traced);
  test.key(Key::kK, {.shift = true});
  EXPECT_EQ(test.viewer.effectPicture(), differenceOf(byWay, traced).heat);
  test.key(Key::kK, {.shift = true});
  EXPECT_EQ(test.viewer.effectPicture(), byWay);
  test.key(Key::kU);
  test.settle();
  EXPECT_NE(test.status().picture->wanted.way, "ddoc");
  EXPECT_EQ(test.viewer.effectPicture(), test.expected(test.status().picture->wanted.way));
  test.key(Key::kU, {.shift = true});
  test.settle();
  EXPECT_EQ(test.viewer.effectPicture(), byWay);
}

TEST_P(EffectPaneTest, buttonsSwitchToo) {
  MirrorViewer test(GetParam());
  test.key(Key::k5);
  test.player.play(SecondsStep{6});  // until the message of the file that was dropped has gone
  test.settle();
  const WindowRect image = test.layoutOf(Pane::kEffect).image;
  const auto buttonAt = [&](double fromRight) { return glm::dvec2(image.right() - fromRight, image.bottom() - 18); };
  test.player.play(ClickStep{buttonAt(40)});
  EXPECT_EQ(test.viewer.state().effect.content, EffectShown::Content::kDifference);
  test.player.play(ClickStep{buttonAt(115)});
  EXPECT_EQ(test.viewer.state().effect.content, EffectShown::Content::kByTracing);
}

TEST_P(EffectPaneTest, theEyeIsThatOfTheReconstruction) {
  MirrorViewer test(GetParam());
  test.key(Key::k5);
  test.settle();
  const View before = test.viewer.state().reconstruction.view;
  const auto middle = test.at(Pane::kEffect, 300, 250);
  test.player.play(DragStep{middle, middle + glm::dvec2(40, 10)});
  test.settle();
  EXPECT_NE(test.viewer.state().reconstruction.view, before);
  EXPECT_EQ(test.status().picture->wanted.view, test.viewer.state().reconstruction.view);
  EXPECT_EQ(test.viewer.effectPicture(), test.expected("ddoc"));
}

TEST_P(EffectPaneTest, aWindowThatIsResizedHasAPictureOfItsSize) {
  MirrorViewer test(GetParam());
  for (const glm::ivec2 size : {glm::ivec2(640, 400), glm::ivec2(64, 64), glm::ivec2(1300, 700)}) {
    test.player.play(ResizeStep{size.x, size.y, 1});
    test.settle();
    EXPECT_EQ(test.viewer.effectPicture(), test.expected("ddoc")) << size.x;
  }
}

TEST_P(EffectPaneTest, anotherSceneHasItsOwnAndABrokenOneLeavesIt) {
  MirrorViewer test(GetParam());
  test.key(Key::kK);
  test.player.play(OpenStep{"no-such-file.obj"});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  EXPECT_EQ(test.viewer.effectPicture(), test.expected("traced"));
  test.key(Key::kEscape);
  test.player.play(OpenStep{"builtin:fence"});
  test.settle();
  EXPECT_FALSE(test.viewer.state().effect.on);
  EXPECT_FALSE(test.status().picture);
}

TEST_P(EffectPaneTest, theEffectOfANewSceneIsItsOwn) {
  TestViewer test(GetParam(), "builtin:lens");
  EXPECT_EQ(test.viewer.state().effect.effect, "refraction");
  const View eye = test.viewer.state().reconstruction.view;
  test.player.play(OpenStep{"builtin:mirror"});
  test.settle();
  EXPECT_EQ(test.viewer.state().effect.effect, "reflection");
  EXPECT_TRUE(test.viewer.facts().effect.picture) << test.viewer.facts().effect.error;
  EXPECT_EQ(test.viewer.state().reconstruction.view, eye);  // views stay
}

TEST_P(EffectPaneTest, figuresAreInWords) {
  MirrorViewer test(GetParam());
  const std::vector<std::string> notes = effectNotes(test.viewer.state(), test.status(), false);
  EXPECT_THAT(notes.front(), HasSubstr("by ddoc: "));
  EXPECT_THAT(notes.front(), HasSubstr("% of pixels differ"));
  EXPECT_THAT(notes.front(), HasSubstr("PSNR"));
  EXPECT_EQ(notes.back(), "by ddoc");
  EXPECT_THAT(effectNotes(test.viewer.state(), test.status(), true).front(), HasSubstr(" ms: "));
  EXPECT_THAT(effectDetail(test.viewer.state(), test.status()), HasSubstr("reflection, by ddoc, "));
  EffectStatus building;
  building.busy = true;
  building.stage = "building tiles";
  building.fraction = 0.4;
  EXPECT_EQ(effectNotes(test.viewer.state(), building, false).front(),
            "in the making: for \"ddoc\": building tiles 40 %");
}

TEST_P(EffectPaneTest, aScriptChoosesShowsAndSaves) {
  MirrorViewer test(GetParam());
  test.player.play(viewerScriptFromJsonText(
      R"({"size": [960, 640], "steps": [{"effect": {"name": "reflection", "by": "environment"}},
          {"save_effect": "way.png"}, {"show": "traced"}, {"save_effect": "traced.png"}, {"show": "difference"},
          {"save_effect": "difference.png"}]})",
      "script"));
  const Image<Rgb8> way = readPng(test.folder / "way.png");
  const Image<Rgb8> traced = readPng(test.folder / "traced.png");
  EXPECT_EQ(way, test.expected("environment"));
  EXPECT_EQ(traced, test.expected("traced"));
  EXPECT_EQ(readPng(test.folder / "difference.png"), differenceOf(way, traced).heat);
  // What does not exist is told in the window, as everything is.
  test.player.play(EffectStep{"relefction", ""});
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("relefction"));
  test.player.play(EffectStep{"refraction", ""});
  EXPECT_THROW(test.player.play(SaveEffectStep{"none.png"}), InputError);
}

TEST_P(EffectPaneTest, aViewerClosesWhileThePaneIsBeingBuilt) {
  for (int frames = 0; frames < 6; ++frames) {
    MirrorViewer test(GetParam());
    test.player.play(EffectStep{"reflection", "cell"});
    for (int i = 0; i < frames; ++i) {
      test.key(Key::kRight);
    }
  }
}

}  // namespace
}  // namespace ocelli
