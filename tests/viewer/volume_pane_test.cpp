// Volumes in the viewer, driven as a person would.
#include <gmock/gmock.h>

#include "display_sim/viewer/transfer_pointer.h"
#include "display_sim/viewer/volume_work.h"
#include "display_sim/volume_solidity/shown_volume.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/volume/transfer_presets.h"
#include "tests/viewer/test_viewer.h"
#include "tests/viewer/transfer_state.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::countDifferent;
using test::countNear;
using test::kSmallVolume;
using test::TestViewer;
using testing::HasSubstr;

class VolumePaneTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, VolumePaneTest, kOffscreenProviders, providerName);

class VolumeViewer : public TestViewer {
 public:
  explicit VolumeViewer(GlProvider provider) : TestViewer(provider, kSmallVolume, "di") {}

  TransferFrame frame() const { return transferFrame(viewer.state(), layoutOf(Pane::kTransfer).image, 1); }
  const TransferEditor& editor() const { return *viewer.state().volume.transfer; }
  glm::dvec2 placeOf(size_t point) const {
    return frame().placeOf(editor().points()[point].value, editor().points()[point].opacity);
  }
  Image<Rgb8> picture() {
    viewer.waitForPictures();
    return viewer.volumePicture();
  }
};

TEST_P(VolumePaneTest, aVolumeHasItsOwnPanes) {
  VolumeViewer test(GetParam());
  const ViewerState& state = test.viewer.state();
  EXPECT_EQ(state.active, Pane::kVolume);
  for (const Pane pane : kPanes) {
    EXPECT_EQ(isOffered(state, pane), pane == Pane::kVolume || pane == Pane::kTransfer || pane == Pane::kDisplay)
        << titleOf(pane);
  }
  EXPECT_GT(countNear(test.paneImage(Pane::kTransfer), bytesOf(kGuiBorder), 3), 100U) << "its grid";
  const VolumePicture& picture = *test.viewer.facts().volume.picture;
  EXPECT_TRUE(picture.isWhole);
  // As `ocelli render` draws it, to the byte.
  const PinholeCamera camera(state.reconstruction.view, picture.wanted.size.x, picture.wanted.size.y);
  const VolumeImage rendered = renderVolume(camera, loadVolumeScene(kSmallVolume));
  Image<glm::vec3> colors(rendered.width(), rendered.height());
  for (size_t i = 0; i < rendered.size(); ++i) {
    colors[i] = colorBefore(glm::vec3(0), rendered[i]);
  }
  EXPECT_EQ(picture.image, srgbFromLinear(colors));
}

TEST_P(VolumePaneTest, panesOfTrianglesSayWhatTheyNeed) {
  VolumeViewer test(GetParam());
  for (const Key key : {Key::k1, Key::k2, Key::k3, Key::k5, Key::k6}) {
    test.key(key);
    test.settle();
    const Pane pane = *test.viewer.state().maximised;
    EXPECT_GT(countNear(test.paneImage(pane), bytesOf(kGuiText), 20), 200U) << "words in " << titleOf(pane);
    EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  }
  EXPECT_FALSE(test.viewer.facts().data->camera);
}

TEST_P(VolumePaneTest, aPointThatIsDraggedChangesThePicture) {
  VolumeViewer test(GetParam());
  const Image<Rgb8> before = test.picture();
  const double value = test.editor().points()[1].value;
  test.player.play(DragStep{test.placeOf(1), test.placeOf(1) + glm::dvec2(0, 40)});
  EXPECT_EQ(test.viewer.state().active, Pane::kTransfer);
  EXPECT_DOUBLE_EQ(test.editor().points()[1].value, value);
  const Image<Rgb8> after = test.picture();
  EXPECT_GT(countDifferent(before, after), before.size() / 20);
  test.key(Key::kZ, {.control = true});
  EXPECT_EQ(test.picture(), before);
  test.key(Key::kY, {.control = true});
  EXPECT_EQ(test.picture(), after);
}

TEST_P(VolumePaneTest, theDisplayShowsTheVolumeAsItIsEdited) {
  VolumeViewer test(GetParam());
  ASSERT_TRUE(test.viewer.facts().data->volume) << test.viewer.facts().message;
  const size_t before = test.viewer.facts().data->volume->litVoxels;
  EXPECT_GT(before, 1000U);
  test.player.play(ClickStep{test.placeOf(1)});
  for (int i = 0; i < 40; ++i) {
    test.key(Key::kDown);
  }
  test.settle();
  const size_t after = test.viewer.facts().data->volume->litVoxels;
  EXPECT_LT(after, before);
  // As `ocelli slice` makes it.
  VolumeScene scene = loadVolumeScene(kSmallVolume);
  scene.appearance = *test.editor().appearance();
  const DisplayProfile profile = loadProfile("test");
  const ShownVolume shown(std::move(scene), profile, {});
  VolumeSlicer slicer(profile);
  EXPECT_EQ(slicer.slice(shown.samples(), shown.light()).litVoxels(), after);
}

TEST_P(VolumePaneTest, twoClicksAddAPointAndDeleteRemovesIt) {
  VolumeViewer test(GetParam());
  const size_t count = test.editor().points().size();
  const TransferFrame frame = test.frame();
  const glm::dvec2 at = frame.corner + frame.size * glm::dvec2(0.1, 0.3);
  test.player.play(ClickStep{at});
  test.player.play(ClickStep{at});
  ASSERT_EQ(test.editor().points().size(), count + 1);
  EXPECT_EQ(test.editor().chosen(), 0U);
  EXPECT_NEAR(test.editor().points()[0].opacity, 0.7, 1e-9);
  test.settle();
  EXPECT_GT(countNear(test.paneImage(Pane::kTransfer), bytesOf(kOkabeItoYellow), 3), 20U) << "its ring";
  test.key(Key::kDelete);
  EXPECT_EQ(test.editor().points().size(), count);
}

