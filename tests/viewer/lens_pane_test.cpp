// The lens pane in the viewer, driven as a person would.
#include "display_sim/viewer/lens_pane.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/lens_choice.h"
#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"
#include "tests/viewer/test_viewer.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::countDifferent;
using test::countNear;
using test::TestViewer;
using testing::HasSubstr;

constexpr const char* kTwoLensFile =
    R"({"camera": "gpc", "regions": [{"center": [0.25, 0.5], "extent": [0.15, 0.2], "zoom": 3, "transition_width": 0.6},
                                     {"center": [0.75, 0.5], "extent": [0.15, 0.2], "zoom": 5, "transition_width": 0.6}]})";

class LensPaneTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, LensPaneTest, kOffscreenProviders, providerName);

/// Two lenses, in their pane alone.
class LensViewer : public TestViewer {
 public:
  explicit LensViewer(GlProvider provider) : TestViewer(provider, "builtin:statues,triangles=20000", "gpc") {
    player.play(DropStep{folder.write("two.json", kTwoLensFile).string()});
    key(Key::k6);
    settle();
  }
  glm::dvec2 windowAt(double shareX, double shareY) const {
    const LensPointer::Frame frame = lensFrame(viewer.state(), layoutOf(Pane::kLenses).image, 1);
    return frame.corner + glm::dvec2(shareX, shareY) * frame.size;
  }
  const std::vector<GpcRegion>& lenses() const { return viewer.state().work.camera.gpc.regions; }
  /// What `ocelli render --camera FILE` draws for the user's eye.
  Image<Rgb8> rendered(const std::filesystem::path& cameraFile) const {
    const CameraChoice camera = cameraChoice(cameraFile.string());
    const glm::ivec2 size = viewer.facts().lenses.picture->wanted.size;
    const PinholeCamera reference(viewer.state().reconstruction.view, size.x, size.y);
    return srgbFromLinear(
        buildReferenceImages(camera, reference, loadScene("builtin:statues,triangles=20000")).front().color);
  }
};

TEST_P(LensPaneTest, isThereWhereTheCameraHasLenses) {
  TestViewer test(GetParam(), "builtin:room", "ddoc");
  EXPECT_FALSE(isOffered(test.viewer.state(), Pane::kLenses));
  test.key(Key::k6);
  test.settle();
  EXPECT_EQ(test.viewer.state().work.camera.name, "gpc");
  EXPECT_TRUE(test.viewer.facts().lenses.picture) << test.viewer.facts().lenses.error;
  test.key(Key::kC);
  test.settle();
  EXPECT_THROW(test.viewer.lensPicture(), InputError);
  EXPECT_THROW(test.viewer.lensFile(), InputError);
}

TEST_P(LensPaneTest, aLensThatIsDraggedByAScriptGivesTheBytesOfRenderWithTheSavedFile) {
  LensViewer test(GetParam());
  test.player.play(SaveLensPictureStep{"before.png"});
  test.player.play(DragStep{test.windowAt(0.25, 0.5), test.windowAt(0.4, 0.3)});
  EXPECT_NEAR(test.lenses()[0].center.x, 0.4, 2e-3);
  EXPECT_NEAR(test.lenses()[0].center.y, 0.3, 2e-3);
  test.player.play(ScrollStep{test.windowAt(0.75, 0.5), 2});
  test.player.play(SaveLensPictureStep{"after.png"});
  test.player.play(SaveCameraStep{"after.json"});
  const Image<Rgb8> after = readPng(test.folder.path() / "after.png");
  EXPECT_EQ(after, test.rendered(test.folder.path() / "after.json"));
  EXPECT_GT(countDifferent(after, readPng(test.folder.path() / "before.png")), after.size() / 100);
  test.settle();
  EXPECT_EQ(test.viewer.facts().data->camera->choice.gpc, test.viewer.state().work.camera.gpc)
      << "the other panes have followed";
}

