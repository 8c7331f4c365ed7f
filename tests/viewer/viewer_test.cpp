// The whole viewer, driven as a person would.
#include "display_sim/viewer/viewer.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/viewer_run.h"
#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "tests/viewer/test_viewer.h"

namespace ocelli {
namespace {

using test::countDifferent;
using test::TestViewer;
using testing::HasSubstr;

class ViewerTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, ViewerTest, kOffscreenProviders, providerName);

size_t filesIn(const test::TemporaryFolder& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

TEST_P(ViewerTest, aBrokenFileIsAMessageAndTheOldSceneStays) {
  TestViewer test(GetParam());
  const std::string broken = test.folder.write("broken.ply", "ply\nformat ascii 1.0\nelement vertex 1e9\n").string();
  const Image<Rgb8> before = test.paneImage(Pane::kReference);
  test.player.play(DropStep{broken});
  test.settle();
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("broken.ply"));
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  EXPECT_EQ(test.viewer.state().work.source, "builtin:room");
  EXPECT_EQ(countDifferent(before, test.paneImage(Pane::kReference)), 0U);
  // It still works: another camera, then another file.
  test.key(Key::kEscape);
  EXPECT_EQ(test.viewer.facts().message, "");
  test.key(Key::kC);
  test.settle();
  EXPECT_GT(countDifferent(before, test.paneImage(Pane::kReference)), 100U);
  test.player.play(OpenStep{"builtin:fence"});
  test.settle();
  EXPECT_EQ(test.viewer.facts().data->scene->source, "builtin:fence");
  EXPECT_FALSE(test.viewer.facts().messageIsError);
}

TEST_P(ViewerTest, theWidthOfPointsIsThatOfTheSceneWithWhichItWasGiven) {
  const test::TemporaryFolder folder;
  const std::string points = folder.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n").string();
  SceneOptions options;
  options.points.width = 0.25;
  TestViewer test(GetParam(), points, "di", options);
  test.player.play(DropStep{folder.write("broken.ply", "ply\n").string()});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  EXPECT_EQ(test.viewer.state().work.source, points);
  EXPECT_EQ(test.viewer.state().work.sceneOptions.points.width, 0.25) << "of what stays";
  test.key(Key::kEscape);
  test.player.play(OpenStep{"builtin:fence"});
  test.settle();
  EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  EXPECT_EQ(test.viewer.facts().data->scene->source, "builtin:fence");
}

TEST_P(ViewerTest, brokenViewsAndCamerasAreMessagesToo) {
  TestViewer test(GetParam());
  for (const char* text : {"{\"eye\": [0, 0]}", "{\"camera\": \"none\"}", "not JSON", "[]"}) {
    test.player.play(DropStep{test.folder.write("broken.json", text).string()});
    EXPECT_TRUE(test.viewer.facts().messageIsError) << text;
    test.key(Key::kEscape);
  }
  test.player.play(CameraStep{"no-such-camera"});
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("no-such-camera"));
}

TEST_P(ViewerTest, aCameraThatCannotBeBuiltIsAMessage) {
  TestViewer test(GetParam(), "builtin:teapot");
  const std::string inside =
      test.folder.write("inside.json", R"({"eye": [0, 0, 0.05], "fov_vertical_degrees": 50})").string();
  test.player.play(DropStep{inside});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  EXPECT_FALSE(test.viewer.facts().data->camera);
  EXPECT_FALSE(test.viewer.facts().missing.has_value());
}

TEST_P(ViewerTest, aFirstSceneThatIsNoneEndsIt) {
  try {
    TestViewer test(GetParam(), "no-such-file.obj");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no-such-file.obj"));
  }
}