TEST_P(VolumePaneTest, numbersOfAPointAreTyped) {
  VolumeViewer test(GetParam());
  test.player.play(ClickStep{test.placeOf(1)});
  test.key(Key::kEnter);
  test.settle();
  test.player.play(TypeStep{"0.625"});
  test.key(Key::kEnter);
  test.settle();
  EXPECT_EQ(test.editor().points()[1].value, 0.625);
  test.key(Key::kEscape);
  test.key(Key::kLeft);
  EXPECT_LT(test.editor().points()[1].value, 0.625) << "the keys are those of the pane again";
}

TEST_P(VolumePaneTest, transferFunctionsAreSavedAndLoaded) {
  VolumeViewer test(GetParam());
  test.key(Key::k8);
  test.key(Key::kTab);
  test.key(Key::kTab);
  test.key(Key::kDown);
  EXPECT_FALSE(test.editor().isSaved());
  test.key(Key::kS, {.control = true});
  EXPECT_TRUE(test.editor().isSaved());
  const auto path = test.folder.path() / "ocelli-transfer-001.json";
  const double opacity = test.editor().points()[1].opacity;
  test.player.play(TransferStep{transferPresets().front().name});
  EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  test.player.play(DropStep{path.string()});
  EXPECT_NEAR(test.editor().points()[1].opacity, opacity, 1e-8) << "files hold 9 digits";
  test.player.play(SaveTransferStep{"again.json"});
  EXPECT_EQ(readFile(test.folder.path() / "again.json"), readFile(path));
  test.player.play(TransferStep{"no-such-preset"});
  EXPECT_TRUE(test.viewer.facts().messageIsError);
}

TEST_P(VolumePaneTest, closingTellsOnceOfWhatIsNotSaved) {
  VolumeViewer test(GetParam());
  test.player.play(DragStep{test.placeOf(1), test.placeOf(1) + glm::dvec2(0, 10)});
  test.viewer.handle(CloseEvent{});
  EXPECT_FALSE(test.viewer.wantsClose());
  EXPECT_THAT(test.viewer.facts().message, HasSubstr("not saved"));
  test.viewer.handle(CloseEvent{});
  EXPECT_TRUE(test.viewer.wantsClose());
  VolumeViewer again(GetParam());
  again.player.play(DragStep{again.placeOf(1), again.placeOf(1) + glm::dvec2(0, 10)});
  again.viewer.handle(CloseEvent{});
  again.key(Key::kS, {.control = true});
  again.player.play(DragStep{again.placeOf(1), again.placeOf(1) + glm::dvec2(0, 10)});
  again.viewer.handle(CloseEvent{});
  EXPECT_FALSE(again.viewer.wantsClose()) << "what has been edited since is not saved";
  VolumeViewer unchanged(GetParam());
  unchanged.viewer.handle(CloseEvent{});
  EXPECT_TRUE(unchanged.viewer.wantsClose());
}

TEST_P(VolumePaneTest, aSurfaceGivesTheOtherPanesTriangles) {
  VolumeViewer test(GetParam());
  if (!canExtractIsosurfaces()) {
    GTEST_SKIP() << "needs OpenVDB";
  }
  test.player.play(IsoStep{0.5});
  test.settle();
  EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  ASSERT_TRUE(test.viewer.facts().data->camera);
  EXPECT_GT(test.viewer.facts().data->scene->mesh.triangles.size(), 1000U);
  EXPECT_TRUE(test.viewer.facts().data->volume) << "on the display, too";
  EXPECT_TRUE(isOffered(test.viewer.state(), Pane::kReference));
  const auto volume = test.viewer.facts().data->scene->volume;
  test.player.play(IsoStep{1e9});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().messageIsError) << "no voxel is above it";
  EXPECT_EQ(test.viewer.state().work.sceneOptions.iso, 0.5) << "what was there stays";
  test.key(Key::kEscape);
  test.player.play(IsoStep{});
  test.settle();
  EXPECT_EQ(test.viewer.facts().data->scene->volume, volume) << "the volume is not loaded again";
  EXPECT_FALSE(isOffered(test.viewer.state(), Pane::kReference));
  EXPECT_EQ(test.viewer.state().active, Pane::kVolume);
}

TEST_P(VolumePaneTest, scenesOfEitherKindFollowEachOther) {
  VolumeViewer test(GetParam());
  const Image<Rgb8> before = test.picture();
  test.player.play(OpenStep{"builtin:room"});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().data->camera);
  EXPECT_FALSE(isOffered(test.viewer.state(), Pane::kVolume));
  EXPECT_THROW(test.viewer.volumePicture(), InputError);
  test.key(Key::k7);
  test.settle();
  test.key(Key::k8);
  test.settle();
  EXPECT_FALSE(test.viewer.facts().messageIsError) << test.viewer.facts().message;
  test.player.play(OpenStep{kSmallVolume});
  test.settle();
  EXPECT_EQ(test.viewer.state().maximised, Pane::kTransfer) << "which a volume has";
  test.key(Key::k0);
  EXPECT_EQ(test.picture(), before);
  test.player.play(OpenStep{"no-such-volume.nrrd"});
  test.settle();
  EXPECT_TRUE(test.viewer.facts().messageIsError);
  EXPECT_TRUE(test.viewer.state().volume.on) << "what was there stays";
  EXPECT_EQ(test.picture(), before);
}

}  // namespace
}  // namespace ocelli