TEST_P(LensPaneTest, lensesStopAtEachOtherAndNothingComplains) {
  LensViewer test(GetParam());
  test.player.play(DragStep{test.windowAt(0.25, 0.5), test.windowAt(0.6, 0.5)});
  // Both reach 0.12 of the width beyond their middles.
  EXPECT_NEAR(test.lenses()[0].center.x, 0.51, 1e-6);
  test.player.play(DragStep{test.windowAt(0.51, 0.5), test.windowAt(0.02, 0.98)});
  EXPECT_NEAR(test.lenses()[0].center.x, 0.12, 1e-6);
  EXPECT_NEAR(test.lenses()[0].center.y, 0.84, 1e-6);
  EXPECT_EQ(test.viewer.facts().message, "camera of " + (test.folder.path() / "two.json").string());
  EXPECT_FALSE(test.viewer.facts().messageIsError);
}

TEST_P(LensPaneTest, theOtherPanesWaitUntilTheLensIsLetGo) {
  LensViewer test(GetParam());
  const uint64_t before = test.viewer.state().work.cameraRevision;
  const glm::dvec2 from = test.windowAt(0.25, 0.5);
  const glm::dvec2 to = test.windowAt(0.3, 0.5);
  test.viewer.handle(PointerMoveEvent{from.x, from.y});
  test.viewer.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  test.viewer.handle(PointerMoveEvent{to.x, to.y});
  test.viewer.update(2 * kLensRestSeconds);
  EXPECT_EQ(test.viewer.state().work.cameraRevision, before) << "it is held";
  test.viewer.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  test.viewer.update(2 * kLensRestSeconds);
  EXPECT_GT(test.viewer.state().work.cameraRevision, before);
}

TEST_P(LensPaneTest, keysDoWhatThePointerDoes) {
  LensViewer test(GetParam());
  test.key(Key::kTab);
  test.key(Key::kTab);
  EXPECT_EQ(test.viewer.state().lenses.chosen, 1U);
  test.key(Key::kLeft);
  EXPECT_LT(test.lenses()[1].center.x, 0.75f);
  test.key(Key::kEqual);
  EXPECT_GT(test.lenses()[1].zoom, 5);
  test.key(Key::kDelete);
  EXPECT_EQ(test.lenses().size(), 1U);
  test.player.play(ClickStep{test.windowAt(0.7, 0.4)});
  EXPECT_EQ(test.lenses().size(), 2U);
  test.key(Key::kL);
  test.key(Key::kDelete);
  EXPECT_EQ(test.lenses().size(), 2U);
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("locked"));
  EXPECT_FALSE(test.viewer.facts().messageIsError);
  test.key(Key::kEscape);
  const View before = test.viewer.state().reconstruction.view;
  test.key(Key::kLeft);
  EXPECT_NE(test.viewer.state().reconstruction.view, before) << "the arrows turn the view again";
}

TEST_P(LensPaneTest, outlinesLieOverThePictureAndNotInIt) {
  LensViewer test(GetParam());
  const Image<Rgb8> picture = test.viewer.lensPicture();
  const size_t without = countNear(test.paneImage(Pane::kLenses), bytesOf(kOkabeItoYellow), 3);
  test.key(Key::kTab);
  test.settle();
  EXPECT_GT(countNear(test.paneImage(Pane::kLenses), bytesOf(kOkabeItoYellow), 3), without + 200);
  EXPECT_EQ(test.viewer.lensPicture(), picture);
  test.key(Key::kR);
  test.settle();
  EXPECT_GT(countDifferent(test.viewer.lensPicture(), picture), picture.size() / 2) << "rates in false colours";
}

TEST_P(LensPaneTest, lensesAreSavedAndLoaded) {
  LensViewer test(GetParam());
  const auto saved = test.viewer.state().work.camera.gpc;
  test.key(Key::kS, {.shift = true});
  const auto path = test.folder.path() / "ocelli-lenses-001.json";
  EXPECT_EQ(cameraChoice(path.string()).gpc, saved);
  test.key(Key::kTab);
  test.key(Key::kDelete);
  EXPECT_EQ(test.lenses().size(), 1U);
  test.player.play(CameraStep{path.string()});
  EXPECT_EQ(test.viewer.state().work.camera.gpc, saved);
  test.key(Key::kTab);
  test.key(Key::kDelete);
  test.key(Key::kTab);
  test.key(Key::kDelete);
  EXPECT_TRUE(test.lenses().empty());
  test.settle();
  EXPECT_TRUE(test.viewer.facts().lenses.picture) << "the pinhole's";
  EXPECT_THROW(test.viewer.lensFile(), InputError);
}

}  // namespace
}  // namespace ocelli