TEST_P(ViewerTest, theKeyboardReachesEverything) {
  TestViewer test(GetParam());
  std::vector<Image<Rgb8>> seen{test.viewer.screenshot()};
  const auto expectChange = [&](const char* what) {
    seen.push_back(test.viewer.screenshot());
    EXPECT_GT(countDifferent(seen[seen.size() - 1], seen[seen.size() - 2]), 30U) << what;
  };
  test.key(Key::kSpace);  // the display holds still from here on
  seen.back() = test.viewer.screenshot();
  const std::vector<std::pair<Key, const char*>> keys{{Key::k1, "the scene alone"},
                                                      {Key::kLeft, "turned"},
                                                      {Key::kEqual, "nearer"},
                                                      {Key::kV, "close by"},
                                                      {Key::kT, "straight rays"},
                                                      {Key::kD, "samples"},
                                                      {Key::kHome, "back"},
                                                      {Key::k2, "reference image"},
                                                      {Key::kQ, "depth"},
                                                      {Key::kEqual, "zoomed"},
                                                      {Key::kRight, "moved"},
                                                      {Key::k3, "reconstruction"},
                                                      {Key::kUp, "turned up"},
                                                      {Key::kMinus, "farther"},
                                                      {Key::kM, "plain"},
                                                      {Key::k4, "display"},
                                                      {Key::kDown, "turned down"},
                                                      {Key::kPageUp, "nearer"},
                                                      {Key::kL, "observer is the eye"},
                                                      {Key::k0, "all"},
                                                      {Key::kG, "no panel"},
                                                      {Key::kG, "panel"},
                                                      {Key::kH, "help"},
                                                      {Key::kEscape, "no help"},
                                                      {Key::kTab, "next pane"},
                                                      {Key::kW, "wider cell"}};
  for (const auto& [key, what] : keys) {
    test.key(key);
    test.settle();
    expectChange(what);
  }
  for (const Key key : {Key::kC, Key::kP, Key::kZ, Key::kE}) {
    test.key(key);
    test.settle();
    expectChange("work");
    EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  }
  test.key(Key::kQ, {.control = true});
  EXPECT_TRUE(test.viewer.wantsClose());
}

TEST_P(ViewerTest, thePanelIsReachedAndLeftByKeys) {
  TestViewer test(GetParam());
  test.key(Key::kF6);
  test.key(Key::kM);  // the panel has the keys now
  EXPECT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kMarked);
  test.key(Key::kEscape);
  test.key(Key::kM);
  EXPECT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kPlain);
}

TEST_P(ViewerTest, thePanelTakesClicks) {
  TestViewer test(GetParam());
  const Image<Rgb8> before = test.viewer.screenshot();
  test.player.play(ClickStep{{150, 113}});  // the list of cameras opens
  EXPECT_GT(countDifferent(before, test.viewer.screenshot()), 5000U);
  test.player.play(ClickStep{{60, 160}});  // one of its first entries
  test.settle();
  EXPECT_NE(test.viewer.state().work.camera.name, "ddoc");
  // A click into a pane is not the panel's.
  test.player.play(ClickStep{test.at(Pane::kDisplay, 50, 50)});
  EXPECT_EQ(test.viewer.state().active, Pane::kDisplay);
}

TEST_P(ViewerTest, aSceneIsTypedIntoThePanel) {
  TestViewer test(GetParam());
  test.player.play(ClickStep{{150, 42}});
  test.key(Key::kA, {.control = true});
  test.player.play(TypeStep{"builtin:fence"});
  EXPECT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kMarked);  // letters are no keys
  test.key(Key::kEnter);
  test.settle();
  EXPECT_EQ(test.viewer.facts().data->scene->source, "builtin:fence");
  test.key(Key::kM);
  EXPECT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kPlain);
}

TEST_P(ViewerTest, dragsAndWheelMoveThePaneUnderThePointer) {
  TestViewer test(GetParam());
  const ViewerState before = test.viewer.state();
  const auto from = test.at(Pane::kScene, 50, 50);
  test.player.play(DragStep{from, from + glm::dvec2(30, 10)});
  EXPECT_NE(test.viewer.state().scene.view, before.scene.view);
  EXPECT_EQ(test.viewer.state().scene.view.target, before.scene.view.target);
  EXPECT_EQ(test.viewer.state().active, Pane::kScene);
  test.player.play(DragStep{from, from + glm::dvec2(30, 10), PointerButton::kRight});
  EXPECT_NE(test.viewer.state().scene.view.target, before.scene.view.target);
  test.player.play(ScrollStep{test.at(Pane::kReconstruction, 90, 90), 3});
  EXPECT_LT(glm::length(test.viewer.state().reconstruction.view.eye), glm::length(before.reconstruction.view.eye));
  // In the image the wheel zooms, and a drag moves it.
  const auto middle = test.at(Pane::kReference, 100, 120);
  test.player.play(ScrollStep{middle, 5});
  EXPECT_GT(test.viewer.state().reference.zoom, 1.5);
  const glm::vec2 center = test.viewer.state().reference.center;
  test.player.play(DragStep{middle, middle + glm::dvec2(20, 0)});
  EXPECT_LT(test.viewer.state().reference.center.x, center.x);
  // The panel is no pane.
  const ViewerState after = test.viewer.state();
  test.player.play(DragStep{{5, 600}, {60, 500}});
  EXPECT_EQ(test.viewer.state().scene.view, after.scene.view);
}

TEST_P(ViewerTest, aImageOfTheWindowIsSavedUnderANewName) {
  TestViewer test(GetParam());
  test.folder.write("ocelli-001.png", "mine");
  test.key(Key::kSpace);
  test.key(Key::kS);
  const Image<Rgb8> saved = readPng(test.folder / "ocelli-002.png");
  EXPECT_EQ(saved.width(), TestViewer::kWidth);
  EXPECT_EQ(saved.height(), TestViewer::kHeight);
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("ocelli-002.png"));
  EXPECT_EQ(test::fileBytes(test.folder / "ocelli-001.png"), "mine");
}

TEST_P(ViewerTest, aSavedViewIsWhatViewTakesAndWhatADropOpens) {
  TestViewer test(GetParam());
  test.key(Key::kRight);
  test.key(Key::kUp);
  const View eye = test.viewer.state().reconstruction.view;
  test.key(Key::kJ);
  const std::filesystem::path path = test.folder / "ocelli-view-001.json";
  const View read = readView(path);
  EXPECT_EQ(read.eye, eye.eye);
  EXPECT_EQ(read.target, eye.target);
  EXPECT_NEAR(read.fovVerticalDegrees, eye.resolvedFovVerticalDegrees(), 1e-9);
  test.key(Key::kHome);
  test.player.play(DropStep{path.string()});
  test.settle();
  EXPECT_EQ(test.viewer.state().work.reference.eye, eye.eye);
  EXPECT_EQ(test.viewer.state().reconstruction.view.eye, eye.eye);
  EXPECT_LT(test.viewer.facts().missing->strictRatio(), 0.02);  // the eye is at the reference view
}

TEST_P(ViewerTest, aFolderThatCannotBeWrittenIsAMessage) {
  TestViewer test(GetParam());
  std::filesystem::remove_all(test.folder.path());
  test.key(Key::kJ);
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  std::filesystem::create_directory(test.folder.path());
}

TEST_P(ViewerTest, nothingIsRememberedUnlessAsked) {
  TestViewer test(GetParam());
  test.key(Key::kC);
  test.settle();
  EXPECT_EQ(filesIn(test.folder), 0U);
}

TEST_P(ViewerTest, aDenseScreenShowsTheSameLarger) {
  TestViewer test(GetParam());
  test.player.play(ResizeStep{2 * TestViewer::kWidth, 2 * TestViewer::kHeight, 2});
  const ViewerLayout once = viewerLayout(test.viewer.state(), {TestViewer::kWidth, TestViewer::kHeight}, 1);
  const ViewerLayout twice = viewerLayout(test.viewer.state(), {2 * TestViewer::kWidth, 2 * TestViewer::kHeight}, 2);
  for (size_t i = 0; i < once.panes.size(); ++i) {
    EXPECT_NEAR(twice.panes[i].image.width, 2 * once.panes[i].image.width, 2);
    EXPECT_NEAR(twice.panes[i].header.height, 2 * once.panes[i].header.height, 1);
  }
  EXPECT_EQ(test.viewer.screenshot().width(), 2 * TestViewer::kWidth);
}

TEST_P(ViewerTest, aTinyWindowIsNoError) {
  TestViewer test(GetParam());
  test.player.play(ResizeStep{64, 64, 4});
  test.key(Key::kH);
  test.player.play(ResizeStep{TestViewer::kWidth, TestViewer::kHeight, 1});
  EXPECT_EQ(test.viewer.screenshot().width(), TestViewer::kWidth);
}

TEST_P(ViewerTest, aUnionShowsEachOfItsImages) {
  TestViewer test(GetParam(), "builtin:boxes", "eoc-hv+ddoc");
  ASSERT_EQ(test.viewer.facts().data->camera->representation.images.size(), 3U);
  for (const int image : {1, 2, 0}) {
    test.key(Key::kI);
    EXPECT_EQ(test.viewer.state().reference.image, image);
  }
}

TEST_P(ViewerTest, everyCameraIsShownWithoutAnError) {
  TestViewer test(GetParam(), "builtin:boxes", "di");
  do {
    test.key(Key::kC);
    test.settle();
    EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
    EXPECT_TRUE(test.viewer.facts().data->rays) << test.viewer.state().work.camera.name;
  } while (test.viewer.state().work.camera.name != "di");
}

TEST_P(ViewerTest, aMeasurementThatIsHiddenHoldsNothingUp) {
  TestViewer test(GetParam(), "builtin:teapot");
  EXPECT_TRUE(test.viewer.facts().missing.has_value());
  const ViewerScript script = viewerScriptFromJsonText(
      R"({"size": [960, 640], "steps": [{"wait": "idle"}, {"key": "3"}, {"scroll": {"at": [700, 300], "up": 3}},
          {"key": "2"}, {"save": "x.png"}, {"wait": "idle"}]})",
      "script");
  test.player.play(script);
  EXPECT_TRUE(std::filesystem::exists(test.folder / "x.png"));
  EXPECT_FALSE(test.viewer.isSettling());
  EXPECT_FALSE(test.viewer.facts().missing.has_value());  // of an eye that has moved since
  test.key(Key::k3);
  test.settle();
  EXPECT_TRUE(test.viewer.facts().missing.has_value());
}

TEST_P(ViewerTest, aHiddenReconstructionTellsNothingOfAnotherCamera) {
  TestViewer test(GetParam());
  test.key(Key::k2);
  test.settle();
  EXPECT_TRUE(test.viewer.facts().missing.has_value());  // still known
  test.player.play(CameraStep{"di"});
  test.settle();
  EXPECT_FALSE(test.viewer.facts().missing.has_value());
}

thread_local int errorsToReport = 0;

GLenum GLAD_API_PTR reportOutOfMemory() {
  return errorsToReport-- > 0 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

GLenum GLAD_API_PTR reportReset() {
  return GL_INNOCENT_CONTEXT_RESET;
}

TEST_P(ViewerTest, aPaneThatCannotBeDrawnSaysSoAndTheOthersGoOn) {
  TestViewer test(GetParam());
  const auto& failures = test.viewer.facts().failures;
  test.context->functions().GetError = reportOutOfMemory;
  errorsToReport = 1;
  test.player.play(ResizeStep{900, 600, 1});  // panes of another size; the scene's is the first
  EXPECT_THAT(failures[0], HasSubstr("not enough memory"));
  test.key(Key::kM);
  test.settle();
  EXPECT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kPlain);
  EXPECT_THAT(failures[0], HasSubstr("not enough memory"));  // it was not drawn since
  for (const size_t other : {1U, 2U, 3U}) {
    EXPECT_EQ(failures[other], "");
  }
  test.player.play(ResizeStep{TestViewer::kWidth, TestViewer::kHeight, 1});
  EXPECT_EQ(failures[0], "");
}

TEST_P(ViewerTest, aMeasurementThatFailsIsNotTriedForEver) {
  TestViewer test(GetParam());
  const auto showFrame = [&] {
    test.viewer.update(0);
    test.viewer.draw();
  };
  test.key(Key::k3);
  test.context->functions().GetError = reportOutOfMemory;
  test.viewer.handle(KeyEvent{Key::kRight, true, {}});
  showFrame();
  EXPECT_TRUE(test.viewer.isSettling());
  errorsToReport = 1;
  showFrame();
  EXPECT_THAT(test.viewer.facts().failures[2], HasSubstr("not enough memory"));
  EXPECT_FALSE(test.viewer.isSettling());
  test.key(Key::kLeft);
  EXPECT_EQ(test.viewer.facts().failures[2], "");
}

TEST_P(ViewerTest, aLostContextEndsIt) {
  TestViewer test(GetParam());
  test.context->functions().GetGraphicsResetStatus = reportReset;
  EXPECT_THROW(test.key(Key::kRight), GlError);
}

TEST_P(ViewerTest, aWindowRestsWhereNothingThatShowsChanges) {
  TestViewer test(GetParam());
  ASSERT_TRUE(test.viewer.state().display.running);
  EXPECT_FALSE(test.viewer.isMoving());  // at full speed the display is one steady image
  for (int i = 0; i < 6; ++i) {
    test.key(Key::kComma);
  }
  test.settle();
  EXPECT_TRUE(test.viewer.isMoving());
  test.key(Key::k1);
  test.settle();
  EXPECT_FALSE(test.viewer.isMoving());
  test.key(Key::k4);
  EXPECT_TRUE(test.viewer.isMoving());
  test.key(Key::kSpace);
  EXPECT_FALSE(test.viewer.isMoving());
}

TEST_P(ViewerTest, aCameraWithoutAnImageSaysSo) {
  TestViewer test(GetParam(), "builtin:teapot", "geometry");
  ASSERT_TRUE(test.viewer.facts().data->camera);
  const Image<Rgb8> image = test.paneImage(Pane::kReference);
  EXPECT_GT(countDifferent(image, Image<Rgb8>(image.width(), image.height(), image(image.width() - 1, 0))), 300U);
}

TEST_P(ViewerTest, valuesOfThePanelChangeByKeys) {
  TestViewer test(GetParam());
  test.key(Key::kF6);
  test.key(Key::kDown);   // the scene
  test.key(Key::kDown);   // the list of cameras
  test.key(Key::kSpace);  // opens
  test.key(Key::kDown);
  test.key(Key::kSpace);
  EXPECT_NE(test.viewer.state().work.camera.name, "ddoc");
}

TEST_P(ViewerTest, stepsAfterTheViewerHasClosedAreAnError) {
  TestViewer test(GetParam());
  const auto script = [](const std::string& steps) {
    return viewerScriptFromJsonText(R"({"size": [960, 640], "steps": [)" + steps + "]}", "script");
  };
  try {
    test.player.play(script(R"({"key": "H"}, {"key": "Ctrl+Q"}, {"save": "after.png"}, {"key": "H"})"));
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 2 closed the viewer; 2 steps are left"));
  }
  TestViewer last(GetParam());
  EXPECT_NO_THROW(last.player.play(script(R"({"key": "Ctrl+Q"})")));
}

TEST(ViewerScripts, theSameScriptGivesTheSameBytesOnEglAndOsMesa) {
  const ViewerScript script = viewerScriptFromJsonText(
      R"({"size": [960, 640], "steps": [{"wait": "idle"}, {"save": "1.png"}, {"key": "Comma"}, {"key": "Comma"},
          {"key": "Comma"}, {"seconds": 0.3}, {"drag": {"from": [400, 500], "to": [450, 480]}}, {"save": "2.png"},
          {"camera": "eoc-h"}, {"key": "Q"}, {"wait": "idle"}, {"save": "3.png"}, {"key": "H"}, {"save": "4.png"}]})",
      "script");
  std::vector<std::string> bytes;
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa, GlProvider::kOsMesa}) {
    const test::TemporaryFolder folder;
    const auto context = openTestContext(provider);
    ViewerOptions options;
    options.source = "builtin:room";
    options.camera = cameraChoice("ddoc");
    options.width = 180;
    options.height = 120;
    options.profile = "test";
    options.folder = folder.path();
    size_t saved = 0;
    runViewerScript(*context, options, script, [&](const std::string&) { ++saved; });
    EXPECT_EQ(saved, 4U);
    std::string all;
    for (const char* name : {"1.png", "2.png", "3.png", "4.png"}) {
      all += test::fileBytes(folder / name);
    }
    bytes.push_back(all);
    EXPECT_EQ(context->liveObjects(), 0);
  }
  EXPECT_TRUE(bytes[1] == bytes[2]);
  EXPECT_TRUE(bytes[0] == bytes[1]);
}

}  // namespace
}  // namespace ocelli
